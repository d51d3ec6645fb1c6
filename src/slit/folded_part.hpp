// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A few triangles of the plane, unfolded together by the foldover-free energy (unfold/unfold.hpp), where
/// moving one vertex after the other is stuck.
///
///        d            Each triangle of the plane gets a point d of its own, one above the plane, that moves
///       /|\           beside the others at that height. The tetrahedron has the triangle's determinant, and
///      / | \          its energy is least where d stands over the corner where it would like to, so that
///     a--|--c         nothing is left of it but the energy of the triangle.
///      \ | /
///        b

#include "tetrarch/core/progress.hpp"
#include "tetrarch/numeric/flat_triangle.hpp"

#include <array>
#include <complex>
#include <optional>
#include <vector>

namespace tetrarch::slit {

struct PartElement {
  std::array<int, 3> corner{};  ///< points of the part
  numeric::FlatTriangle wanted; ///< counterclockwise
};

struct FoldedPart {
  std::vector<PartElement> elements;
  std::vector<std::complex<double>> points;
  /// Of each point: nothing if it is held, 0 if it may go anywhere, else the direction of its line.
  std::vector<std::optional<std::complex<double>>> freedom;
};

/// Where the points go; as they are if nothing is gained. Sizes follow those of the part as it lies: what is
/// wanted is scaled so that the areas agree in sum. O(elements) in each of some hundred steps, 4,000 at most:
/// a second for 2,000 elements.
std::vector<std::complex<double>> unfolded(const FoldedPart& part, const Progress& progress);

} // namespace tetrarch::slit
