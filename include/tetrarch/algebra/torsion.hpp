// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The torsion of an abelian group as integers: for those who calculate with it. Everybody else includes
/// abelian_group.hpp, which does without the header of GMP.

#include "tetrarch/algebra/abelian_group.hpp"
#include "tetrarch/algebra/integer_matrix.hpp"

#include <vector>

namespace tetrarch::algebra {

/// Orders of cyclic groups.
struct Torsion : std::vector<Integer> {
  using std::vector<Integer>::vector;
};

/// Orders of cyclic summands as invariant factors: all > 1, each divides the next. Quadratic in the number
/// of orders > 1 that do not divide each other.
Torsion invariant_factors(Torsion orders);

} // namespace tetrarch::algebra
