// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/pair.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace tetrarch::canonical {
namespace {

using moves::FreeWord;
using moves::inverse;
using moves::product;

/// An edge of the graph that is folded, with a positive letter and the word that rides along.
struct Edge {
  int from;
  int letter;
  int to;
  FreeWord word;
};

class Folding {
public:
  explicit Folding(const std::vector<std::pair<FreeWord, FreeWord>>& pairs) {
    add_node(); // where all loops start
    for (const auto& [first, second] : pairs) add_loop(first, second);
  }

  /// All is folded, whether words agree or not: the words in which they differ.
  std::vector<FreeWord> differences() && {
    stops_ = false;
    while (fold_once()) {
    }
    return std::move(differences_);
  }

  Correspondence::Answer run() {
    while (fold_once()) {
    }
    Correspondence::Answer out;
    out.exists = consistent_;
    std::set<int> letters;
    std::map<int, FreeWord> images;
    for (const Edge& e : edges_) {
      letters.insert(e.letter);
      if (e.from == 0 && e.to == 0) images.emplace(e.letter, e.word);
    }
    out.generates = consistent_ && images.size() == letters.size();
    if (out.generates) out.images.assign(images.begin(), images.end());
    return out;
  }

private:
  int add_node() { return nodes_++; }

  void add_loop(const FreeWord& first, const FreeWord& second) {
    if (first.empty()) {
      note(second);
      return;
    }
    int at = 0;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const bool last = k + 1 == first.size();
      const int next = last ? 0 : add_node();
      const FreeWord word = last ? second : FreeWord();
      if (first[k] > 0)
        edges_.push_back({at, first[k], next, word});
      else
        edges_.push_back({next, -first[k], at, inverse(word)});
      at = next;
    }
  }

  /// Node b becomes node a; words of edges out of b get `gauge` in front, those into b its inverse behind.
  void identify(int a, int b, const FreeWord& gauge) {
    const FreeWord back = inverse(gauge);
    for (Edge& e : edges_) {
      if (e.from == b) {
        e.word = product(gauge, e.word);
        e.from = a;
      }
      if (e.to == b) {
        e.word = product(e.word, back);
        e.to = a;
      }
    }
  }

  /// Folds two edges that leave, or enter, one node with one letter; false if there are none, or if they
  /// disagree. The node where loops start keeps its gauge.
  bool fold_once() {
    if (!consistent_ && stops_) return false;
    std::map<std::pair<int, int>, std::size_t> out;
    std::map<std::pair<int, int>, std::size_t> in;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const auto [leaves, first_out] = out.emplace(std::pair{edges_[k].from, edges_[k].letter}, k);
      if (!first_out) return fold(leaves->second, k, true);
      const auto [enters, first_in] = in.emplace(std::pair{edges_[k].to, edges_[k].letter}, k);
      if (!first_in) return fold(enters->second, k, false);
    }
    return false;
  }

  bool fold(std::size_t k, std::size_t l, bool common_start) {
    const Edge one = edges_[k];
    const Edge two = edges_[l];
    const int end_of_one = common_start ? one.to : one.from;
    const int end_of_two = common_start ? two.to : two.from;
    edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(l));
    if (end_of_one == end_of_two) {
      note(product(one.word, inverse(two.word)));
      return consistent_ || !stops_;
    }
    const bool keeps_two = end_of_two == 0;
    const FreeWord& kept = keeps_two ? two.word : one.word;
    const FreeWord& changed = keeps_two ? one.word : two.word;
    identify(keeps_two ? end_of_two : end_of_one, keeps_two ? end_of_one : end_of_two,
             common_start ? product(inverse(kept), changed) : product(kept, inverse(changed)));
    return true;
  }

  /// A word that should be empty.
  void note(FreeWord word) {
    if (word.empty()) return;
    consistent_ = false;
    differences_.push_back(std::move(word));
  }

  int nodes_ = 0;
  std::vector<Edge> edges_;
  bool consistent_ = true;
  bool stops_ = true; ///< at the first difference
  std::vector<FreeWord> differences_;
};

} // namespace

void Correspondence::add(FreeWord first, FreeWord second) {
  pairs_.emplace_back(std::move(first), std::move(second));
}

Correspondence::Answer Correspondence::answer() const {
  return Folding(pairs_).run();
}

std::vector<FreeWord> Correspondence::kernel() const {
  return Folding(pairs_).differences();
}

} // namespace tetrarch::canonical
