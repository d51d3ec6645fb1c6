// SPDX-License-Identifier: GPL-2.0-or-later
#include "least_norm.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tetrarch::hyperbolic {
namespace {

/// Eigenvalues below this part of the largest are no equations. Away from the structure those of a finite
/// vertex are of the size of K, hence the second bound, which is taken where K is small.
constexpr double smallest_part = 1e-9;
constexpr double largest_part = 1e-4;
/// A step is tried at so many halves of its length.
constexpr int halvings = 14;

Eigen::MatrixXd jacobian(const Problem& problem, const State<double>& state) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(problem.edges(), problem.edges());
  for (std::size_t t = 0; t < problem.tets.size(); ++t)
    for (int e = 0; e < 6; ++e)
      for (int f = 0; f < 6; ++f)
        matrix(problem.tets[t].edge[e], problem.tets[t].edge[f]) += state.jacobian[t][e][f];
  return matrix;
}

/// The shortest step to where the angles' linear model has K = 0.
void least_norm_step(const Problem& problem, const State<double>& state, std::vector<double>& step) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jacobian(problem, state));
  const Eigen::Map<const Eigen::VectorXd> curvature(state.curvature.data(), problem.edges());
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double part = std::clamp(state.residual(), smallest_part, largest_part);
  const double floor = part * std::max(std::abs(values.minCoeff()), std::abs(values.maxCoeff()));
  Eigen::VectorXd along = eigen.eigenvectors().transpose() * curvature;
  for (Eigen::Index k = 0; k < values.size(); ++k)
    along[k] = std::abs(values[k]) > floor ? along[k] / values[k] : 0;
  const Eigen::VectorXd solution = eigen.eigenvectors() * along;
  step.assign(solution.data(), solution.data() + solution.size());
}

/// Lengths between two points, or two planes, are not signed.
double length_at(const Problem& problem, std::size_t e, double length) {
  const auto& [a, b] = problem.ends[e];
  return a == b && a != VertexType::ideal ? std::abs(length) : length;
}

bool curvature_search(const Problem& problem, const State<double>& now, const std::vector<double>& step,
                      State<double>& trial) {
  const double size = kernel::largest_magnitude(step);
  if (!std::isfinite(size)) return false;
  const double before = now.squared_curvature();
  double part = size > longest_step ? longest_step / size : 1;
  for (int attempt = 0; attempt < halvings; ++attempt, part /= 2) {
    for (std::size_t e = 0; e < step.size(); ++e)
      trial.lengths[e] = length_at(problem, e, now.lengths[e] + part * step[e]);
    trial.evaluate(problem, true);
    if (trial.squared_curvature() < (1 - part / 4) * before) return true;
  }
  return false;
}

} // namespace

Run<double> least_norm_newton(const Problem& problem, std::vector<double> start, const Goals<double>& goals,
                              const Progress& progress) {
  Run<double> run{State<double>(problem, std::move(start)), 0, 0, false, {}};
  State<double> trial = run.state;
  std::vector<double> step;
  run.state.evaluate(problem, true);
  for (;; ++run.iterations) {
    progress.step("newton");
    least_norm_step(problem, run.state, step);
    run.last_step = kernel::largest_magnitude(step);
    if (run.state.longest() > goals.length_limit || run.iterations >= goals.max_iterations ||
        run.state.residual() <= 16 * std::numeric_limits<double>::epsilon() ||
        !curvature_search(problem, run.state, step, trial))
      return run;
    std::swap(run.state, trial);
  }
}

} // namespace tetrarch::hyperbolic
