// SPDX-License-Identifier: GPL-2.0-or-later
#include "vertex_scaling.hpp"

#include "tetrarch/numeric/maximum.hpp"

#include "full_turn.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetrarch::slit {
namespace {

using surface::Side;

constexpr double half_turn = full_turn / 2;

/// The tangent of half the angle opposite a side; infinite or 0 where the triangle inequality fails.
double half_tangent(const std::vector<double>& length, Side s) {
  const double a = length[s.value];
  const double b = length[s.next().value];
  const double c = length[s.previous().value];
  const double near = (a + b - c) * (a - (b - c));
  const double far = (a + b + c) * (b + c - a);
  // NaN, from numbers that overflow, is passed on.
  if (far <= 0) return HUGE_VAL;
  return near <= 0 ? 0 : std::sqrt(near / far);
}

/// Half the arc over a side of a polygon inscribed in a circle with the centre inside.
double half_arc(double side, double radius) {
  return std::asin(std::min(side / (2 * radius), 1.0));
}

double greatest(const std::vector<double>& x) {
  double most = 0;
  for (const double value : x) most = numeric::maximum(most, std::abs(value));
  return most;
}

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.0);
}

/// Entries of a symmetric matrix as they come.
class Assembly {
public:
  explicit Assembly(const std::vector<char>& held) : held_(held), columns_(held.size()) {
    for (std::size_t j = 0; j < held.size(); ++j)
      columns_[j].emplace_back(static_cast<int>(j), held[j] ? 1.0 : 0.0);
  }

  /// Rows that are held are those of the unit matrix.
  void add(int i, int j, double value) {
    if (held_[i] || held_[j]) value = 0;
    columns_[std::min(i, j)].emplace_back(std::max(i, j), value);
  }

  numeric::SymmetricMatrix matrix() {
    numeric::SymmetricMatrix out;
    for (auto& column : columns_) {
      out.first.push_back(static_cast<int>(out.row.size()));
      std::stable_sort(column.begin(), column.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& [row, value] : column) {
        if (static_cast<int>(out.row.size()) > out.first.back() && out.row.back() == row) {
          out.value.back() += value;
        } else {
          out.row.push_back(row);
          out.value.push_back(value);
        }
      }
    }
    out.first.push_back(static_cast<int>(out.row.size()));
    return out;
  }

private:
  const std::vector<char>& held_;
  std::vector<std::vector<std::pair<int, double>>> columns_;
};

} // namespace

double angle_opposite(const std::vector<double>& length, Side s) {
  return 2 * std::atan(half_tangent(length, s));
}

std::vector<Side> boundary_sides(const surface::Surface& surface) {
  std::vector<Side> result(static_cast<std::size_t>(surface.vertex_count()));
  for (int k = 0; k < surface.side_count(); ++k)
    if (surface.is_boundary(Side(k))) result[surface.from(Side(k))] = Side(k);
  return result;
}

std::vector<double> curvatures_of(const surface::IntrinsicTriangulation& metric) {
  std::vector<double> curvature;
  for (const Side s : boundary_sides(metric.surface)) curvature.push_back(s.exists() ? half_turn : full_turn);
  for (int k = 0; k < metric.surface.side_count(); ++k)
    curvature[metric.surface.apex(Side(k))] -= angle_opposite(metric.length, Side(k));
  return curvature;
}

VertexScaling::VertexScaling(surface::IntrinsicTriangulation start, std::vector<char> held,
                             const std::vector<int>& round_holes)
    : metric_(std::move(start)), unscaled_(metric_.length), held_(std::move(held)), u_(held_.size(), 0.0) {
  const std::vector<Side> out = boundary_sides(metric_.surface);
  for (const int first : round_holes) {
    std::vector<int> loop;
    double circumference = 0;
    for (int v = first; loop.empty() || v != first; v = metric_.surface.to(out[v])) {
      loop.push_back(v);
      circumference += metric_.length[out[v].value];
    }
    round_.push_back(std::move(loop));
    held_.push_back(0);
    u_.push_back(std::log(circumference / full_turn));
  }
}

