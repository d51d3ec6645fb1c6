// SPDX-License-Identifier: GPL-2.0-or-later
#include "packing.hpp"

#include "tetrarch/numeric/maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tetrarch::diagram {
namespace {

/// How far the factor of relaxation stays from 2, in units of one over the diameter; tuned on closed braids
/// of 100 to 3,000 crossings.
constexpr double relaxation_gap = 2;

class Packing {
public:
  Packing(const std::vector<std::vector<int>>& flowers, const std::vector<bool>& boundary)
      : relaxation_(2 / (1 + relaxation_gap / std::sqrt(static_cast<double>(flowers.size())))),
        flowers_(flowers), boundary_(boundary), circles_(flowers.size()) {}

  std::vector<PackedCircle> run(const Progress& progress) {
    constexpr int most_sweeps = 20'000;
    constexpr double good = 1e-9;
    constexpr double near = 0.3; // an error of angle sums from which on the equations are as good as linear
    double least = std::numeric_limits<double>::infinity();
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      if (sweep % 16 == 0) progress.step("circles packed", -1);
      const double worst = improve(least < near ? relaxation_ : 1);
      if (worst < good) break;
      // Too much of it may diverge where the radii are far from the solution.
      constexpr double divergence = 4;
      if (worst > divergence * least) {
        relaxation_ = 1 + (relaxation_ - 1) / 2;
        least = worst;
      }
      least = std::min(least, worst);
    }
    place();
    return std::move(circles_);
  }

private:
  /// The angle at a circle of radius r in the triangle with two more of these radii.
  static double angle(double r, double a, double b) {
    return 2 * std::asin(std::sqrt(std::min(1.0, a / (r + a) * b / (r + b))));
  }

  double angle_sum(int v) const {
    double sum = 0;
    const auto& ring = flowers_[v];
    for (std::size_t k = 0; k < ring.size(); ++k)
      sum +=
          angle(circles_[v].radius, circles_[ring[k]].radius, circles_[ring[(k + 1) % ring.size()]].radius);
    return sum;
  }

  /// Each interior circle as if its neighbors were of one size that gives the same angles (uniform neighbor
  /// model), and further in that direction. Returns the largest error of an angle sum.
  double improve(double relaxation) {
    double worst = 0;
    for (int v = 0; v < static_cast<int>(flowers_.size()); ++v) {
      if (boundary_[v]) continue;
      const double sum = angle_sum(v);
      worst = numeric::maximum(worst, std::fabs(sum - 2 * std::numbers::pi));
      const double count = 2 * static_cast<double>(flowers_[v].size());
      const double beta = std::sin(sum / count);
      const double delta = std::sin(2 * std::numbers::pi / count);
      const double uniform = beta / (1 - beta) * circles_[v].radius;
      const double better = uniform * (1 - delta) / delta;
      circles_[v].radius *= std::pow(better / circles_[v].radius, relaxation);
    }
    return worst;
  }

  /// Circle after circle: once two neighbors lie, the next one of the flower is known.
  void place() {
    std::vector<bool> placed(flowers_.size(), false);
    const auto first =
        static_cast<int>(std::find(boundary_.begin(), boundary_.end(), false) - boundary_.begin());
    const int second = flowers_[first].front();
    circles_[first].center = {0, 0};
    circles_[second].center = {circles_[first].radius + circles_[second].radius, 0};
    placed[first] = placed[second] = true;
    std::vector<int> queue{first};
    std::vector<bool> queued(flowers_.size(), false);
    queued[first] = true;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const int v = queue[k];
      place_flower(v, placed);
      for (const int w : flowers_[v])
        if (!queued[w] && !boundary_[w]) {
          queued[w] = true;
          queue.push_back(w);
        }
    }
  }

  void place_flower(int v, std::vector<bool>& placed) {
    const auto& ring = flowers_[v];
    const auto start = static_cast<std::size_t>(
        std::find_if(ring.begin(), ring.end(), [&](int w) { return placed[w]; }) - ring.begin());
    const PackedCircle& center = circles_[v];
    const PlanePoint& at = circles_[ring[start]].center;
    double direction = std::atan2(at[1] - center.center[1], at[0] - center.center[0]);
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
      const int here = ring[(start + k) % ring.size()];
      const int next = ring[(start + k + 1) % ring.size()];
      direction += angle(center.radius, circles_[here].radius, circles_[next].radius);
      if (placed[next]) continue;
      const double far = center.radius + circles_[next].radius;
      circles_[next].center = {center.center[0] + far * std::cos(direction),
                               center.center[1] + far * std::sin(direction)};
      placed[next] = true;
    }
  }

  /// Over-relaxation of the logarithms of radii. Near the solution these are a discrete Laplace equation, for
  /// which sweeps grow as the diameter with a factor this near to 2, and as its square with 1.
  double relaxation_ = 1;

  const std::vector<std::vector<int>>& flowers_;
  const std::vector<bool>& boundary_;
  std::vector<PackedCircle> circles_;
};

} // namespace

std::vector<PackedCircle> packed(const std::vector<std::vector<int>>& flowers,
                                 const std::vector<bool>& boundary, const Progress& progress) {
  return Packing(flowers, boundary).run(progress);
}

} // namespace tetrarch::diagram
