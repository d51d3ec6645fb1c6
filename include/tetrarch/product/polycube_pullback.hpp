// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Cubes carried into a solid by a map of all of it, inside and boundary, to its polycube.
///
///        solid M         polycube M^P      The map is linear on each tetrahedron of M. Where it turns
///        .------.         .-------.        none over it has an inverse: a corner of a cube lies in the
///       (   .---'  <---   |   .---'        image of some tetrahedron, and goes to the point with the
///        `-'              '---'            same weights in the tetrahedron itself.
///
/// No field, no fibers and no partition are needed. A solid that is its own polycube gets its own cubes back,
/// to the last digit where coordinates are round. Source: after Gregson, Sheffer and Zhang, "All-hex mesh
/// generation via volumetric PolyCube deformation" (2011), section 3.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/product/polycube.hpp"

#include <optional>
#include <vector>

namespace tetrarch::product {

/// The image of every vertex of a solid, whose boundary has the images given: inside, each coordinate is the
/// discrete harmonic function, with negative weights set to 0 if `clamped`. Linear maps come out linear,
/// without clamping. Nothing if the equations cannot be solved in double precision. Throws PreconditionError
/// unless there is an image of each vertex of the boundary. One sparse factorization.
[[nodiscard]] std::optional<std::vector<Point>>
harmonic_image(const Solid& solid, const std::vector<Point>& boundary_image, bool clamped = false);

/// The tetrahedra whose image has no positive volume, decided exactly, or is not finite. O(n).
std::vector<int> folded(const Solid& solid, const std::vector<Point>& image);

/// The same map unfolded by the energy of the room `unfold`, the boundary being fixed; each tetrahedron would
/// like to keep its shape. Nothing where tetrahedra stay folded, as those must whose corners are all on the
/// boundary and whose image has no positive volume. O(n) an iteration.
[[nodiscard]] std::optional<std::vector<Point>>
unfolded_image(const Solid& solid, const std::vector<Point>& image, const Progress& progress = {});

/// `image` holds the image of each vertex of the solid's mesh; no tetrahedron may be folded. Throws as
/// `filled_polycube`, and PreconditionError where a tetrahedron is folded. Points that are in no tetrahedron,
/// by rounding, are left out, and so is what is beside them. O(n + c log c) for c cubes, if no tetrahedron is
/// much larger than a cube.
PolycubeHexahedra pulled_back(const Solid& solid, const std::vector<Point>& image,
                              const PolycubeOptions& options = {}, const Progress& progress = {});

} // namespace tetrarch::product
