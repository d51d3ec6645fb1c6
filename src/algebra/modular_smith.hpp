// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Smith's normal form of a sparse matrix whose entries have many digits.
///
/// Euclid's algorithm on rows and columns lets entries grow far beyond the result. Modulo a nonzero minor D of
/// the greatest size r, the rank, they cannot: all invariant factors divide D, so the cokernel keeps its
/// torsion there, beside one Z/D for each dimension of its free part.
///
///  1. Modulo a prime of 62 bits: r rows and columns with a nonzero minor, in an order that fills in little.
///  2. Their determinant D from its remainders, modulo as many primes as Hadamard's bound asks for. The other
///     rows come out 0 modulo all of them: as many primes as no greater minor has.
///  3. The diagonal form over Z/D, shortest columns first.
///
/// Source for 3: Iliopoulos, "Worst-case complexity bounds on algorithms for computing the canonical structure
/// of finite abelian groups" (1989).

#include "sparse_row.hpp"
#include "tetrarch/algebra/smith.hpp"

#include <vector>

namespace tetrarch::algebra {

/// For k rows and columns whose minors have b bits: O(b k) for each row that elimination fills in, twice; the
/// form over Z/D takes some k greatest common divisors of b bits.
SmithForm modular_smith_form(const std::vector<SparseRow<Integer>>& rows);

} // namespace tetrarch::algebra
