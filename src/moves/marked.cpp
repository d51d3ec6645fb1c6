// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/marked.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>

namespace tetrarch::moves {
namespace {

bool is_served(MoveKind kind) {
  return kind == MoveKind::merge || kind == MoveKind::two_three || kind == MoveKind::three_two ||
         kind == MoveKind::four_four || kind == MoveKind::two_zero_edge || kind == MoveKind::two_one;
}

/// A move that removes tetrahedra at an edge of that valence.
bool shrink_at(MarkedComplex& marked, int t) {
  for (int e = 0; e < 6; ++e) {
    const EdgeId edge = marked.complex().edge(TetEdge{t, e});
    const auto [a, b] = edge_vertex[e];
    const int valence = marked.complex().valence(edge);
    if (valence == 3 && marked.apply({MoveKind::three_two, t, a, b})) return true;
    if (valence == 2 && marked.apply({MoveKind::two_zero_edge, t, a, b})) return true;
    if (valence == 1 &&
        (marked.apply({MoveKind::two_one, t, a, b}) || marked.apply({MoveKind::two_one, t, b, a})))
      return true;
  }
  for (int e = 0; e < 6; ++e) {
    const auto [a, b] = edge_vertex[e];
    if (marked.apply({MoveKind::merge, t, a, b}) || marked.apply({MoveKind::merge, t, b, a})) return true;
  }
  return false;
}

} // namespace

MarkedComplex::MarkedComplex(const Triangulation& tri, const Skeleton& skeleton, const EdgeOrders& orders)
    : complex_(tri) {
  skeleton.require_current(tri);
  if (orders.size() != skeleton.edge_count())
    throw PreconditionError("MarkedComplex: needs one order per edge class");
  for (int t = 0; t < tri.size(); ++t)
    for (int e = 0; e < 6; ++e) {
      const auto id = static_cast<std::size_t>(complex_.edge(TetEdge{t, e}).value);
      if (id >= order_.size()) order_.resize(id + 1, 1.0);
      order_[id] = orders[skeleton.edge({t, e})];
    }
}

/// Whether the edge of a merge may shrink, marks considered.
bool MarkedComplex::may_shrink(const Move& move) const {
  const EdgeId shrinking = complex_.edge(move.edge());
  const VertexId from = complex_.vertex({move.tet, move.a});
  const VertexId to = complex_.vertex({move.tet, move.b});
  // The orders of the marked edge ends at both: each class once for each of its ends there.
  std::array<std::vector<double>, 2> at;
  std::vector<EdgeId> seen;
  for (int t = 0; t < complex_.slot_count(); ++t) {
    if (!complex_.is_alive(t)) continue;
    for (int e = 0; e < 6; ++e) {
      const EdgeId edge = complex_.edge(TetEdge{t, e});
      if (order(edge) == 1 || std::find(seen.begin(), seen.end(), edge) != seen.end()) continue;
      seen.push_back(edge);
      for (const int v : edge_vertex[e]) {
        if (complex_.vertex({t, v}) == from) at[0].push_back(order(edge));
        if (complex_.vertex({t, v}) == to) at[1].push_back(order(edge));
      }
    }
  }
  const auto is_point = [this](VertexId v) { return complex_.link(v) == LinkKind::sphere; };
  if (order(shrinking) == 1) return (is_point(from) && at[0].empty()) || (is_point(to) && at[1].empty());
  const auto is_passed = [&](VertexId v, const std::vector<double>& orders) {
    return is_point(v) && orders.size() == 2 && orders[0] == orders[1];
  };
  return is_passed(from, at[0]) || is_passed(to, at[1]);
}

/// Follows the classes through a move that was made; false if two marks met. A class that was merged may have
/// been merged on: each order goes to where its class is at the end, one after the other.
bool MarkedComplex::carry(const Change& change) {
  for (const EdgeId e : change.new_edges) {
    const auto id = static_cast<std::size_t>(e.value);
    if (id >= order_.size()) order_.resize(id + 1, 1.0);
    order_[id] = 1;
  }
  for (const auto& [gone, kept] : change.merged_edges) {
    const double lost = order(gone);
    if (lost == 1) continue;
    double& found = order_[static_cast<std::size_t>(complex_.current(kept).value)];
    if (found != 1) return false;
    found = lost;
  }
  return true;
}

bool MarkedComplex::apply(const Move& move) {
  if (!is_served(move.kind) || why_not_apply(complex_, move)) return false;
  if (move.kind != MoveKind::two_three) {
    const bool may_leave =
        move.kind == MoveKind::merge ? may_shrink(move) : order(complex_.edge(move.edge())) == 1;
    if (!may_leave) return false;
  }
  MarkedComplex trial = *this;
  if (moves::apply(trial.complex_, move) || !trial.carry(trial.complex_.last_change())) return false;
  *this = std::move(trial);
  return true;
}

MarkedTriangulation MarkedComplex::compact() const {
  const Complex::Compact packed = complex_.compact();
  MarkedTriangulation out{packed.tri, {}};
  std::vector<bool> told(order_.size(), false);
  for (int slot = 0; slot < complex_.slot_count(); ++slot) {
    if (!complex_.is_alive(slot)) continue;
    for (int e = 0; e < 6; ++e) {
      const EdgeId edge = complex_.edge(TetEdge{slot, e});
      const auto id = static_cast<std::size_t>(edge.value);
      if (order(edge) == 1 || told[id]) continue;
      told[id] = true;
      out.marks.push_back({{packed.image[slot], e}, order(edge)});
    }
  }
  return out;
}

void reduce(MarkedComplex& marked, const Progress& progress) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int t = 0; t < marked.complex().slot_count(); ++t) {
      if (!marked.complex().is_alive(t)) continue;
      progress.step("simplifying");
      while (marked.complex().is_alive(t) && marked.size() > 1 && shrink_at(marked, t)) changed = true;
    }
  }
}

void shake(MarkedComplex& marked, int count, SplitMix64& random) {
  for (int k = 0; k < count && marked.size() > 0; ++k) {
    int t = random.below(marked.complex().slot_count());
    while (!marked.complex().is_alive(t)) t = (t + 1) % marked.complex().slot_count();
    Move move{MoveKind::two_three, t, random.below(4)};
    if (random.below(2) == 0) {
      const auto [a, b] = edge_vertex[random.below(6)];
      move = {MoveKind::four_four, t, a, b, random.below(2)};
    }
    (void)marked.apply(move);
  }
}

} // namespace tetrarch::moves
