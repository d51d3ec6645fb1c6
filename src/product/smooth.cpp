// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/smooth.hpp"

#include "hexahedron.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/hex_jacobian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

constexpr std::array<std::array<int, 2>, 12> hex_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The axes, then the diagonals of a cube, both ways.
std::array<Vector, 14> search_directions() {
  std::array<Vector, 14> result{};
  for (std::size_t k = 0; k < 6; ++k) result[k][k / 2] = k % 2 == 0 ? 1 : -1;
  const double part = 1 / std::sqrt(3.0);
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t c = 0; c < 3; ++c) result[6 + k][c] = (k >> c & 1U) != 0 ? part : -part;
  return result;
}

/// While there are bad hexahedra, others are good enough from here on.
constexpr double untangled = 0.2;

class Smoother {
public:
  Smoother(HexMesh& mesh, const SmoothOptions& options)
      : mesh_(mesh), options_(options), around_(mesh.points.size()), directions_(search_directions()) {
    for (int h = 0; h < static_cast<int>(mesh.hexahedra.size()); ++h)
      for (int c = 0; c < 8; ++c) around_[mesh.hexahedra[h][c]].push_back({h, c});
  }

  /// `lowest`: the least scaled Jacobian of all hexahedra.
  void set_tangled(bool is_tangled, double lowest) {
    is_tangled_ = is_tangled;
    lowest_ = lowest;
  }

  /// Whether the point has moved.
  bool improve(int v) {
    if (around_[v].empty()) return false;
    const double before = score(v);
    if (is_tangled_ && before == 0) return false;
    const Neighbors near = neighbors(v);
    const Vector to_middle = near.middle - mesh_.points[v];
    double now = before;
    for (const double part : {1.0, 0.5})
      if (try_step(v, part * to_middle, now)) break;
    if (now < (is_tangled_ ? 0 : options_.search_below)) search(v, near.mean_length, now);
    return now > before;
  }

private:
  struct Corner {
    int hexahedron = 0;
    int corner = 0;
  };
  struct Neighbors {
    Vector middle{};
    double mean_length = 0;
  };

  /// Along edges; those of several hexahedra count as often.
  Neighbors neighbors(int v) const {
    Neighbors result;
    int count = 0;
    for (const auto& [h, corner] : around_[v])
      for (const auto& [i, j] : hex_edges) {
        if (i != corner && j != corner) continue;
        const Vector& other = mesh_.points[mesh_.hexahedra[h][i == corner ? j : i]];
        result.middle = result.middle + other;
        result.mean_length += norm(other - mesh_.points[v]);
        ++count;
      }
    result.middle = 1.0 / count * result.middle;
    result.mean_length /= count;
    return result;
  }

  /// The worst around a point; among tangled hexahedra, minus all that is lacking around it, or a hopeless
  /// value where one becomes worse than the worst of all. A value that is no greater than `floor` may be any
  /// such: most places that are tried are given up at the first hexahedron, before its inside is looked at.
  double score(int v, double floor = -std::numeric_limits<double>::infinity()) const {
    double least = 1;
    double lacking = 0;
    for (const auto& [h, corner] : around_[v]) {
      const std::array<Point, 8> corners = mesh_.corners(h);
      double j = sampled_jacobian(corners);
      if (!is_tangled_ && j <= floor) return j;
      if (j > 0 && !is_positive_inside(corners)) j = 0;
      least = std::min(least, j);
      lacking += std::max(0.0, untangled - j);
      if ((is_tangled_ ? -lacking : least) <= floor) return is_tangled_ ? -lacking : least;
    }
    if (!is_tangled_) return least;
    return least < lowest_ ? -9.0 * static_cast<double>(around_[v].size()) : -lacking;
  }

  /// Moves the point if the worst around becomes better, and says so.
  bool try_step(int v, const Vector& step, double& now) {
    const Point before = mesh_.points[v];
    mesh_.points[v] = options_.brought_back ? options_.brought_back(v, before + step) : before + step;
    const double there = score(v, now + options_.least_gain);
    if (there > now + options_.least_gain) {
      now = there;
      return true;
    }
    mesh_.points[v] = before;
    return false;
  }

  void search(int v, double length, double& now) {
    constexpr int halvings = 6;
    constexpr int most_steps = 8;
    double step = length / 4;
    for (int halving = 0; halving < halvings; ++halving, step /= 2)
      for (int k = 0; k < most_steps; ++k) {
        bool moved = false;
        for (const Vector& direction : directions_) moved |= try_step(v, step * direction, now);
        if (!moved) break;
      }
  }

  HexMesh& mesh_;
  const SmoothOptions& options_;
  bool is_tangled_ = false;
  double lowest_ = -1;
  std::vector<std::vector<Corner>> around_; ///< of each point
  std::array<Vector, 14> directions_;
};

} // namespace

Smoothed smooth(HexMesh& mesh, const std::vector<char>& fixed, const SmoothOptions& options,
                const Progress& progress) {
  if (fixed.size() != mesh.points.size())
    throw PreconditionError("smooth: each point needs a flag that says whether it is fixed");
  Smoothed result;
  const HexQuality before = quality(mesh);
  result.minimum_before = before.minimum;
  result.bad_before = static_cast<int>(before.bad.size());
  const std::vector<Point> start = mesh.points;
  std::vector<Point> best_points = start;
  HexQuality best = before;
  Smoother smoother(mesh, options);
  bool is_tangled = true;
  HexQuality now = before;
  for (bool moving = true; moving && result.sweeps < options.most_sweeps; ++result.sweeps) {
    if (is_tangled) {
      is_tangled = !now.bad.empty();
      smoother.set_tangled(is_tangled, now.minimum);
    }
    moving = false;
    for (std::size_t v = 0; v < fixed.size(); ++v) {
      if (v % 1024 == 0) progress.step("smoothing", result.sweeps / static_cast<double>(options.most_sweeps));
      if (fixed[v] != 0 || !smoother.improve(static_cast<int>(v))) continue;
      moving = true;
    }
    now = quality(mesh);
    if (is_better(now, best)) {
      best = now;
      best_points = mesh.points;
    }
    if (is_tangled && !moving) { // what cannot be untangled stays so
      is_tangled = false;
      moving = true;
      smoother.set_tangled(false, -1);
    }
  }
  result.minimum_after = best.minimum;
  result.bad_after = static_cast<int>(best.bad.size());
  for (std::size_t v = 0; v < start.size(); ++v) result.moved += best_points[v] == start[v] ? 0 : 1;
  mesh.points = std::move(best_points);
  return result;
}

} // namespace tetrarch::product
