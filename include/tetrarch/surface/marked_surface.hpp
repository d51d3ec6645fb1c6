// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A surface that is cut and refined: marks on its edges, and the history of its splits.
///
/// A mark m != 0 on a side says that the surface is cut there, as part of curve |m|; its mate has -m, so the
/// sign tells the two banks apart: a curve that runs along its sides of positive mark has them on its left.
/// Cutting takes mates away and changes nothing else, so the triangles and sides of the surface are also
/// those of its covering disks.

#include "tetrarch/surface/surface.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace tetrarch::surface {

/// A vertex added: on the edge between two vertices, or (three) inside a triangle.
struct Split {
  int vertex = 0;
  std::array<int, 3> of{-1, -1, -1}; ///< the third is -1 for an edge
};

/// One change of the triangles, so that it can be done again elsewhere.
struct Edit {
  enum class Kind : std::uint8_t { split_edge, split_face, flip_edge } kind = Kind::split_edge;
  Side side; ///< any of the triangle, for `split_face`
};

/// A surface with curves on it along which it is cut.
struct MarkedSurface {
  Surface surface;
  std::vector<std::array<double, 3>> points; ///< of each vertex, or empty for a surface without place
  std::vector<int> mark;                     ///< of each side
  std::vector<int> origin;                   ///< of each triangle, the one of the first surface it lies in
  std::vector<Split> splits;                 ///< in order; origins and splits together are the history
  std::vector<Edit> edits;                   ///< in order: what the three functions below did

  MarkedSurface() = default;
  /// Nothing marked, nothing split.
  explicit MarkedSurface(Surface s, std::vector<std::array<double, 3>> p = {});

  int operator[](Side s) const { return mark[static_cast<std::size_t>(s.value)]; }
  bool is_cut(Side s) const { return (*this)[s] != 0; }
};

/// Marks side s with m and its mate with -m; 0 takes the mark away. A boundary side cannot be marked:
/// `PreconditionError`. O(1).
void set_mark(MarkedSurface& surface, Side s, int m);

/// As `Surface::split_edge`; both halves of a side inherit its mark; the new vertex lies in the middle. O(1).
int split_edge(MarkedSurface& surface, Side s);
/// As `Surface::split_face`; the new vertex is the center. O(1).
int split_face(MarkedSurface& surface, int triangle);

/// Does `edit` to a surface whose triangles have other numbers, `name`, and adds the names of new triangles,
/// which go to the end. O(1).
void repeat(MarkedSurface& surface, const Edit& edit, std::vector<int>& name);

/// Turns the triangles of sign -1 over: corners 1 and 2 are exchanged, and so are sides 1 and 2. O(n).
void turn_triangles(MarkedSurface& surface, const std::vector<int>& sign);

/// As `Surface::flip_edge`; the edge must not be marked.
void flip_edge(MarkedSurface& surface, Side s);

/// The surface cut open along all marked edges: the triangles and sides stay the same, and the cut splits
/// vertices into copies. O(n).
Surface cut_open(const MarkedSurface& surface);

} // namespace tetrarch::surface
