// SPDX-License-Identifier: GPL-2.0-or-later
#include "signed_system.hpp"

#include <cmath>
#include <numbers>

namespace tetrarch::hyperbolic {
namespace {

constexpr double first_w = -1.8;
/// Determinants are divided by this, so that an equation of a tetrahedron changes as fast as one of an edge:
/// at the start, a determinant is -97.
constexpr double determinant_unit = 50;

/// A number with its derivatives by the ten entries of W: by W_ij for the six edges, then by the W_ii. Enough
/// of a ring for determinants and adjugates.
struct Dual {
  double value = 0;
  std::array<double, 10> d{};

  friend Dual operator+(Dual a, const Dual& b) {
    a.value += b.value;
    for (std::size_t k = 0; k < 10; ++k) a.d[k] += b.d[k];
    return a;
  }
  friend Dual operator-(const Dual& a) {
    Dual c;
    c.value = -a.value;
    for (std::size_t k = 0; k < 10; ++k) c.d[k] = -a.d[k];
    return c;
  }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual c;
    c.value = a.value * b.value;
    for (std::size_t k = 0; k < 10; ++k) c.d[k] = a.value * b.d[k] + b.value * a.d[k];
    return c;
  }
};

numeric::Matrix4<Dual> with_derivatives(const numeric::Matrix4<double>& w) {
  numeric::Matrix4<Dual> m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      m[i][j].value = w[i][j];
      m[i][j].d[i == j ? 6 + i : edge_number[i][j]] = 1;
    }
  return m;
}

/// The angle of this tangent that is nearest to `near`.
double continued(double angle, double near) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle + turn * std::round((near - angle) / turn);
}

} // namespace

SignedSystem::SignedSystem(const Problem& problem, int vertices)
    : problem_(problem), number_(static_cast<std::size_t>(problem.edges()), -1),
      has_root_(static_cast<std::size_t>(vertices), false) {
  for (int e = 0; e < problem.edges(); ++e)
    if (!problem.is_null(e)) number_[e] = first_vertex_++;
  first_root_ = first_vertex_ + vertices;
  for (const Problem::Tet& tet : problem.tets)
    for (int e = 0; e < 6; ++e)
      if (problem.is_null(tet.edge[e]))
        for (const int v : edge_vertex[e]) has_root_[tet.vertex[v]] = true;
}

SignedState SignedSystem::start() const {
  const auto tets = static_cast<Eigen::Index>(problem_.tets.size());
  SignedState state;
  state.unknowns = Eigen::VectorXd::Ones(first_root_ + tets);
  state.unknowns.head(first_vertex_).setConstant(first_w);
  for (Eigen::Index t = 0; t < tets; ++t) {
    const double det = numeric::determinant(gram(state, problem_.tets[t]));
    state.unknowns[first_root_ + t] = std::sqrt(std::max(-det, 1.0));
  }
  state.angles.assign(problem_.tets.size(), SixNumbers<double>{});
  for (auto& angles : state.angles) angles.fill(1);
  return state;
}

double SignedSystem::norm(const SignedState& state, int vertex) const {
  const double x = state.unknowns[first_vertex_ + vertex];
  return has_root_[vertex] ? x * x : x;
}

double SignedSystem::w(const SignedState& state, int edge) const {
  return number_[edge] < 0 ? 0 : state.unknowns[number_[edge]];
}

numeric::Matrix4<double> SignedSystem::gram(const SignedState& state, const Problem::Tet& tet) const {
  numeric::Matrix4<double> m;
  for (int i = 0; i < 4; ++i) m[i][i] = norm(state, tet.vertex[i]);
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = edge_vertex[e];
    const bool null = number_[tet.edge[e]] < 0;
    m[i][j] =
        null ? -state.unknowns[first_vertex_ + tet.vertex[i]] * state.unknowns[first_vertex_ + tet.vertex[j]]
             : w(state, tet.edge[e]);
    m[j][i] = m[i][j];
  }
  return m;
}

void SignedSystem::add_derivative(const SignedState& state, const Problem::Tet& tet, int i, int j,
                                  double amount, Eigen::MatrixXd& jacobian, int row) const {
  const int p = first_vertex_ + tet.vertex[i];
  const int q = first_vertex_ + tet.vertex[j];
  if (i == j) {
    jacobian(row, p) += has_root_[tet.vertex[i]] ? 2 * state.unknowns[p] * amount : amount;
    return;
  }
  const int number = number_[tet.edge[edge_number[i][j]]];
  if (number >= 0) {
    jacobian(row, number) += amount;
  } else {
    jacobian(row, p) -= state.unknowns[q] * amount;
    jacobian(row, q) -= state.unknowns[p] * amount;
  }
}

bool SignedSystem::evaluate(const std::vector<double>& target, const AngleTable<double>& near,
                            SignedState& state) const {
  const auto tets = static_cast<int>(problem_.tets.size());
  state.defects.setZero(first_vertex_ + tets);
  state.jacobian.setZero(first_vertex_ + tets, state.unknowns.size());
  state.angles.resize(problem_.tets.size());
  for (int e = 0; e < problem_.edges(); ++e)
    if (number_[e] >= 0) state.defects[number_[e]] = target[e];
  for (int t = 0; t < tets; ++t) {
    const Problem::Tet& tet = problem_.tets[t];
    const numeric::Matrix4<Dual> m = with_derivatives(gram(state, tet));
    const numeric::Minors<Dual> minors(m);
    const numeric::Matrix4<Dual> a = numeric::adjugate(m, minors);
    const double root = this->root(state, t);
    const auto add = [&](const std::array<double, 10>& d, double amount, int row) {
      for (int e = 0; e < 6; ++e)
        add_derivative(state, tet, edge_vertex[e][0], edge_vertex[e][1], amount * d[e], state.jacobian, row);
      for (int v = 0; v < 4; ++v) add_derivative(state, tet, v, v, amount * d[6 + v], state.jacobian, row);
    };
    const Dual det = minors.determinant();
    state.defects[first_vertex_ + t] = (det.value + root * root) / determinant_unit;
    add(det.d, 1 / determinant_unit, first_vertex_ + t);
    state.jacobian(first_vertex_ + t, first_root_ + t) += 2 * root / determinant_unit;
    for (int e = 0; e < 6; ++e) {
      const int row = number_[tet.edge[e]];
      if (row < 0) {
        state.angles[t][e] = 0;
        continue;
      }
      const auto [i, j] = edge_vertex[e];
      const auto [k, l] = edge_vertex[opposite_edge(e)];
      const Dual minor = m[i][j] * m[i][j] - m[i][i] * m[j][j];
      if (!(minor.value > 0)) return false;
      const double g = std::sqrt(minor.value);
      const double x = a[k][l].value;
      const double y = root * g;
      const double square = x * x + y * y;
      if (!(square > 0)) return false;
      state.angles[t][e] = continued(std::atan2(y, x), near[t][e]);
      state.defects[row] -= state.angles[t][e];
      // - d theta = (y dx - x dy) / (x^2 + y^2), dy = g dt + root dm / (2 g)
      add(a[k][l].d, y / square, row);
      add(minor.d, -x * root / (2 * g * square), row);
      state.jacobian(row, first_root_ + t) -= x * g / square;
    }
  }
  return state.defects.allFinite();
}

} // namespace tetrarch::hyperbolic
