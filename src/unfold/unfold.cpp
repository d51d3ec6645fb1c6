// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/unfold/unfold.hpp"

#include "lbfgs.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::unfold {
namespace {

using namespace numeric;

/// Once nothing is folded; and the least that an epsilon may become on the way there.
constexpr double settled = 1e-9;
/// By so much, at least, the wall grows in a round.
constexpr double least_progress = 0.1;

/// Points that may move, as one list of numbers.
class Movable {
public:
  Movable(const Problem& problem, std::vector<Point> points) : problem_(problem), points_(std::move(points)) {
    for (int v = 0; v < static_cast<int>(points_.size()); ++v)
      if (problem.freedom[v].kind != Freedom::Kind::fixed) moving_.push_back(v);
    const auto is_fixed = [&](int v) { return problem.freedom[v].kind == Freedom::Kind::fixed; };
    for (const Brick& b : problem.bricks)
      if (!std::all_of(b.corner.begin(), b.corner.end(), is_fixed)) bricks_.push_back(b);
    find_blocks();
  }
  const std::vector<Point>& points() const { return points_; }
  Values values() const {
    Values x;
    x.reserve(3 * moving_.size());
    for (const int v : moving_) x.insert(x.end(), points_[v].begin(), points_[v].end());
    return x;
  }
  void place(const Values& x) {
    for (std::size_t k = 0; k < moving_.size(); ++k)
      for (std::size_t a = 0; a < 3; ++a) points_[moving_[k]][a] = x[3 * k + a];
  }
  double energy(const Values& x, Values& gradient, double theta, double epsilon) {
    place(x);
    double value = unfold::energy(problem_.elements, points_, theta, epsilon, &all_);
    value += add_energy(bricks_, points_, theta, epsilon, all_);
    for (const Pull& pull : problem_.pulls) {
      const Vector away = pull.away(points_[pull.point]);
      value += pull.weight * dot(away, away);
      all_[pull.point] = all_[pull.point] + 2 * pull.weight * away;
    }
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      const Vector allowed = problem_.freedom[moving_[k]].allowed(all_[moving_[k]]);
      std::copy(allowed.begin(), allowed.end(), gradient.begin() + static_cast<std::ptrdiff_t>(3 * k));
    }
    return value;
  }

  /// Each point by itself: as if the energy were the square of J, beside the springs.
  void precondition(Values& x) const {
    for (std::size_t k = 0; k < moving_.size(); ++k) {
      const Matrix& m = block_[k];
      const Vector v{x[3 * k], x[3 * k + 1], x[3 * k + 2]};
      const Vector allowed = problem_.freedom[moving_[k]].allowed({dot(m[0], v), dot(m[1], v), dot(m[2], v)});
      std::copy(allowed.begin(), allowed.end(), x.begin() + static_cast<std::ptrdiff_t>(3 * k));
    }
  }

private:
  using Matrix = std::array<Vector, 3>;

  static Matrix inverse(const Matrix& m) {
    const std::array<Vector, 3> cofactors{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    const double determinant = dot(m[0], cofactors[0]);
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) result[i][j] = cofactors[j][i] / determinant;
    return result;
  }

  void find_blocks() {
    std::vector<Matrix> all(points_.size());
    const auto add = [&](int v, double weight) {
      for (std::size_t a = 0; a < 3; ++a) all[v][a][a] += 2 * weight;
    };
    for (const Element& e : problem_.elements) {
      Vector first{};
      for (std::size_t k = 0; k < 3; ++k) {
        first = first - e.inverse[k];
        add(e.corner[k + 1], e.weight * dot(e.inverse[k], e.inverse[k]));
      }
      add(e.corner[0], e.weight * dot(first, first));
    }
    // Each point is the end of one edge along each axis, at four corners of the brick in all: at its own and
    // at those of its neighbors.
    for (const Brick& b : bricks_)
      for (const int v : b.corner) add(v, 2 * b.weight * dot(b.inverse, b.inverse));
    for (const Pull& pull : problem_.pulls)
      for (std::size_t a = 0; a < 3; ++a) {
        Vector axis{};
        axis[a] = 1;
        all[pull.point][a] = all[pull.point][a] + 2 * pull.weight * (axis - pull.held.allowed(axis));
      }
    for (const int v : moving_) {
      Matrix& m = all[v];
      const bool is_loose = !(m[0][0] > 0); // in no element and on no spring: it stays
      block_.push_back(is_loose ? Matrix{} : inverse(m));
    }
  }

