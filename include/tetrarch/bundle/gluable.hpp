// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Gluable triangulations and the gluing map: the walls over a cut, in the dissertation's grid coordinates.
///
///     j+1  o-----o-----o      A *band* is the wall over one bank c of a curve of the cut, M edges long. Its
///          |   / | \   |      vertex (c, i, j) lies on level j, 0 <= j < N, over the i-th vertex of the
///          | /   |   \ |      bank, 0 <= i <= M, where i grows along the boundary of the covering disk, on
///     j    o-----o-----o      both banks. Over an edge of value +1 the diagonals run upwards (diagonal
///          i +1 i+1 -1 i+2    edges), over one of -1 downwards (anti-diagonal edges).
///
/// The gluing map takes (a, i, j) to (a^-1, M - i, j + c(i)), or to (a', i, -j + c(i)) where the banks run
/// together. On a sphere, where the curve is closed and every value +1, c(i) = N/2 - i if one counts from the
/// right vertex; on the curves of a surface of higher genus that are twisted, c(i) = i. Fiber paths go to
/// fiber paths; base paths to diagonal paths and back where the curve is twisted, else to base paths. Source:
/// Yin, 6.2 to 6.4 and 7.2 to 7.4.

#include "tetrarch/bundle/circle_bundle.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <array>
#include <string>
#include <vector>

namespace tetrarch::bundle {

/// One bank of a curve: the wall over it.
struct Band {
  int mark = 0;
  bool closed = false;     ///< the boundary of a covering disk as a whole: i counts mod M
  std::vector<Side> sides; ///< the i-th runs from (., i, .) to (., i+1, .)
};

/// The two banks of each curve, that of positive mark first, by curve. A curve is the edges of one mark,
/// which must follow each other; a closed one starts with the side of least number. Throws
/// `PreconditionError` if they do not. O(n).
std::vector<std::array<Band, 2>> bands(const surface::MarkedSurface& cut);

/// The steps by which the fibers of a curve turn from its beginning to its end: N for each whole turn.
int twist_along(const Band& band, const Recipe& recipe);

/// The vertex (c, i, j) of the band over bank c.
struct GridVertex {
  int i = 0;
  int j = 0; ///< of any size; mod N
  friend auto operator<=>(const GridVertex&, const GridVertex&) = default;
};

/// The 2 M N triangles of the band, counterclockwise seen from outside the covering disk's bundle with i to
/// the right and j upwards; levels 0 to N, not reduced.
std::vector<std::array<GridVertex, 3>> band_triangles(const Band& band, const Recipe& recipe);

/// The gluing map on a vertex of band a of a pair of bands.
GridVertex gluing_map(const Band& band, const Recipe& recipe, GridVertex v);

/// The audit of 6.4 and 7.4: whether the gluing map is a bijection of the vertices, edges and triangles of
/// the two bands, taking fiber edges to fiber edges and turning every triangle over, and takes the ring of
/// triangles around every vertex inside the band to the ring around its image, in reverse order; so it is
/// continuous with its inverse. Where banks run together it keeps triangles as they are seen. A sentence;
/// empty if all is well. O(M N log(M N)).
std::string why_not_gluable(const std::array<Band, 2>& pair, const Recipe& recipe);

} // namespace tetrarch::bundle
