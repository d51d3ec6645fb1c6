// SPDX-License-Identifier: GPL-2.0-or-later
#include "signed_path.hpp"

#include "tetrarch/numeric/maximum.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetrarch::hyperbolic {
namespace {

/// Defects that count as none: on the way, and at the end.
constexpr double solved_on_the_way = 1e-9;
constexpr double solved_at_the_end = 1e-13;
/// No angle changes by more in one step: which of its values is meant would be a guess.
constexpr double largest_turn = 1.5;
/// Steps at one parameter; the first one comes from far away.
constexpr int most_first_steps = 80;
constexpr int most_later_steps = 25;
/// How far the parameter moves, and the least it may.
constexpr double first_move = 0.1;
constexpr double largest_move = 0.25;
constexpr double least_move = 1e-4;

double largest_change(const AngleTable<double>& a, const AngleTable<double>& b) {
  double largest = 0;
  for (std::size_t t = 0; t < a.size(); ++t)
    for (int e = 0; e < 6; ++e) largest = numeric::maximum(largest, std::abs(a[t][e] - b[t][e]));
  return largest;
}

class Follower {
public:
  Follower(const Problem& problem, const SignedSystem& system, const std::vector<bool>& divided,
           int most_steps, const Progress& progress)
      : problem_(problem), system_(system), divided_(divided), most_steps_(most_steps), progress_(progress),
        target_(static_cast<std::size_t>(problem.edges())) {}

  SignedPath run(double first) {
    path_.state = system_.start();
    double at = first;
    if (!settle(at, most_first_steps, solved_on_the_way, true)) return std::move(path_);
    double move = first_move;
    while (at > 1) {
      const double next = std::max(1.0, at - move);
      const SignedState before = path_.state;
      if (settle(next, most_later_steps, next == 1 ? solved_at_the_end : solved_on_the_way, false)) {
        at = next;
        move = std::min(1.5 * move, largest_move);
        continue;
      }
      path_.state = before;
      move = std::min(move, at - next) / 2;
      if (move < least_move || path_.steps >= most_steps_) return std::move(path_);
    }
    path_.arrived = true;
    return std::move(path_);
  }

private:
  void set_targets(double divisor) {
    for (int e = 0; e < problem_.edges(); ++e)
      target_[e] =
          problem_.is_null(e) ? 0 : 2 * std::numbers::pi / problem_.order[e] / (divided_[e] ? divisor : 1);
  }

  /// Newton's method on the defects, damped where they would grow. True if they end below `goal`.
  bool settle(double divisor, int most, double goal, bool anew) {
    set_targets(divisor);
    SignedState& now = path_.state;
    if (!system_.evaluate(target_, now.angles, now)) return false;
    for (int step = 0; step < most && path_.steps < most_steps_; ++step, ++path_.steps) {
      progress_.step("homotopy");
      const double size = now.defects.lpNorm<Eigen::Infinity>();
      if (size <= goal) break;
      if (!advance(anew && step == 0)) return settled(divisor, size <= 100 * goal);
    }
    return settled(divisor, now.defects.lpNorm<Eigen::Infinity>() <= goal);
  }

  bool settled(double divisor, bool yes) {
    if (yes) path_.reached = divisor;
    return yes;
  }

  /// One step to where the defects are smaller; false if there is none.
  bool advance(bool from_the_start) {
    SignedState& now = path_.state;
    const Eigen::MatrixXd gram = now.jacobian * now.jacobian.transpose();
    const double before = now.defects.squaredNorm();
    const double scale = gram.diagonal().maxCoeff();
    double damping = 1e-13 * scale;
    for (int attempt = 0; attempt < 12; ++attempt, damping *= 20) {
      Eigen::MatrixXd damped = gram;
      damped.diagonal().array() += damping;
      const Eigen::LLT<Eigen::MatrixXd> factor(damped);
      if (factor.info() != Eigen::Success) continue;
      SignedState next;
      next.unknowns = now.unknowns - now.jacobian.transpose() * factor.solve(now.defects);
      if (!system_.evaluate(target_, now.angles, next)) continue;
      if (!from_the_start && largest_change(next.angles, now.angles) > largest_turn) continue;
      if (!(next.defects.squaredNorm() < before)) continue;
      now = std::move(next);
      return true;
    }
    return false;
  }

  const Problem& problem_;
  const SignedSystem& system_;
  const std::vector<bool>& divided_;
  int most_steps_;
  const Progress& progress_;
  std::vector<double> target_;
  SignedPath path_;
};

} // namespace

SignedPath follow_path(const Problem& problem, const SignedSystem& system, const std::vector<bool>& divided,
                       double first, int most_steps, const Progress& progress) {
  return Follower(problem, system, divided, most_steps, progress).run(first);
}

} // namespace tetrarch::hyperbolic
