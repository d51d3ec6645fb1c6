// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The map of a solid to its polycube.
///
///      .-''-.        .-----.     First each coordinate is the function whose gradient is nearest to
///     (      ) ----> |     |     the axis, as squares count, among those that are constant on each chart
///      '-..-'        '-----'     of the axis. With wanted places of the planes the same holds with the
///                                constants given. Then the energy of the room `unfold` turns over what
///                                is folded, while vertices stay in their planes.
///
/// Source: Gregson, Sheffer and Zhang, "All-hex mesh generation via volumetric PolyCube deformation" (2011),
/// for the first; Garanzha et al., "Foldover-free maps in 50 lines of code" (2021), for the second.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/polycube/planes.hpp"

#include <optional>
#include <vector>

namespace tetrarch::polycube {

struct Image {
  std::vector<Point> points;     ///< of each vertex of the mesh
  std::vector<double> of_planes; ///< the coordinate of each plane along its axis
};

/// Lengths become `scale` times as long. `wanted` has the coordinate of each plane; empty: they are found.
/// Nothing if the equations cannot be solved in double precision. Three sparse factorizations.
[[nodiscard]] std::optional<Image> least_squares_image(const product::Solid& solid, const Planes& planes,
                                                       double scale, const std::vector<double>& wanted = {});

/// The image unfolded, planes staying as they are; the best that was met. Throws Stopped. O(n) an iteration.
std::vector<Point> unfolded_image(const product::Solid& solid, const Planes& planes, double scale,
                                  std::vector<Point> start, const Progress& progress = {});

/// The same where only vertices move that are so many edges away from a folded tetrahedron. Of a large mesh
/// with few folds the whole energy tells little about these.
std::vector<Point> locally_unfolded_image(const product::Solid& solid, const Planes& planes, double scale,
                                          std::vector<Point> start, int rings, const Progress& progress = {});

} // namespace tetrarch::polycube
