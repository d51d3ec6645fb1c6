// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/matching.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;

/// w = scale / (z - pole), for a pole on no circle.
Circle inverted(const Circle& circle, Complex pole, double scale) {
  const Complex from = circle.center - pole;
  const double power = std::norm(from) - circle.radius * circle.radius;
  return {scale * std::conj(from) / power, scale * circle.radius / std::abs(power), circle.circularity};
}

/// w = (z - p) / (1 - conj(p) z): the center is the image of what is inverse to the pole.
Circle moved_in_disk(const Circle& circle, Complex p) {
  const Complex q = circle.center;
  const double r = circle.radius;
  const Complex inverse = q + r * r * p / (1.0 - p * std::conj(q));
  const double power = std::norm(1.0 - std::conj(p) * q) - r * r * std::norm(p);
  return {(inverse - p) / (1.0 - std::conj(p) * inverse), r * (1 - std::norm(p)) / std::abs(power),
          circle.circularity};
}

/// -log of the radius that circle k has once it is about 0 and circle j is the unit circle.
double modulus(const std::vector<Circle>& circles, std::size_t j, std::size_t k) {
  const Circle& a = circles[j];
  const Circle& b = circles[k];
  // The inversive distance is the hyperbolic cosine of the modulus.
  const double between = std::norm(a.center - b.center) - a.radius * a.radius - b.radius * b.radius;
  return std::acosh(std::max(1.0, std::abs(between) / (2 * a.radius) / b.radius));
}

/// The assignment of least sum, by shortest augmenting paths. Source: Kuhn, "The Hungarian method for the
/// assignment problem" (1955). O(m^3).
std::vector<int> assigned(const std::vector<std::vector<double>>& cost) {
  const auto m = static_cast<int>(cost.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> row_price(m + 1, 0);
  std::vector<double> column_price(m + 1, 0);
  std::vector<int> row_of(m + 1, 0); // columns and rows count from 1; 0 stands for none
  for (int row = 1; row <= m; ++row) {
    std::vector<double> least(m + 1, infinity);
    std::vector<int> before(m + 1, 0);
    std::vector<char> used(m + 1, 0);
    row_of[0] = row;
    int column = 0;
    while (row_of[column] != 0) {
      used[column] = 1;
      double step = infinity;
      int next = 0;
      for (int j = 1; j <= m; ++j) {
        if (used[j] != 0) continue;
        const double reduced = cost[row_of[column] - 1][j - 1] - row_price[row_of[column]] - column_price[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          before[j] = column;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      for (int j = 0; j <= m; ++j)
        if (used[j] != 0) {
          row_price[row_of[j]] += step;
          column_price[j] -= step;
        } else {
          least[j] -= step;
        }
      column = next;
    }
    for (; column != 0; column = before[column]) row_of[column] = row_of[before[column]];
  }
  std::vector<int> result(m, 0);
  for (int j = 1; j <= m; ++j) result[row_of[j] - 1] = j - 1;
  return result;
}

double square(double x) {
  return x * x;
}

/// The circles but the first two, that of A and those of B, normalised alike.
class Comparison {
public:
  Comparison(const std::vector<Circle>& a, const std::vector<Circle>& b) : a_(a), b_(b) {}

  /// Between circle j of A and circle k of B turned.
  double difference(std::size_t j, std::size_t k, Complex turn) const {
    return std::norm(a_[j].center - turn * b_[k].center) + square(a_[j].radius - b_[k].radius);
  }

  /// No assignment is better at this turn.
  double bound(Complex turn) const {
    double sum = 0;
    for (std::size_t j = 2; j < a_.size(); ++j) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 2; k < b_.size(); ++k) least = std::min(least, difference(j, k, turn));
      sum += least;
    }
    return sum;
  }

  /// Of each circle of A the one of B, at this turn.
  std::vector<std::size_t> assignment(Complex turn) const {
    std::vector<std::vector<double>> cost(a_.size() - 2, std::vector<double>(a_.size() - 2, 0));
    for (std::size_t j = 2; j < a_.size(); ++j)
      for (std::size_t k = 2; k < b_.size(); ++k) cost[j - 2][k - 2] = difference(j, k, turn);
    std::vector<std::size_t> result{0, 1};
    for (const int k : assigned(cost)) result.push_back(static_cast<std::size_t>(k) + 2);
    return result;
  }

  Complex best_turn(const std::vector<std::size_t>& to) const {
    Complex product = 0;
    for (std::size_t j = 2; j < a_.size(); ++j) product += a_[j].center * std::conj(b_[to[j]].center);
    return product == 0.0 ? 1.0 : product / std::abs(product);
  }

  double distance(const std::vector<std::size_t>& to, Complex turn) const {
    double sum = square(a_[1].radius - b_[1].radius);
    for (std::size_t j = 2; j < a_.size(); ++j) sum += difference(j, to[j], turn);
    return std::sqrt(sum);
  }

private:
  const std::vector<Circle>& a_;
  const std::vector<Circle>& b_;
};

/// The best ones so far, each once.
class Ranking {
public:
  explicit Ranking(std::size_t most) : most_(most) {}

  double limit() const {
    return found_.size() < most_ ? std::numeric_limits<double>::infinity() : found_.back().distance;
  }

  void add(Matching matching) {
    const auto same = std::find_if(found_.begin(), found_.end(), [&](const Matching& m) {
      return m.to == matching.to && m.mirrored == matching.mirrored;
    });
    if (same != found_.end()) {
      if (same->distance <= matching.distance) return;
      found_.erase(same);
    }
    const auto after =
        std::upper_bound(found_.begin(), found_.end(), matching.distance,
                         [](double distance, const Matching& m) { return distance < m.distance; });
    found_.insert(after, std::move(matching));
    if (found_.size() > most_) found_.pop_back();
  }

  std::vector<Matching> take() { return std::move(found_); }

private:
  std::size_t most_;
  std::vector<Matching> found_;
};

/// Pairs of circles of B in the order in which their moduli come near A's.
std::vector<std::pair<std::size_t, std::size_t>> pairs(const std::vector<Circle>& a,
                                                       const std::vector<Circle>& b) {
  const double wanted = modulus(a, 0, 1);
  std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> ranked;
  for (std::size_t j = 0; j < b.size(); ++j)
    for (std::size_t k = 0; k < b.size(); ++k)
      if (j != k) ranked.push_back({std::abs(modulus(b, j, k) - wanted), {j, k}});
  std::sort(ranked.begin(), ranked.end());
  // Each takes about n^3 operations, but for the few that are worth an assignment for each turn.
  constexpr double budget = 1e8;
  const double n = static_cast<double>(b.size());
  const auto affordable = static_cast<std::size_t>(std::clamp(budget / (n * n * n), 4.0, 600.0));
  ranked.resize(std::min(ranked.size(), affordable));
  std::vector<std::pair<std::size_t, std::size_t>> result;
  result.reserve(ranked.size());
  for (const auto& [rank, pair] : ranked) result.push_back(pair);
  return result;
}

/// All turns that take some circle of B to the direction of A's anchor.
void rank_turns(const std::vector<Circle>& a, const std::vector<Circle>& b, std::size_t outer,
                std::size_t inner, bool mirrored, Ranking& ranking) {
  const Comparison comparison(a, b);
  std::vector<int> number{static_cast<int>(outer), static_cast<int>(inner)}; // in the order of normalised()
  for (std::size_t j = 0; j < b.size(); ++j)
    if (j != outer && j != inner) number.push_back(static_cast<int>(j));
  const auto add = [&](const std::vector<std::size_t>& to) {
    Matching m;
    for (const std::size_t k : to) m.to.push_back(number[k]);
    m.mirrored = mirrored;
    m.distance = comparison.distance(to, comparison.best_turn(to));
    ranking.add(std::move(m));
  };
  const double own = square(a[1].radius - b[1].radius);
  if (a.size() == 2) return add({0, 1});
  std::size_t anchor = 2;
  for (std::size_t j = 3; j < a.size(); ++j)
    if (std::abs(a[j].center) > std::abs(a[anchor].center)) anchor = j;
  for (std::size_t k = 2; k < b.size(); ++k) {
    Complex turn = a[anchor].center * std::conj(b[k].center);
    turn /= std::abs(turn);
    // The anchor itself limits how far a better turn can be from this one; twice as much is allowed for.
    if (std::sqrt(own + comparison.bound(turn)) > 2 * ranking.limit()) continue;
    std::vector<std::size_t> to = comparison.assignment(turn);
    for (int round = 0; round < 3; ++round) to = comparison.assignment(comparison.best_turn(to));
    add(to);
  }
}

} // namespace

