// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/merge.hpp"

#include "boundary_walk.hpp"
#include "flatten.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace tetrarch::moves {
namespace {

MaybeObstacle why_not_ends(const Complex& complex, DirectedTetEdge e, bool on_boundary) {
  const VertexId from = complex.vertex({e.tet, e.from});
  const VertexId to = complex.vertex({e.tet, e.to});
  if (from == to) return Obstacle::same_ends;
  const LinkKind a = complex.link(from);
  const LinkKind b = complex.link(to);
  if (a == LinkKind::sphere || b == LinkKind::sphere) return std::nullopt;
  if (a == LinkKind::bad || b == LinkKind::bad) return Obstacle::bad_vertex;
  if (on_boundary && a == LinkKind::disk && b == LinkKind::disk) return std::nullopt;
  return Obstacle::both_ends_on_boundary;
}

bool contains_twice(const Ring& ring) {
  constexpr std::size_t few = 64;
  if (ring.size() > few) {
    std::vector<int> tets;
    tets.reserve(ring.size());
    for (const Walk& w : ring) tets.push_back(w.tet);
    std::sort(tets.begin(), tets.end());
    return std::adjacent_find(tets.begin(), tets.end()) != tets.end();
  }
  std::uint64_t bits = 0;
  for (auto w = ring.begin(); w != ring.end(); ++w) {
    const auto is_same = [tet = w->tet](const Walk& earlier) { return earlier.tet == tet; };
    if ((bits & last_bits(w->tet)) != 0 && std::any_of(ring.begin(), w, is_same)) return true;
    bits |= last_bits(w->tet);
  }
  return false;
}

/// The kind of a vertex into which two are merged of which one is a sphere, or both are disks.
LinkKind merged_link(const Complex& complex, VertexId a, VertexId b) {
  return complex.link(a) == LinkKind::sphere ? complex.link(b) : complex.link(a);
}

/// Everything about a merge that is decided before it is made.
MaybeObstacle plan_merge(const Complex& complex, DirectedTetEdge e, Flattening& flat) {
  const EdgeId edge = complex.edge(e);
  if (complex.is_reversed(edge)) return Obstacle::reversed_edge;
  const bool on_boundary = complex.is_boundary(edge);
  if (const auto obstacle = why_not_ends(complex, e, on_boundary)) return obstacle;
  const Ring ring = complex.around(e);
  if (contains_twice(ring)) return Obstacle::repeated_tetrahedron;
  if (on_boundary && are_whole_component(complex, ring.front().right_face(), ring.back().left_face()))
    return Obstacle::small_boundary_component;
  for (const Walk& w : ring) {
    const auto [from, to, left, right] = std::array{w.hold[0], w.hold[1], w.hold[2], w.hold[3]};
    (void)left;
    flat.tets.push_back(w.tet);
    flat.faces.push_back({{w.tet, from}, {w.tet, to}, Perm4::swap(from, to)});
    flat.edges.push_back(
        {complex.edge(DirectedTetEdge{w.tet, from, right}), complex.edge(DirectedTetEdge{w.tet, to, right})});
  }
  if (!on_boundary) return why_not_flatten(complex, flat);
  // The two boundary triangles are no obstacle but take part in the merge: the right one of the first
  // tetrahedron, which stands first in the list, and the left one of the last.
  const Flattening::EdgePair first = flat.edges.front();
  flat.edges.erase(flat.edges.begin());
  if (const auto obstacle = why_not_flatten(complex, flat)) return obstacle;
  const Walk& last = ring.back();
  flat.edges.push_back(first);
  flat.edges.push_back({complex.edge(DirectedTetEdge{last.tet, last.hold[0], last.hold[2]}),
                        complex.edge(DirectedTetEdge{last.tet, last.hold[1], last.hold[2]})});
  return std::nullopt;
}

} // namespace

MaybeObstacle why_not_merge(const Complex& complex, DirectedTetEdge e) {
  Flattening flat;
  return plan_merge(complex, e, flat);
}

MaybeObstacle merge(Complex& complex, DirectedTetEdge e) {
  Flattening flat;
  if (const auto obstacle = plan_merge(complex, e, flat)) return obstacle;
  const EdgeId edge = complex.edge(e);
  const VertexId from = complex.vertex({e.tet, e.from});
  const VertexId to = complex.vertex({e.tet, e.to});
  const LinkKind link = merged_link(complex, from, to);
  complex.begin_change();
  flatten(complex, flat);
  complex.remove_edge(edge);
  complex.merge_vertices(from, to, link);
  return std::nullopt;
}

