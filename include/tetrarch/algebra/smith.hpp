// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Smith's normal form of a sparse integer matrix.
///
/// Row and column operations over the integers turn every matrix into a diagonal one whose entries divide
/// each other: 1, ..., 1, d_1 | d_2 | ..., 0, ..., 0. Boundary maps consist almost entirely of +-1, so nearly
/// all pivots are units. They are taken first, in the manner of Markowitz (1957): the shortest column, and
/// in it the unit whose row is shortest, so that little is filled in. What remains has no unit and is small;
/// it is reduced by division with remainder, smallest entry first. Machine integers serve until one
/// overflows, GMP integers from that step on.

#include "tetrarch/algebra/torsion.hpp"

namespace tetrarch::algebra {

/// The invariant factors of a matrix, those that are not 0.
struct SmithForm {
  int units = 0;   ///< how many invariant factors are 1
  Torsion factors; ///< the others: all > 1, each divides the next
  int rank() const { return units + static_cast<int>(factors.size()); }
  friend bool operator==(const SmithForm&, const SmithForm&) = default;
};

/// Time is near-linear in the number of entries while units are found in short columns or rows, and
/// polynomial beyond. Rows are the lines that get combined, so let the rows be the short side.
SmithForm smith_normal_form(const SparseMatrix& matrix);

} // namespace tetrarch::algebra
