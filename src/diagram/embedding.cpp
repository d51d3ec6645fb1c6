// SPDX-License-Identifier: GPL-2.0-or-later
/// The embedding format.
#include "readers.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tetrarch::diagram {
namespace {

/// A vertex as its list has it; places are counted from 0.
struct Listed {
  int name = 0;
  std::vector<int> neighbors;
  std::optional<int> bit; ///< said by a word
};

int nonnegative(CodeText& text, std::string_view expected) {
  if (text.next() == '-') text.fail_expected(expected);
  return text.integer(expected);
}

Listed read_vertex(CodeText& text) {
  Listed vertex;
  vertex.name = nonnegative(text, "the number of a vertex, or '}'");
  text.close(':');
  const std::string word = text.word();
  if (word == "o" || word == "odd")
    vertex.bit = 0;
  else if (word == "e" || word == "even")
    vertex.bit = 1;
  else if (!word.empty())
    text.fail("found " + in_quotes(word) + " (expected 'odd', 'even' or a list of neighbors)");
  const char end = text.open("a list of neighbors in parentheses");
  do vertex.neighbors.push_back(nonnegative(text, "the number of a neighbor"));
  while (text.take(','));
  text.close(end);
  return vertex;
}

std::vector<Listed> read_vertices(CodeText& text) {
  std::vector<Listed> list;
  while (!text.take('}')) {
    list.push_back(read_vertex(text));
    if (!text.take(',') && text.next() != '}') text.fail_expected("',' or '}'");
  }
  if (list.empty()) text.fail("there are no vertices");
  if (!text.at_end()) text.fail_expected("the end");
  return list;
}

/// Places of one neighbor in a cyclic list, from the first of a block on.
std::vector<int> places_among(const std::vector<int>& neighbors, int neighbor) {
  const int count = static_cast<int>(neighbors.size());
  int first = 0;
  for (int k = 0; k < count; ++k)
    if (neighbors[k] == neighbor && neighbors[(k + count - 1) % count] != neighbor) first = k;
  std::vector<int> places;
  for (int k = 0; k < count; ++k)
    if (neighbors[(first + k) % count] == neighbor) places.push_back((first + k) % count);
  return places;
}

class EmbeddingBuilder {
public:
  EmbeddingBuilder(std::vector<Listed> list, CodeText& text) : list_(std::move(list)), text_(text) {
    for (std::size_t n = 0; n < list_.size(); ++n)
      if (!number_.emplace(list_[n].name, static_cast<int>(n)).second)
        text.fail("vertex " + std::to_string(list_[n].name) + " is listed twice");
  }

  /// `choice` has a bit for each vertex of valence 4.
  Draft run(int choice, bool clockwise) {
    for (const Listed& v : list_) {
      const bool crossing = v.neighbors.size() == 4;
      first_.push_back(draft_.add_node(static_cast<int>(v.neighbors.size()), crossing, 0));
      if (!crossing) continue;
      draft_.nodes.back().over = v.bit ? *v.bit : choice & 1;
      choice >>= 1;
    }
    if (choice != 0) text_.fail("the choice has more bits than there are crossings");
    for (int n = 0; n < static_cast<int>(list_.size()); ++n) join_all(n);
    pair_otherwise();
    if (clockwise)
      for (Node& node : draft_.nodes) std::reverse(node.darts.begin() + 1, node.darts.end());
    return std::move(draft_);
  }

private:
  void join_all(int n) {
    std::set<int> met;
    for (const int name : list_[n].neighbors) {
      const auto found = number_.find(name);
      if (found == number_.end())
        text_.fail("vertex " + std::to_string(list_[n].name) + " lists " + std::to_string(name) +
                   ", which is no vertex");
      const int m = found->second;
      if (met.insert(m).second) join_two(n, m);
    }
  }

  void join_two(int n, int m) {
    const std::vector<int> here = places_among(list_[n].neighbors, list_[m].name);
    const std::vector<int> there = places_among(list_[m].neighbors, list_[n].name);
    if (here.size() != there.size())
      text_.fail("vertex " + std::to_string(list_[n].name) + " lists " + std::to_string(list_[m].name) + " " +
                 std::to_string(here.size()) + " times, and is listed by it " + std::to_string(there.size()) +
                 " times");
    if (m < n) return;
    if (m == n) {
      if (here.size() % 2 != 0)
        text_.fail("vertex " + std::to_string(list_[n].name) + " lists itself " +
                   std::to_string(here.size()) + " times: a loop has two ends");
      for (std::size_t k = 0; k < here.size(); k += 2)
        draft_.join(first_[n] + here[k], first_[n] + here[k + 1]);
      return;
    }
    Bundle bundle;
    for (const int k : here) bundle.here.push_back(first_[n] + k);
    for (const int k : there) bundle.there.push_back(first_[m] + k);
    join(bundle, 0);
    if (here.size() > 1) bundles_.push_back(std::move(bundle));
  }

  /// Parallel arcs: their darts in the order of places.
  struct Bundle {
    std::vector<int> here;
    std::vector<int> there;
  };

  void join(const Bundle& bundle, std::size_t turn) {
    const std::size_t count = bundle.here.size();
    for (std::size_t k = 0; k < count; ++k)
      draft_.join(bundle.here[k], bundle.there[(2 * count - 1 - k - turn) % count]);
  }

  /// Parallel arcs that do not lie side by side can begin anywhere; the first way that is plane is taken. If
  /// none is, the first way of all stays.
  void pair_otherwise() {
    constexpr std::size_t most_work = 20'000'000; // darts looked at: a second
    constexpr std::size_t most_ways = 4096;
    const auto ways = static_cast<int>(std::min(most_ways, most_work / draft_.opposite.size()));
    for (int way = 0; way < ways; ++way) {
      int rest = way;
      for (const Bundle& bundle : bundles_) {
        const int count = static_cast<int>(bundle.here.size());
        join(bundle, static_cast<std::size_t>(rest % count));
        rest /= count;
      }
      if (rest > 0) break;
      if (why_not(draft_.nodes, draft_.opposite).empty()) return;
    }
    for (const Bundle& bundle : bundles_) join(bundle, 0);
  }

  std::vector<Listed> list_;
  CodeText& text_;
  std::map<int, int> number_;
  Draft draft_;
  std::vector<int> first_; ///< of each vertex, its first dart
  std::vector<Bundle> bundles_;
};

} // namespace

Draft read_embedding(CodeText& text) {
  int choice = 0;
  if (text.at_integer()) choice = nonnegative(text, "the choice of crossings");
  const bool clockwise = text.take('-');
  if (!text.take('{')) text.fail_expected("'{' or '-{'");
  return EmbeddingBuilder(read_vertices(text), text).run(choice, clockwise);
}

} // namespace tetrarch::diagram