MaybeObstacle why_not_pinch(const Complex& complex, DirectedTetEdge e) {
  if (complex.is_reversed(complex.edge(e))) return Obstacle::reversed_edge;
  const VertexId from = complex.vertex({e.tet, e.from});
  const VertexId to = complex.vertex({e.tet, e.to});
  if (from == to) return Obstacle::same_ends;
  if (complex.link(from) != LinkKind::sphere && complex.link(to) != LinkKind::sphere)
    return Obstacle::both_ends_on_boundary;
  if (complex.is_boundary(Walk{e.tet, edge_frame(e.from, e.to)}.left_face())) return Obstacle::boundary_face;
  return std::nullopt;
}

MaybeObstacle pinch(Complex& complex, DirectedTetEdge e) {
  if (const auto obstacle = why_not_pinch(complex, e)) return obstacle;
  complex.begin_change();
  const Walk near{e.tet, edge_frame(e.from, e.to)};
  const Gluing g = complex.gluing(near.left_face());
  const auto [from, to, third, off] = std::array{near.hold[0], near.hold[1], near.hold[2], near.hold[3]};
  const VertexId v1 = complex.vertex({e.tet, from});
  const VertexId v2 = complex.vertex({e.tet, to});
  const LinkKind link = merged_link(complex, v1, v2);
  const VertexId x = complex.vertex({e.tet, third});
  const EdgeId pinched = complex.edge(e);
  const EdgeId a = complex.edge(DirectedTetEdge{e.tet, from, third});
  const EdgeId b = complex.edge(DirectedTetEdge{e.tet, to, third});
  complex.unglue({e.tet, off});
  complex.merge_vertices(v1, v2, link);
  const VertexId v = complex.current(v1);
  const VertexId tip = complex.current(x);
  // `between` has the corners v1, v2, x, v2: its faces 012 and 032 take the place of the triangle. `fold` is
  // folded around its edge 12 and closes the other two.
  const int between = complex.add_tet({v, v, tip, v}, {pinched, a, pinched, b, pinched, b});
  const int fold =
      complex.add_tet({v, v, tip, v}, {pinched, b, pinched, complex.add_edge(false), pinched, b});
  complex.glue({fold, 0}, fold, Perm4(3, 1, 2, 0));
  complex.glue({between, 0}, fold, Perm4(1, 0, 2, 3));
  complex.glue({between, 2}, fold, Perm4(0, 3, 2, 1));
  const Perm4 first = near.hold;                      // corner i of `between` on its face 012
  const Perm4 second = near.hold * Perm4(0, 3, 2, 1); // and on its face 032
  complex.glue({between, 3}, e.tet, first);
  complex.glue({between, 1}, g.tet, g.perm * second);
  return std::nullopt;
}

MergeSets merge_sets(const Complex& complex, DirectedTetEdge e) {
  const VertexId v1 = complex.vertex({e.tet, e.to});
  const VertexId v2 = complex.vertex({e.tet, e.from});
  MergeSets sets;
  for (const Walk& w : complex.around(e)) sets.deleted.push_back(w.tet);
  std::sort(sets.deleted.begin(), sets.deleted.end());
  const auto is_deleted = [&sets](int t) {
    return std::binary_search(sets.deleted.begin(), sets.deleted.end(), t);
  };
  const auto meets = [&complex](int t, VertexId v) {
    for (int k = 0; k < 4; ++k)
      if (complex.vertex({t, k}) == v) return true;
    return false;
  };
  const auto touches_deleted = [&](int t) {
    for (int f = 0; f < 4; ++f)
      if (!complex.is_boundary({t, f}) && is_deleted(complex.partner({t, f}).tet)) return true;
    return false;
  };
  // The star of v2, from the corner of the edge there; what it touches is all of T_III and T_IV.
  std::set<std::pair<int, int>> seen{{e.tet, e.from}};
  std::vector<TetVertex> pending{{e.tet, e.from}};
  std::set<int> star;
  while (!pending.empty()) {
    const TetVertex at = pending.back();
    pending.pop_back();
    star.insert(at.tet);
    for (int f = 0; f < 4; ++f) {
      const Gluing g = complex.gluing({at.tet, f});
      if (f == at.vertex || g.tet < 0 || !seen.emplace(g.tet, g.perm[at.vertex]).second) continue;
      pending.push_back({g.tet, g.perm[at.vertex]});
    }
  }
  for (const int t : star) {
    if (is_deleted(t) || meets(t, v1)) continue;
    (touches_deleted(t) ? sets.deformed_at_faces : sets.deformed_at_vertices).push_back(t);
  }
  std::set<int> hosting;
  for (const int t : sets.deleted)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = complex.gluing({t, f});
      if (g.tet >= 0 && !is_deleted(g.tet) && meets(g.tet, v1) && !meets(g.tet, v2)) hosting.insert(g.tet);
    }
  sets.hosting.assign(hosting.begin(), hosting.end());
  return sets;
}

} // namespace tetrarch::moves