  const Problem& problem_;
  std::vector<Point> points_;
  std::vector<Brick> bricks_; ///< those with a point that moves
  std::vector<int> moving_;
  std::vector<Matrix> block_; ///< of each that moves
  std::vector<Vector> all_;
};

double chi(double d, double epsilon) {
  return (d + std::hypot(d, epsilon)) / 2;
}

/// The next epsilon: chi of the worst element falls by the part of the energy that the round has gained.
double tightened(double epsilon, double worst, double gained) {
  const double wanted = (1 - std::clamp(gained, least_progress, 0.9)) * chi(worst, epsilon);
  return worst < wanted ? std::max(settled, 2 * std::sqrt(wanted * (wanted - worst))) : settled;
}

int folded(const std::vector<double>& determinants) {
  return static_cast<int>(
      std::count_if(determinants.begin(), determinants.end(), [](double d) { return !(d > 0); }));
}

std::vector<double> determinants(const Problem& problem, const std::vector<Point>& points) {
  std::vector<double> result = unfold::determinants(problem.elements, points);
  const std::vector<double> of_bricks = unfold::determinants(problem.bricks, points);
  result.insert(result.end(), of_bricks.begin(), of_bricks.end());
  return result;
}

void require(const Problem& problem, const std::vector<Point>& start) {
  if (problem.freedom.size() != start.size()) throw PreconditionError("unfold: each point needs its freedom");
  const int count = static_cast<int>(start.size());
  for (const Element& e : problem.elements)
    for (const int v : e.corner)
      if (v < 0 || v >= count) throw PreconditionError("unfold: a corner is none of the points");
  for (const Brick& b : problem.bricks)
    for (const int v : b.corner)
      if (v < 0 || v >= count) throw PreconditionError("unfold: a corner is none of the points");
  for (const Pull& pull : problem.pulls)
    if (pull.point < 0 || pull.point >= count)
      throw PreconditionError("unfold: what is pulled is none of the points");
}

} // namespace

Unfolded unfold(const Problem& problem, std::vector<Point> start, const Options& options,
                const Progress& progress) {
  require(problem, start);
  Unfolded result;
  std::vector<double> all = determinants(problem, start);
  result.folded_before = result.folded_after = folded(all);
  if (all.empty()) {
    result.last = start;
    result.points = std::move(start);
    return result;
  }
  double worst = *std::min_element(all.begin(), all.end());
  result.least_determinant = worst;
  result.points = start;
  Movable movable(problem, std::move(start));
  Values x = movable.values();
  double epsilon = worst > 0 ? settled : options.reach * std::max(1.0, std::hypot(worst, 0.1));
  int idle = 0;
  for (; result.rounds < options.most_rounds && !x.empty(); ++result.rounds) {
    const auto f = [&](const Values& at, Values& gradient) {
      return movable.energy(at, gradient, options.theta, epsilon);
    };
    Values gradient(x.size());
    const double before = f(x, gradient);
    if (!std::isfinite(before)) break;
    const double part = result.rounds / static_cast<double>(options.most_rounds);
    const Descent done = minimize(
        f, x, options.iterations, options.flat, [&] { progress.step("unfolding", part); },
        [&](Values& at) { movable.precondition(at); });
    result.iterations += done.iterations;
    movable.place(x);
    all = determinants(problem, movable.points());
    worst = *std::min_element(all.begin(), all.end());
    const int now = folded(all);
    const double gained = 1 - done.value / before;
    idle = gained < options.flat && now >= result.folded_after ? idle + 1 : 0;
    if (now <= result.folded_after) {
      result.folded_after = now;
      result.points = movable.points();
      result.least_determinant = worst;
    }
    if (idle >= options.most_idle_rounds || (worst > 0 && epsilon <= settled && gained < options.least_gain))
      break;
    epsilon = tightened(epsilon, worst, gained);
  }
  result.last = movable.points();
  return result;
}

} // namespace tetrarch::unfold
