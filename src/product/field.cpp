// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/field.hpp"
#include "tetrarch/numeric/maximum.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"
#include "tetrarch/solid/edge_weights.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::product {
namespace {

using numeric::SymmetricMatrix;
using solid::WeightedEdge;

/// From here on conjugate gradients are quicker, and take less memory.
constexpr int large = 20'000;

/// The equations for the vertices on no base.
struct System {
  std::vector<int> unknown; ///< of each vertex; -1 on a base
  SymmetricMatrix matrix;
  std::vector<double> right;
};

/// `w`: the values on the bases.
System equations(const std::vector<WeightedEdge>& edges, const std::vector<int>& base,
                 const std::vector<double>& w) {
  System s;
  s.unknown.assign(base.size(), -1);
  int size = 0;
  std::vector<char> used(base.size(), 0); // files have points that belong to nothing
  for (const WeightedEdge& e : edges) used[e.from] = used[e.to] = 1;
  for (std::size_t v = 0; v < base.size(); ++v)
    if (base[v] < 0 && used[v] != 0) s.unknown[v] = size++;
  s.right.assign(static_cast<std::size_t>(size), 0.0);

  // Edges come in increasing order of the lesser vertex, then of the other: that of a lower triangle.
  SymmetricMatrix& a = s.matrix;
  a.first.assign(static_cast<std::size_t>(size) + 1, 0);
  for (int k = 0; k < size; ++k) a.first[k + 1] = 1;
  for (const WeightedEdge& e : edges)
    if (s.unknown[e.from] >= 0 && s.unknown[e.to] >= 0) ++a.first[s.unknown[e.from] + 1];
  for (int k = 0; k < size; ++k) a.first[k + 1] += a.first[k];
  a.row.assign(static_cast<std::size_t>(a.first.back()), 0);
  a.value.assign(a.row.size(), 0.0);
  std::vector<int> next(a.first.begin(), a.first.end() - 1);
  for (int k = 0; k < size; ++k) a.row[next[k]++] = k;
  const auto add = [&](int here, int there, double weight) {
    if (s.unknown[here] < 0) return;
    a.value[a.first[s.unknown[here]]] += weight;
    if (s.unknown[there] < 0) s.right[s.unknown[here]] += weight * w[there];
  };
  for (const WeightedEdge& e : edges) {
    add(e.from, e.to, e.weight);
    add(e.to, e.from, e.weight);
    if (s.unknown[e.from] < 0 || s.unknown[e.to] < 0) continue;
    int& at = next[s.unknown[e.from]];
    a.row[at] = s.unknown[e.to];
    a.value[at++] = -e.weight;
  }
  return s;
}

std::vector<double> solve_directly(System& s) {
  numeric::SparseCholesky solver(s.matrix);
  if (!solver.factor(s.matrix))
    throw InputError("the harmonic field has no solution in double precision: its matrix is not positive "
                     "definite after rounding (are there nearly flat tetrahedra?)");
  std::vector<double> x(s.right.size());
  solver.solve(s.right, x);
  return x;
}

/// Our own loop around Eigen's incomplete factor, since Eigen's can be neither watched nor stopped.
std::vector<double> solve_iteratively(const System& s, double tolerance, int& iterations,
                                      const Progress& progress) {
  const auto size = static_cast<Eigen::Index>(s.right.size());
  const Eigen::Map<const Eigen::SparseMatrix<double>> a(
      size, size, static_cast<Eigen::Index>(s.matrix.row.size()), s.matrix.first.data(), s.matrix.row.data(),
      s.matrix.value.data());
  const Eigen::IncompleteCholesky<double, Eigen::Lower> factor(a);
  const auto symmetric = a.selfadjointView<Eigen::Lower>();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd residual = Eigen::Map<const Eigen::VectorXd>(s.right.data(), size);
  const double first = residual.norm();
  Eigen::VectorXd z = factor.solve(residual);
  Eigen::VectorXd direction = z;
  double product = residual.dot(z);
  constexpr int most_iterations = 10'000;
  for (iterations = 0; iterations < most_iterations; ++iterations) {
    const double norm = residual.norm();
    if (norm <= tolerance * first) break;
    progress.step("harmonic field", std::clamp(std::log(norm / first) / std::log(tolerance), 0.0, 1.0));
    const Eigen::VectorXd image = symmetric * direction;
    const double step = product / direction.dot(image);
    if (!std::isfinite(step)) break;
    x += step * direction;
    residual -= step * image;
    z = factor.solve(residual);
    const double next = residual.dot(z);
    direction = z + next / product * direction;
    product = next;
  }
  return {x.data(), x.data() + size};
}

} // namespace

HarmonicField harmonic_field(const Solid& solid, const Partition& partition, const FieldOptions& options,
                             const Progress& progress) {
  progress.step("harmonic field");
  HarmonicField field;
  const std::vector<int> base = bases_of_vertices(solid, partition);
  std::vector<WeightedEdge> edges = solid::edge_weights(solid.mesh);
  for (WeightedEdge& e : edges) {
    if (!(e.weight < 0)) continue;
    ++field.negative_weights;
    if (options.clamped) e.weight = 0;
  }
  field.w.assign(base.size(), 0.0);
  for (std::size_t v = 0; v < base.size(); ++v)
    if (base[v] == ceiling_patch) field.w[v] = options.height;

  System system = equations(edges, base, field.w);
  const bool iterative = options.solver == FieldOptions::Solver::automatic
                             ? static_cast<int>(system.right.size()) >= large
                             : options.solver == FieldOptions::Solver::iterative;
  const std::vector<double> x = system.right.empty() ? std::vector<double>{}
                                : iterative
                                    ? solve_iteratively(system, options.tolerance, field.iterations, progress)
                                    : solve_directly(system);
  for (std::size_t v = 0; v < base.size(); ++v)
    if (system.unknown[v] >= 0) field.w[v] = x[system.unknown[v]];

  const std::vector<double> flux = solid::fluxes(edges, field.w);
  for (std::size_t v = 0; v < base.size(); ++v) {
    if (base[v] == ceiling_patch) field.flow += flux[v];
    if (base[v] < 0) field.residual = numeric::maximum(field.residual, std::abs(flux[v]));
  }
  field.residual /= field.flow;
  return field;
}

} // namespace tetrarch::product
