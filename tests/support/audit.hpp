// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Is what a Complex keeps up while it changes what a Skeleton finds from nothing?

#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/moves/complex.hpp"

#include <map>
#include <string>

namespace tetrarch::support {

namespace detail {

inline moves::LinkKind kind_of(const SurfaceType& link) {
  if (link.is_sphere()) return moves::LinkKind::sphere;
  if (link.is_disk()) return moves::LinkKind::disk;
  return link.is_closed() ? moves::LinkKind::closed : moves::LinkKind::bad;
}

/// Whether two names always come together.
template <class A, class B>
bool pair_up(std::map<A, B>& there, std::map<B, A>& back, A a, B b) {
  return there.emplace(a, b).first->second == b && back.emplace(b, a).first->second == a;
}

} // namespace detail

/// Empty where all agrees, else a sentence. Counts, classes of vertices and edges, valences, degrees,
/// boundary flags, reversed edges, kinds of links. O(n log n).
inline std::string disagreement(const moves::Complex& complex) {
  const moves::Complex::Compact compact = complex.compact();
  const Skeleton skeleton(compact.tri);
  if (complex.vertex_count() != skeleton.vertex_count()) return "the numbers of vertices differ";
  if (complex.edge_count() != skeleton.edge_count()) return "the numbers of edges differ";
  if (complex.boundary_face_count() != skeleton.boundary_face_count()) return "the boundary faces differ";
  std::map<VertexId, VertexId> vertex;
  std::map<VertexId, VertexId> vertex_back;
  std::map<EdgeId, EdgeId> edge;
  std::map<EdgeId, EdgeId> edge_back;
  for (int slot = 0; slot < complex.slot_count(); ++slot) {
    if (!complex.is_alive(slot)) continue;
    const int t = compact.image[static_cast<std::size_t>(slot)];
    const std::string where = " at tetrahedron " + std::to_string(slot) + ", local number ";
    for (int v = 0; v < 4; ++v) {
      const VertexId mine = complex.vertex({slot, v});
      const VertexId theirs = skeleton.vertex({t, v});
      if (!detail::pair_up(vertex, vertex_back, mine, theirs))
        return "the vertex classes differ" + where + std::to_string(v);
      if (complex.degree(mine) != static_cast<int>(skeleton.preimages(theirs).size()))
        return "a degree differs" + where + std::to_string(v);
      // The link of a vertex on a reversed edge is no surface; what it is called does not matter.
      bool surface = true;
      for (int e = 0; e < 6; ++e) surface = surface && !skeleton.is_reversed(skeleton.edge({t, e}));
      if (surface && complex.link(mine) != detail::kind_of(skeleton.link(theirs)))
        return "the kind of a link differs" + where + std::to_string(v);
    }
    for (int e = 0; e < 6; ++e) {
      const EdgeId mine = complex.edge(TetEdge{slot, e});
      const EdgeId theirs = skeleton.edge({t, e});
      if (!detail::pair_up(edge, edge_back, mine, theirs))
        return "the edge classes differ" + where + std::to_string(e);
      if (complex.is_reversed(mine) != skeleton.is_reversed(theirs))
        return "a reversed edge is not seen" + where + std::to_string(e);
      // A Skeleton walks along a reversed edge twice, once each way.
      const int walked = complex.is_reversed(mine) ? 2 * complex.valence(mine) : complex.valence(mine);
      if (walked != skeleton.valence(theirs) && complex.valence(mine) != skeleton.valence(theirs))
        return "a valence differs" + where + std::to_string(e);
      if (complex.is_boundary(mine) != skeleton.is_boundary(theirs))
        return "the boundary is not seen" + where + std::to_string(e);
    }
  }
  return "";
}

} // namespace tetrarch::support