std::vector<Circle> normalised(std::vector<Circle> circles, std::size_t outer, std::size_t inner) {
  if (outer == inner || outer >= circles.size() || inner >= circles.size())
    throw PreconditionError("a domain has an outer and an inner circle");
  if (outer != 0) {
    const Circle hole = circles[outer];
    for (Circle& c : circles) c = inverted(c, hole.center, hole.radius);
    circles[outer] = {0, 1, hole.circularity};
  }
  const Circle middle = circles[inner];
  if (const double c = std::abs(middle.center); c > 0) {
    // p and 1 / conj(p) are inverse to one another in both circles: |p| + 1 / |p| = (1 + c^2 - r^2) / c.
    const double sum = (1 + c * c - middle.radius * middle.radius) / c;
    const Complex p = middle.center / c * (2 / (sum + std::sqrt((sum - 2) * (sum + 2))));
    for (Circle& one : circles) one = moved_in_disk(one, p);
    circles[outer] = {0, 1, circles[outer].circularity};
    circles[inner].center = 0;
  }
  std::vector<Circle> result{circles[outer], circles[inner]};
  for (std::size_t k = 0; k < circles.size(); ++k)
    if (k != outer && k != inner) result.push_back(circles[k]);
  return result;
}

std::vector<Matching> best_matchings(const std::vector<Circle>& a, const std::vector<Circle>& b,
                                     const MatchingOptions& options) {
  if (a.size() != b.size() || a.size() < 2)
    throw InputError("surfaces with " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                     " boundary loops cannot be matched");
  Ranking ranking(options.most);
  for (const bool mirrored : {false, true}) {
    if (mirrored && !options.with_mirror_images) break;
    for (const auto& [outer, inner] : pairs(a, b)) {
      std::vector<Circle> circles = normalised(b, outer, inner);
      if (square(a[1].radius - circles[1].radius) > square(ranking.limit())) continue;
      if (mirrored)
        for (Circle& c : circles) c.center = std::conj(c.center);
      rank_turns(a, circles, outer, inner, mirrored, ranking);
    }
  }
  return ranking.take();
}

} // namespace tetrarch::slit
