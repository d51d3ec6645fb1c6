// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The equations of a structure in unknowns that let tetrahedra pass through flat ones.
///
/// Unknowns: w = <v,v'> of each edge class that is not null, <v,v> of each vertex class, and for each
/// tetrahedron a signed root t. Equations: for each edge that is not null, K = 0; for each tetrahedron,
/// det W + t^2 = 0. The angle at edge ij is
///
///   theta_ij = atan2(t sqrt(w_ij^2 - w_ii w_jj), A_kl),
///
/// smooth wherever the edge meets hyperbolic space; of the angles that differ by full turns, that nearest to
/// the last state's is meant. Vectors may be scaled freely: one direction for each vertex in which nothing
/// changes, and steps of least norm do not go there. A vertex at a null edge has <v,v> = q^2 with q the
/// unknown, and a null edge has w = -q q'.

#include "problem.hpp"

#include <Eigen/Core>

namespace tetrarch::hyperbolic {

struct SignedState {
  Eigen::VectorXd unknowns;
  AngleTable<double> angles; ///< signed
  Eigen::VectorXd defects;   ///< K of the edges, then (det W + t^2) / 50 of the tetrahedra
  Eigen::MatrixXd jacobian;  ///< of the defects
};

class SignedSystem {
public:
  SignedSystem(const Problem& problem, int vertices);

  /// All w = -1.8, all <v,v> = 1, all tetrahedra positive.
  SignedState start() const;
  /// Angles, defects and their derivatives at `state.unknowns`; `target` holds an angle for each edge class.
  /// False where some edge does not meet hyperbolic space. `near`: the state whose angles are continued.
  bool evaluate(const std::vector<double>& target, const AngleTable<double>& near, SignedState& state) const;

  double w(const SignedState& state, int edge) const;
  double norm(const SignedState& state, int vertex) const;
  double root(const SignedState& state, int tet) const { return state.unknowns[first_root_ + tet]; }

private:
  numeric::Matrix4<double> gram(const SignedState& state, const Problem::Tet& tet) const;
  /// Adds `amount` times the derivative of W_ij of that tetrahedron, by the unknowns, to a row.
  void add_derivative(const SignedState& state, const Problem::Tet& tet, int i, int j, double amount,
                      Eigen::MatrixXd& jacobian, int row) const;

  const Problem& problem_;
  std::vector<int> number_;    ///< of each edge class, its unknown and its equation; -1: null
  std::vector<bool> has_root_; ///< of each vertex class, whether <v,v> = q^2
  int first_vertex_ = 0;       ///< number of edges that are not null
  int first_root_ = 0;
};

} // namespace tetrarch::hyperbolic
