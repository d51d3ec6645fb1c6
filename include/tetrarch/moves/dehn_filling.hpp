// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Dehn filling: a solid torus glued to a torus cusp such that a given curve bounds a disk in it.
///
/// Truncate the cusp. A triangulated torus is left, and the curve tells each side of a triangle how often it
/// crosses (`CuspCurves`). Tetrahedra are layered on: one on two neighboring triangles turns the edge between
/// them to the other diagonal, one on the three triangles around a vertex takes the vertex away. Both keep
/// the manifold, and the flow across a new edge is that which enters its triangle elsewhere. When one vertex
/// is left, the flows across its three edges are p, q and p + q; turning the edge of the largest is a step of
/// Euclid's algorithm. At last they are 1, 1 and 2:
///
///     a0 ---- a1     The curve crosses the diagonal twice. Fold the two triangles onto one another along it:
///      |  2 / |      the torus is closed, and what has become a point is the sum of the sides, that is, the
///      |   /  |      other diagonal, which crosses this one twice and either side once.
///     a2 ---- b0
///
/// Source: layered solid tori by Jaco and Rubinstein 2006; the removal of vertices is that of Pachner's moves
/// in the plane.

#include "tetrarch/core/triangulation.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::moves {

/// A curve on each of some cusps. Entry [t][v][f]: how often it enters the truncation triangle at vertex v of
/// tetrahedron t across the side on face f, less how often it leaves there. Laws: the three entries of a
/// triangle sum to 0, and the two entries of a side do. Where all entries of a cusp are 0 it has no curve.
using CuspCurves = std::vector<std::array<std::array<std::int64_t, 4>, 4>>;

/// Why the cusps cannot be filled along these curves, as a sentence: the laws do not hold, the cusp is no
/// torus, the curve is a multiple of another one or bounds a disk, or would take too many tetrahedra. Nothing
/// if they can. O(n).
std::optional<std::string> why_not_fill(const Triangulation& tri, const CuspCurves& curves);

/// Every cusp that has a curve is filled along it; each other ideal vertex becomes real boundary. Some forty
/// tetrahedra for each one given, and one for each step of Euclid's algorithm: whoever wants few lets
/// `truncate` follow. Throws PreconditionError where `why_not_fill` has a reason. O(n log n).
[[nodiscard]] Triangulation filled(const Triangulation& tri, const CuspCurves& curves);

} // namespace tetrarch::moves
