// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Whether the faces between tetrahedra are walls of the canonical cells.
///
/// Put the vertex vectors of a tetrahedron into R^{3,1}, each cusp's scaled so that its cross-section has the
/// area claimed. The affine hyperplane through them is { y : <n, y> = 1 } with n = sum x_i v_i, G x = 1, G
/// the matrix of inner products. Across face f, n changes by a multiple of the face's normal; v_f is at the
/// distance sqrt(D) / S from the face's span, D = -det G, with S the same on both sides. So the face is
/// convex iff
///
///     x_f sqrt(D) + x'_f' sqrt(D') < 0,
///
/// and flat iff this is 0. Where all faces are convex or flat, the tetrahedra subdivide the canonical cells
/// (Kojima 1990; Epstein-Penner 1988). That something is exactly 0 intervals cannot prove: of a flat face it
/// is checked that it may be flat.

#include "links.hpp"

#include <string>

namespace tetrarch::checker {

/// The first face that is not as claimed, in a sentence; empty if there is none.
std::string fault_in_cells(const OnBox& box, const CellClaims& claims);

} // namespace tetrarch::checker
