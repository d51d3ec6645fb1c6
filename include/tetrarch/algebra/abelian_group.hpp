// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Finitely generated abelian groups, in the one form that makes isomorphic groups equal:
///
///   Z^r + Z/d_1 + ... + Z/d_m   with 1 < d_1 | d_2 | ... | d_m.

#include <memory>
#include <string>

namespace tetrarch::algebra {

/// A list of integers of any size: torsion.hpp.
struct Torsion;

/// A finitely generated abelian group, up to isomorphism. Copies share their torsion.
class AbelianGroup {
public:
  AbelianGroup() = default;
  /// Z^rank. Throws PreconditionError if rank < 0.
  explicit AbelianGroup(int rank);
  /// Z^rank + the cyclic groups of the given orders, in any order; an order 1 adds nothing.
  /// Law: Z/a + Z/b = Z/gcd(a,b) + Z/lcm(a,b). Throws PreconditionError if rank < 0 or an order is < 1.
  AbelianGroup(int rank, Torsion orders);

  int rank() const { return rank_; }
  /// The invariant factors: all > 1, each divides the next.
  const Torsion& torsion() const;
  bool has_torsion() const;
  bool is_trivial() const { return rank_ == 0 && !has_torsion(); }

  /// For instance "0", "Z", "Z^2 + Z/3", "Z/2 + Z/4".
  std::string str() const;

  friend bool operator==(const AbelianGroup& a, const AbelianGroup& b);

private:
  int rank_ = 0;
  std::shared_ptr<const Torsion> torsion_; ///< null: none
};

} // namespace tetrarch::algebra
