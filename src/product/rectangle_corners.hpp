// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Where the corners of a floor's rectangles are sought.
///
///      .----------.      Outside they are where the rim turns most. Inside, where each hole reaches farthest
///      |  /\\ .--. |      in the diagonal directions: the search that follows moves them along the rims, and
///      |  (_) |__| |      finds what is near.
///      '----------'

#include "tetrarch/surface/triangle_mesh.hpp"

#include <array>
#include <complex>
#include <optional>
#include <vector>

namespace tetrarch::product {

/// Four vertices of each rim.
using CornerHints = std::vector<std::array<int, 4>>;

/// The floor's shadow in the plane of its area vector: x along the principal axis of the rim. None where the
/// shadow is much smaller than the floor, which is then no plate.
std::optional<std::vector<std::complex<double>>> shadow(const surface::TriangleMesh& floor,
                                                        const std::vector<int>& rim);

/// Rims by their vertices in the order of walking, the floor to the left; the outer one first. `place` shows
/// how they lie in the plane, without much distortion of angles. One guess, if there are no holes, else two:
/// each hole's extreme points as it lies, in the frame that a rectangle without regard to holes has there;
/// and those of its image in that rectangle, which is better where the frame turns within the size of the
/// hole. `given` are the outer corners, if somebody chose them. Two sparse factorisations.
std::vector<CornerHints> corner_guesses(const surface::TriangleMesh& floor,
                                        const std::vector<std::vector<int>>& rims,
                                        const std::vector<std::complex<double>>& place,
                                        const std::optional<std::array<int, 4>>& given);

} // namespace tetrarch::product