std::vector<double> VertexScaling::lengths(const std::vector<double>& log_scale) const {
  std::vector<double> length(unscaled_.size());
  for (int k = 0; k < metric_.surface.side_count(); ++k)
    length[k] =
        unscaled_[k] *
        std::exp((log_scale[metric_.surface.from(Side(k))] + log_scale[metric_.surface.to(Side(k))]) / 2);
  return length;
}

void VertexScaling::move_to(const std::vector<double>& log_scale) {
  u_ = log_scale;
  metric_.length = lengths(u_);
  make_delaunay();
}

/// By cosines from the lengths, which mean something even where a triangle inequality fails: the condition is
/// that of the ideal hyperbolic polygons that the scaled metrics have in common.
bool VertexScaling::should_flip(Side s) const {
  const Side m = metric_.surface.mate(s);
  if (!m.exists() || m.triangle() == s.triangle()) return false;
  constexpr double tolerance = 1e-12; // four points on a circle are left alone
  const auto cosine = [&](Side t) {
    const double a = metric_.length[t.value];
    const double b = metric_.length[t.next().value];
    const double c = metric_.length[t.previous().value];
    return (b * b + c * c - a * a) / (2 * b * c);
  };
  return cosine(s) + cosine(m) < -tolerance;
}

/// Ptolemy: the product of the diagonals is the sum of the products of opposite sides. Scaling leaves that
/// alone.
void VertexScaling::flip(Side s) {
  const Side m = metric_.surface.mate(s);
  metric_.surface.flip_edge(s);
  for (auto* const length : {&unscaled_, &metric_.length}) {
    auto& l = *length;
    const double diagonal =
        (l[s.next().value] * l[m.next().value] + l[s.previous().value] * l[m.previous().value]) / l[s.value];
    l[s.value] = l[m.next().value];
    l[m.value] = l[s.next().value];
    l[s.next().value] = l[m.next().value] = diagonal;
  }
  ++metric_.flips;
}

void VertexScaling::make_delaunay() {
  std::vector<Side> queue;
  for (int k = 0; k < metric_.surface.side_count(); ++k)
    if (should_flip(Side(k))) queue.push_back(Side(k));
  long long budget = 100LL * metric_.surface.triangle_count();
  while (!queue.empty() && budget > 0) {
    const Side s = queue.back();
    queue.pop_back();
    if (!should_flip(s)) continue;
    const Side m = metric_.surface.mate(s);
    flip(s);
    --budget;
    for (const Side around : {s, s.previous(), m, m.previous()}) queue.push_back(around);
  }
  metric_.is_delaunay = budget > 0;
}

bool VertexScaling::is_metric() const {
  for (int k = 0; k < metric_.surface.side_count(); ++k)
    if (!(half_tangent(metric_.length, Side(k)) < HUGE_VAL)) return false;
  return true;
}

/// The gradient: what the curvatures are too much by; of the round holes, 2 pi less the arcs.
std::vector<double> VertexScaling::defects(const std::vector<double>& curvature) const {
  std::vector<double> defect = curvatures_of(metric_);
  std::vector<char> is_round(defect.size(), 0);
  const std::vector<Side> out = boundary_sides(metric_.surface);
  const std::size_t vertices = defect.size();
  for (std::size_t h = 0; h < round_.size(); ++h) {
    double rest = full_turn;
    for (const int v : round_[h]) {
      is_round[v] = 1;
      const double arc = half_arc(metric_.length[out[v].value], std::exp(u_[vertices + h]));
      defect[v] += arc;
      defect[metric_.surface.to(out[v])] += arc;
      rest -= 2 * arc;
    }
    defect.push_back(rest);
  }
  for (std::size_t v = 0; v < vertices; ++v)
    if (!is_round[v]) defect[v] -= curvature[v];
  for (std::size_t v = 0; v < defect.size(); ++v)
    if (held_[v]) defect[v] = 0;
  return defect;
}

