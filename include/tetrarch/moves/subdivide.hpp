// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// More tetrahedra, the same manifold; and real boundary in place of truncated vertices.
///
/// All pieces are named by the vertices of the tetrahedron they lie in, so that a gluing of the input carries
/// over to its pieces by its own permutation. They are defined for every gluing, with boundary or without,
/// orientable or not, in several components, valid or not.
///
///     1-4           piece (t, v): vertex v of tetrahedron t replaced by the center
///     barycentric   piece (t, p), one for each permutation: vertex k is the barycenter of the vertices
///                   p[0], ..., p[k], so vertex 0 is a vertex of t and vertex 3 the center of t
///
/// A finite model truncates the ideal vertices and cones the rest. Draw a truncated tetrahedron with the
/// center of each hexagon joined to the hexagon's corners, and the center of all joined to everything on the
/// surface. With a, b, d the vertices of face f (which lies opposite vertex f), and ab the point where the
/// truncation at a cuts the edge to b (a itself where a is not truncated), the pieces are
///
///     side (f, d)     on the side from ab to ba of face f: ab, ba, center of the face, center of all
///     corner (f, a)   where a is truncated, on the side from ab to ad: ab, ad, and the same two centers
///     cut (a)         where a is truncated, on the truncation triangle: ab, ad, af, center of all
///
/// that is, 12 + 4k pieces of a tetrahedron with k truncated vertices: 28 where all are. (The textbook's
/// model is the second barycentric subdivision without what touches an ideal vertex, 432 pieces where all
/// four are; of the first nothing would be left, as each of its pieces touches a vertex.) Source: barycentric
/// subdivision is textbook matter; the truncated tetrahedron is that of Yin, section 4.2.1.

#include "tetrarch/core/triangulation.hpp"

#include <vector>

namespace tetrarch::moves {

struct Subdivision {
  Triangulation tri;
  std::vector<int> origin; ///< the tetrahedron that each piece lies in
};

/// Piece (t, v) is tetrahedron 4t + v; its vertex v is the center, the others are those of t. O(n).
[[nodiscard]] Subdivision subdivided_1_4(const Triangulation& tri);

/// The same for the listed tetrahedra only; the others stay whole. Pieces are in the order of `origin`.
/// Throws PreconditionError if a tetrahedron is out of range or listed twice. O(n).
[[nodiscard]] Subdivision subdivided_1_4(const Triangulation& tri, const std::vector<int>& tets);

/// Piece (t, p) is tetrahedron 24 t + p.rank(); all gluings are by the identity. The midpoint of an edge that
/// is identified with itself backwards becomes a vertex with a projective plane as link. O(n).
[[nodiscard]] Subdivision barycentric(const Triangulation& tri);

enum class Cut {
  ideal_vertices,   ///< closed links that are no spheres
  interior_vertices ///< all closed links: finite vertices become boundary spheres
};

/// A triangulation of the truncated manifold with real boundary: four triangles for each truncated
/// tetrahedron. Other vertices and the real boundary stay. Pieces of a tetrahedron follow one another: sides
/// by (f, d), corners by (f, a), cuts by a. O(n).
[[nodiscard]] Subdivision finite_model(const Triangulation& tri, Cut cut = Cut::ideal_vertices);

} // namespace tetrarch::moves
