// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Whether a hexahedron is inverted anywhere inside, not at its corners alone.
///
///       .-------.        The trilinear map of a cube has a Jacobian determinant that is a polynomial of
///      /|  ?   /|        degree 2 in each of three variables: 27 Bernstein coefficients, between the least
///     '-------' |        and greatest of which all its values lie. The eight at the corners are values. If
///     | '-----|-'        all 27 are positive, so is the determinant; if not, the cube is cut into eight,
///     '-------'          whose coefficients lie closer to the values.
///
/// Source: Johnen, Weill and Remacle, "Robust and efficient validation of the linear hexahedral element"
/// (2017).

#include "tetrarch/numeric/vector.hpp"

#include <array>

namespace tetrarch::product {

/// Coefficient (i, j, k) at i + 3 j + 9 k: for i = j = k = 0 the determinant at corner 0, for i = 2 at corner
/// 1, for j = 2 at corner 3, for k = 2 at corner 4.
using JacobianCoefficients = std::array<double, 27>;

/// Corners as those of `HexMesh`. O(1), some 700 operations.
JacobianCoefficients jacobian_coefficients(const std::array<numeric::Point, 8>& corners);

/// Whether the determinant is shown to be positive in the whole cube, but for rounding. False: it is not
/// positive somewhere, or so close to 0 that cutting the cube five times does not tell.
bool is_positive_inside(const std::array<numeric::Point, 8>& corners);

} // namespace tetrarch::product
