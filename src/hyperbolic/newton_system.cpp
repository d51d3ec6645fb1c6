// SPDX-License-Identifier: GPL-2.0-or-later
#include "newton_system.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace tetrarch::hyperbolic {

template <class Scalar>
NewtonSystem<Scalar>::NewtonSystem(const Problem& problem) : size_(problem.edges()) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (size_ > dense_limit) {
      sparse_ = std::make_unique<SparseSystem>(problem);
      return;
    }
  }
  hessian_.resize(static_cast<std::size_t>(size_) * size_);
  factor_.resize(hessian_.size());
}

template <class Scalar>
void NewtonSystem<Scalar>::assemble(const Problem& problem, const State<Scalar>& state) {
  std::fill(hessian_.begin(), hessian_.end(), Scalar(0));
  for (std::size_t t = 0; t < problem.tets.size(); ++t) {
    const auto& edge = problem.tets[t].edge;
    for (int e = 0; e < 6; ++e)
      for (int f = 0; f < 6; ++f)
        if (edge[f] <= edge[e]) hessian_[edge[e] * size_ + edge[f]] += state.jacobian[t][e][f];
  }
  for (int e = 0; e < size_; ++e)
    if (problem.is_null(e)) hessian_[e * size_ + e] = 1; // no unknown: its step is 0
  for (const std::vector<int>& u : problem.ends_at_cusp)
    for (int i = 0; i < size_; ++i)
      for (int j = 0; j <= i; ++j) hessian_[i * size_ + j] += u[i] * u[j];
}

/// L D L^T of the Hessian plus shift times the identity; false at the first pivot that is not safely
/// positive.
template <class Scalar>
bool NewtonSystem<Scalar>::factor(const Scalar& shift) {
  Scalar largest = 0;
  for (int i = 0; i < size_; ++i) largest = std::max(largest, hessian_[i * size_ + i]);
  const Scalar floor = 4 * std::numeric_limits<Scalar>::epsilon() * (largest + shift);
  for (int i = 0; i < size_; ++i) {
    Scalar* row = &factor_[i * size_];
    for (int j = 0; j < i; ++j) {
      const Scalar* other = &factor_[j * size_];
      Scalar value = hessian_[i * size_ + j];
      for (int k = 0; k < j; ++k) value -= row[k] * other[k];
      row[j] = value; // times D_j for now
    }
    Scalar pivot = hessian_[i * size_ + i] + shift;
    for (int j = 0; j < i; ++j) {
      const Scalar scaled = row[j] / factor_[j * size_ + j];
      pivot -= scaled * row[j];
      row[j] = scaled;
    }
    if (!(pivot > floor)) return false;
    row[i] = pivot;
  }
  return true;
}

template <class Scalar>
void NewtonSystem<Scalar>::solve(const Problem& problem, const State<Scalar>& state,
                                 std::vector<Scalar>& step) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (sparse_) return sparse_->solve(problem, state, step);
  }
  assemble(problem, state);
  step = state.curvature;
  Scalar shift = 0;
  for (int attempt = 0; !factor(shift); ++attempt) {
    if (attempt == shift_attempts) return;
    shift = shift == 0 ? Scalar(1e-6) : Scalar(100 * shift);
  }
  for (int i = 0; i < size_; ++i)
    for (int j = 0; j < i; ++j) step[i] -= factor_[i * size_ + j] * step[j];
  for (int i = 0; i < size_; ++i) step[i] /= factor_[i * size_ + i];
  for (int i = size_ - 1; i >= 0; --i)
    for (int j = i + 1; j < size_; ++j) step[i] -= factor_[j * size_ + i] * step[j];
}

#define TETRARCH_INSTANTIATE(Scalar) template class NewtonSystem<Scalar>;
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::hyperbolic