numeric::SymmetricMatrix VertexScaling::hessian(double shift) const {
  Assembly sum(held_);
  for (int k = 0; k < metric_.surface.side_count(); ++k) {
    const double t = half_tangent(metric_.length, Side(k));
    // Triangles that have broken down keep their angles for a while.
    const double half_cotangent = t > 0 && t < HUGE_VAL ? (1 / t - t) / 4 : 0;
    const int v = metric_.surface.from(Side(k));
    const int w = metric_.surface.to(Side(k));
    if (v == w) continue;
    sum.add(v, v, half_cotangent);
    sum.add(w, w, half_cotangent);
    sum.add(v, w, -half_cotangent);
  }
  const std::vector<Side> out = boundary_sides(metric_.surface);
  for (std::size_t h = 0; h < round_.size(); ++h) {
    const int center = metric_.surface.vertex_count() + static_cast<int>(h);
    for (const int v : round_[h]) {
      const double arc = half_arc(metric_.length[out[v].value], std::exp(u_[center]));
      // The square of u(v) + u(w) - 2 s, times half of this.
      const double t = arc < half_turn / 2 ? std::tan(arc) : 0;
      const int w = metric_.surface.to(out[v]);
      for (const int end : {v, w}) {
        sum.add(end, end, t / 2);
        sum.add(end, center, -t);
      }
      sum.add(v, w, t / 2);
      sum.add(center, center, 2 * t);
    }
  }
  for (int j = 0; j < static_cast<int>(held_.size()); ++j) sum.add(j, j, shift);
  return sum.matrix();
}

void VertexScaling::factor() {
  // Only where triangles have broken down may the matrix be singular; then steps are held back a little.
  for (double shift = 0; shift<1; shift = shift> 0 ? 100 * shift : 1e-8) {
    const numeric::SymmetricMatrix matrix = hessian(shift);
    if (!cholesky_ || analysed_at_ != metric_.flips) cholesky_.emplace(matrix);
    analysed_at_ = metric_.flips;
    if (cholesky_->factor(matrix)) return;
  }
}

std::vector<double> VertexScaling::solved(std::vector<double> right) const {
  std::vector<double> x(right.size());
  for (std::size_t v = 0; v < right.size(); ++v)
    if (held_[v]) right[v] = 0;
  cholesky_->solve(right, x);
  return x;
}

std::vector<std::vector<double>>
VertexScaling::responses(std::vector<std::vector<double>> curvature_changes) {
  factor();
  for (auto& column : curvature_changes) column = solved(std::move(column));
  return curvature_changes;
}

VertexScaling::Outcome VertexScaling::solve(const std::vector<double>& curvature, const RicciOptions& options,
                                            const Progress& progress) {
  Outcome outcome;
  move_to(std::vector<double>(u_));
  std::vector<double> defect = defects(curvature);
  constexpr int most_halvings = 40;
  constexpr double longest_step = 2; // lengths should not overflow on the way
  for (; outcome.steps < options.most_steps; ++outcome.steps) {
    progress.step("Ricci flow");
    outcome.residual = greatest(defect);
    outcome.found = outcome.residual <= options.tolerance && is_metric();
    if (outcome.residual <= options.tolerance || !std::isfinite(outcome.residual)) return outcome;
    const std::vector<double> start = u_;
    factor();
    std::vector<double> step = solved(defect);
    for (double& x : step) x = -x;
    const double before = dot(defect, defect);
    double part = std::min(1.0, longest_step / greatest(step));
    for (int halvings = 0;; ++halvings, part /= 2) {
      if (halvings == most_halvings) {
        move_to(start);
        return outcome;
      }
      std::vector<double> next = start;
      for (std::size_t v = 0; v < next.size(); ++v) next[v] += part * step[v];
      move_to(next);
      defect = defects(curvature);
      // Along the step a convex function falls as long as its slope is negative.
      if (dot(defect, step) <= 0 || dot(defect, defect) < before) break;
    }
  }
  outcome.residual = greatest(defect);
  outcome.found = outcome.residual <= options.tolerance && is_metric();
  return outcome;
}

} // namespace tetrarch::slit
