// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The cotangent Laplacian: how much of a function flows out of each vertex.
///
///            v                 Linear on each triangle, f has the Dirichlet energy sum w(s) (f(v) - f(u))^2
///           /|\                over all sides s = uv; w(s) is half the cotangent of the angle opposite, at
///          / | \               a or b. (L f)(v) = sum of (w(s) + w(mate)) (f(v) - f(u)) over the edges at
///         a  |  b              v is its gradient, halved, with the sign of -Laplace. Where f is harmonic
///          \ | /               around v it is 0; summed over a boundary loop it is the flux of f out through
///           \|/                the loop.
///            u
///
/// L is symmetric and positive semidefinite with the constants as its kernel, whatever the triangles; it need
/// not be an M-matrix. Source: Pinkall and Polthier, "Computing discrete minimal surfaces and their
/// conjugates" (1993).

#include "tetrarch/surface/triangle_mesh.hpp"

#include <memory>
#include <vector>

namespace tetrarch::surface {

/// For each side half the cotangent of the opposite angle. Throws InputError with the number of a triangle
/// (counted from 0) that is so thin that its cotangents would be rounding errors. O(n).
std::vector<double> half_cotangents(const TriangleMesh& mesh);

/// L f, for the weights of the sides and a value at each vertex. O(n).
std::vector<double> fluxes(const Surface& surface, const std::vector<double>& weight,
                           const std::vector<double>& f);

/// L restricted to the vertices that are not held, factored once for any number of right-hand sides. The
/// library factors with CHOLMOD or Eigen, depending on its build; results are the same up to rounding.
class LaplaceSolver {
public:
  /// A number for each vertex, of any number of functions.
  using Columns = std::vector<std::vector<double>>;

  /// `held[v]` tells whether the value at vertex v is given; at least one must be, and the surface connected.
  /// Throws InputError if rounding leaves no positive definite matrix. Neither the surface nor the weights
  /// are kept. One sparse Cholesky factorization; in practice about O(n^1.5) for n vertices, and O(n log n)
  /// memory.
  LaplaceSolver(const Surface& surface, const std::vector<double>& weight, const std::vector<char>& held);
  ~LaplaceSolver();
  LaplaceSolver(LaplaceSolver&&) noexcept;
  LaplaceSolver& operator=(LaplaceSolver&&) noexcept;

  /// Holds other vertices from now on, as above. The order of elimination stays and the new factor overwrites
  /// the old one, so this takes less time than a new solver, and no memory. After InputError the solver is
  /// unusable.
  void hold(const std::vector<char>& held);

  /// The functions f that have the value data[k][v] where v is held, and (L f)(v) = data[k][v] where it is
  /// not. One step of iterative refinement is done. About O(n log n) for each function.
  Columns solve(const Columns& data) const;

private:
  struct Factored;
  std::unique_ptr<Factored> factored_;
};

} // namespace tetrarch::surface
