// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/conjugate.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

namespace tetrarch::slit {
namespace {

void check_loop(const OneForms& forms, int loop) {
  if (loop < 0 || loop >= forms.loop_count())
    throw PreconditionError("there is no loop " + std::to_string(loop));
}

} // namespace

Coefficients conjugate_by_periods(const OneForms& forms, int loop) {
  check_loop(forms, loop);
  const auto loops = static_cast<std::size_t>(forms.loop_count());
  Coefficients result{std::vector<double>(loops, 0.0), std::vector<double>(loops, 0.0)};
  for (int i = 1; i < forms.loop_count(); ++i) result.tau[i] = forms.flux(i, loop);
  return result;
}

std::vector<Coefficients> conjugates_by_wedges(const OneForms& forms) {
  const int n = forms.loop_count() - 1;
  std::vector<OneForm> basis;
  for (int i = 1; i <= n; ++i) basis.push_back(forms.eta(i));
  for (int i = 1; i <= n; ++i) basis.push_back(forms.tau(i));
  Eigen::MatrixXd wedges = Eigen::MatrixXd::Zero(2L * n, 2L * n);
  Eigen::MatrixXd targets(2L * n, n + 1L);
  const OneForm eta0 = forms.eta(0);
  const std::vector<double> weight = surface::half_cotangents(forms.mesh());
  for (int row = 0; row < 2 * n; ++row) {
    for (int column = 0; column < 2 * n; ++column)
      wedges(row, column) = wedge(forms.mesh().surface, basis[column], basis[row]);
    // The integral of *a ^ b is that of -b ^ *a.
    targets(row, 0) = -inner_product(weight, eta0, basis[row]);
    for (int k = 1; k <= n; ++k) targets(row, k) = -inner_product(weight, basis[k - 1], basis[row]);
  }
  const Eigen::MatrixXd solution = wedges.partialPivLu().solve(targets);
  std::vector<Coefficients> result;
  for (int k = 0; k <= n; ++k) {
    Coefficients c{{0.0}, {0.0}};
    for (int i = 0; i < n; ++i) c.eta.push_back(solution(i, k));
    for (int i = 0; i < n; ++i) c.tau.push_back(solution(n + i, k));
    result.push_back(std::move(c));
  }
  return result;
}

OneForm combination(const OneForms& forms, const Coefficients& coefficients) {
  OneForm sum(static_cast<std::size_t>(forms.mesh().surface.side_count()), 0.0);
  const auto add = [&](double factor, const OneForm& form) {
    for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += factor * form[s];
  };
  for (int i = 0; i < forms.loop_count(); ++i) {
    if (coefficients.eta[i] != 0) add(coefficients.eta[i], forms.eta(i));
    if (coefficients.tau[i] != 0) add(coefficients.tau[i], forms.tau(i));
  }
  return sum;
}

HolomorphicOneForm holomorphic_one_form(const OneForms& forms, int loop) {
  const Coefficients conjugate = conjugate_by_periods(forms, loop);
  return {forms.eta(loop), combination(forms, conjugate)};
}

double distance_from_holomorphic(const OneForms& forms, const HolomorphicOneForm& form) {
  const std::vector<double> weight = surface::half_cotangents(forms.mesh());
  // |b - *a|^2 = |a|^2 + |b|^2 - 2 * integral of a ^ b, triangle by triangle: sums over all of them would
  // cancel.
  double sum = 0;
  for (int t = 0; t < forms.mesh().surface.triangle_count(); ++t) {
    double squares = 0;
    for (const surface::Side s : surface::sides_of(t))
      squares += weight[s.value] * (form.real[s.value] * form.real[s.value] +
                                    form.imaginary[s.value] * form.imaginary[s.value]);
    const int first = surface::Side(t, 0).value;
    const int second = surface::Side(t, 1).value;
    sum += squares - form.real[first] * form.imaginary[second] + form.real[second] * form.imaginary[first];
  }
  return std::sqrt(std::max(sum, 0.0));
}

} // namespace tetrarch::slit
