// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Finitely generated abelian groups, in the one form that makes isomorphic groups equal:
///
///   Z^r + Z/d_1 + ... + Z/d_m   with 1 < d_1 | d_2 | ... | d_m.

#include "tetrarch/algebra/integer_matrix.hpp"

#include <string>
#include <vector>

namespace tetrarch::algebra {

/// A finitely generated abelian group, up to isomorphism.
class AbelianGroup {
public:
  AbelianGroup() = default;
  /// Z^rank + the cyclic groups of the given orders, in any order; an order 1 adds nothing.
  /// Law: Z/a + Z/b = Z/gcd(a,b) + Z/lcm(a,b). Throws PreconditionError if rank < 0 or an order is < 1.
  explicit AbelianGroup(int rank, std::vector<Integer> orders = {});

  int rank() const { return rank_; }
  /// The invariant factors: all > 1, each divides the next.
  const std::vector<Integer>& torsion() const { return torsion_; }
  bool is_trivial() const { return rank_ == 0 && torsion_.empty(); }

  /// For instance "0", "Z", "Z^2 + Z/3", "Z/2 + Z/4".
  std::string str() const;

  friend bool operator==(const AbelianGroup&, const AbelianGroup&) = default;

private:
  int rank_ = 0;
  std::vector<Integer> torsion_;
};

/// Orders of cyclic summands as invariant factors: all > 1, each divides the next. Quadratic in the number
/// of orders > 1 that do not divide each other.
std::vector<Integer> invariant_factors(std::vector<Integer> orders);

} // namespace tetrarch::algebra
