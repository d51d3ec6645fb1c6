// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The linear systems of Newton's method: (sum of d theta / d l) step = K.
///
/// At each cusp the matrix is singular: moving the horosphere changes no angle, and K is orthogonal to that
/// move. Of the solutions we take the one that is orthogonal to all such moves; adding u u^T for each (u =
/// the number of ends of each edge in the cusp) makes the matrix definite and gives just that one. Where
/// tetrahedra do not exist the matrix may be singular beyond that; then a multiple of the identity is added,
/// as little as makes it definite. Where the entries have overflowed nothing helps, and the step is K itself.

#include "problem.hpp"

#include <memory>
#include <vector>

namespace tetrarch::hyperbolic {

/// So often is the multiple of the identity raised, from 1e-6 by factors of 100.
inline constexpr int shift_attempts = 20;

/// For many edges: Eigen's sparse factorisation, in double only.
class SparseSystem {
public:
  explicit SparseSystem(const Problem& problem);
  ~SparseSystem();
  SparseSystem(const SparseSystem&) = delete;
  SparseSystem& operator=(const SparseSystem&) = delete;
  void solve(const Problem& problem, const State<double>& state, std::vector<double>& step);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

template <class Scalar>
class NewtonSystem {
public:
  /// Above this many edge classes a sparse factorisation beats the dense one.
  static constexpr int dense_limit = 100;

  explicit NewtonSystem(const Problem& problem);
  /// Needs the state's Jacobians. Dense: O(E^3), allocates nothing.
  void solve(const Problem& problem, const State<Scalar>& state, std::vector<Scalar>& step);

private:
  void assemble(const Problem& problem, const State<Scalar>& state);
  bool factor(const Scalar& shift);

  int size_;
  std::vector<Scalar> hessian_; ///< lower triangle, row by row in a square
  std::vector<Scalar> factor_;  ///< L with D on its diagonal
  std::unique_ptr<SparseSystem> sparse_;
};

} // namespace tetrarch::hyperbolic
