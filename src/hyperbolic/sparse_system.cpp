// SPDX-License-Identifier: GPL-2.0-or-later
#include "newton_system.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>

namespace tetrarch::hyperbolic {
namespace {

/// A pivot below this is rounding: the Hessian's eigenvalues at a structure are of order 1.
constexpr double smallest_pivot = 1e-15;

/// One edge class per cusp such that the moves of all horospheres are told apart by their values there:
/// elimination on the matrix ends_at_cusp. Holding those lengths fixed makes the matrix definite without
/// filling it, as u u^T would.
std::vector<int> pinned_edges(const Problem& problem) {
  std::vector<std::vector<double>> rows;
  std::vector<int> pins;
  for (const std::vector<int>& u : problem.ends_at_cusp) {
    std::vector<double> row(u.begin(), u.end());
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const double factor = row[pins[c]] / rows[c][pins[c]];
      for (std::size_t e = 0; e < row.size(); ++e) row[e] -= factor * rows[c][e];
    }
    int pin = 0;
    for (int e = 0; e < problem.edges(); ++e)
      if (std::abs(row[e]) > std::abs(row[pin])) pin = e;
    pins.push_back(pin);
    rows.push_back(std::move(row));
  }
  return pins;
}

} // namespace

struct SparseSystem::Parts {
  Eigen::SparseMatrix<double> matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  std::vector<int> pins;
  Eigen::MatrixXd moves; ///< a column per cusp
  Eigen::LDLT<Eigen::MatrixXd> moves_gram;
  std::vector<Eigen::Triplet<double>> entries;
};

SparseSystem::SparseSystem(const Problem& problem) : parts_(std::make_unique<Parts>()) {
  const int cusps = static_cast<int>(problem.ends_at_cusp.size());
  parts_->matrix.resize(problem.edges(), problem.edges());
  parts_->pins = pinned_edges(problem);
  parts_->moves.resize(problem.edges(), cusps);
  for (int c = 0; c < cusps; ++c)
    for (int e = 0; e < problem.edges(); ++e) parts_->moves(e, c) = problem.ends_at_cusp[c][e];
  if (cusps > 0) parts_->moves_gram.compute(parts_->moves.transpose() * parts_->moves);
}

SparseSystem::~SparseSystem() = default;

void SparseSystem::solve(const Problem& problem, const State<double>& state, std::vector<double>& step) {
  Parts& p = *parts_;
  p.entries.clear();
  for (std::size_t t = 0; t < problem.tets.size(); ++t) {
    const auto& edge = problem.tets[t].edge;
    for (int e = 0; e < 6; ++e)
      for (int f = 0; f < 6; ++f)
        if (edge[f] <= edge[e]) p.entries.emplace_back(edge[e], edge[f], state.jacobian[t][e][f]);
  }
  for (int e = 0; e < problem.edges(); ++e)
    if (problem.is_null(e)) p.entries.emplace_back(e, e, 1.0); // no unknown: its step is 0
  for (const int pin : p.pins) p.entries.emplace_back(pin, pin, 1.0);
  p.matrix.setFromTriplets(p.entries.begin(), p.entries.end());
  if (p.solver.rows() == 0) p.solver.analyzePattern(p.matrix); // the pattern never changes
  step = state.curvature;
  double shift = 0;
  for (int attempt = 0;; ++attempt) {
    if (attempt == shift_attempts) return;
    p.solver.setShift(shift);
    p.solver.factorize(p.matrix);
    if (p.solver.info() == Eigen::Success && p.solver.vectorD().minCoeff() > smallest_pivot) break;
    shift = shift == 0 ? 1e-6 : 100 * shift;
  }
  const Eigen::Map<const Eigen::VectorXd> curvature(state.curvature.data(), problem.edges());
  Eigen::VectorXd solution = p.solver.solve(curvature);
  if (p.moves.cols() > 0)
    solution -= p.moves * p.moves_gram.solve(Eigen::VectorXd(p.moves.transpose() * solution));
  step.assign(solution.data(), solution.data() + solution.size());
}

} // namespace tetrarch::hyperbolic
