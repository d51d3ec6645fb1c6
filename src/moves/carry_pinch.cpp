// SPDX-License-Identifier: GPL-2.0-or-later
#include "carry_pinch.hpp"

#include "tetrarch/moves/merge.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace tetrarch::moves {
namespace {

/// A crossing seen from one side.
struct NewCrossing {
  int tet;
  int vertex;
  int face;
  auto key() const { return std::tie(tet, vertex, face); }
  bool operator<(const NewCrossing& other) const { return key() < other.key(); }
};

/// Finds the words of all crossings of some new tetrahedra: empty along a tree that joins them to what is
/// known, and then what goes once round an edge leaves no choice.
class Filling {
public:
  Filling(const Complex& complex, Monodromy& monodromy, const std::vector<int>& fresh)
      : complex_(complex), monodromy_(monodromy), fresh_(fresh) {
    for (const int t : fresh)
      for (int f = 0; f < 4; ++f)
        for (const int v : face_vertex[f]) {
          unknown_.insert({t, v, f});
          unknown_.insert(back({t, v, f}));
        }
  }

  bool run() {
    set_tree();
    bool more = true;
    while (more && !unknown_.empty()) {
      more = false;
      for (const int t : fresh_)
        for (int e = 0; e < 6; ++e) {
          const auto [a, b] = edge_vertex[e];
          for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
            more |= close(Walk{t, edge_frame(from, to)});
        }
    }
    return unknown_.empty();
  }

private:
  NewCrossing back(const NewCrossing& c) const {
    const Gluing g = complex_.gluing(TetFace{c.tet, c.face});
    return {g.tet, g.perm[c.vertex], g.perm[c.face]};
  }

  void set(const NewCrossing& c, const FreeWord& word) {
    const NewCrossing there = back(c);
    monodromy_.at(c.tet, c.vertex, c.face) = word;
    monodromy_.at(there.tet, there.vertex, there.face) = inverse(word);
    unknown_.erase(c);
    unknown_.erase(there);
  }

  void set_tree() {
    std::vector<int> parent(4 * static_cast<std::size_t>(complex_.slot_count()));
    std::iota(parent.begin(), parent.end(), 0);
    const auto join = [&](const NewCrossing& c) {
      const NewCrossing there = back(c);
      const int a = numeric::find_root(parent, 4 * c.tet + c.vertex);
      const int b = numeric::find_root(parent, 4 * there.tet + there.vertex);
      parent[static_cast<std::size_t>(a)] = b;
      return a != b;
    };
    for (int t = 0; t < complex_.slot_count(); ++t)
      for (int f = 0; complex_.is_alive(t) && f < 4; ++f)
        for (const int v : face_vertex[f])
          if (unknown_.count({t, v, f}) == 0) join({t, v, f});
    for (const NewCrossing& c : std::vector<NewCrossing>(unknown_.begin(), unknown_.end()))
      if (join(c)) set(c, {});
  }

  /// Once round the edge near where the walk starts from: true if this tells the word of one crossing.
  bool close(const Walk& start) {
    FreeWord before;
    FreeWord after;
    std::optional<NewCrossing> open;
    Walk w = start;
    do {
      const NewCrossing c{w.tet, w.from(), w.left_face().face};
      if (unknown_.count(c) > 0) {
        if (open) return false;
        open = c;
      } else {
        FreeWord& word = open ? after : before;
        word = product(word, monodromy_.at(c.tet, c.vertex, c.face));
      }
    } while (w.step_left(complex_) && !(w == start));
    if (!open) return false;
    set(*open, product(inverse(before), inverse(after)));
    return true;
  }

  const Complex& complex_;
  Monodromy& monodromy_;
  const std::vector<int>& fresh_;
  std::set<NewCrossing> unknown_;
};

} // namespace

bool carry_pinch(Complex& complex, Monodromy& monodromy, DirectedTetEdge e) {
  Complex trial = complex;
  if (pinch(trial, e)) return false;
  Monodromy words = monodromy;
  words.resize(std::max(words.size(), trial.slot_count()));
  const std::vector<int> fresh = trial.last_change().new_tets;
  for (const int t : fresh) {
    words.clear(t);
    // The first is glued to a tetrahedron of before, the second to the first.
    for (int f = 0; f < 4; ++f) {
      const Gluing g = trial.gluing(TetFace{t, f});
      const bool is_known = g.tet == fresh.front() ? t != g.tet : g.tet != t && g.tet != fresh.back();
      if (is_known) words.set_hand(t, -g.perm.sign() * words.hand(g.tet));
    }
  }
  if (!Filling(trial, words, fresh).run()) return false;
  complex = std::move(trial);
  monodromy = std::move(words);
  return true;
}

} // namespace tetrarch::moves
