// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/embed/model.hpp"

#include "tetrarch/core/error.hpp"

namespace tetrarch::embed {
namespace {

using Point = std::array<double, 3>;

constexpr std::array<const char*, 3> names{"half-space", "ball", "klein"};

double square(const Point& p) {
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

Point unit(const Point& p) {
  const double length = std::sqrt(square(p));
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// In each model <x,n> is, up to a positive factor, a function of p; this is its gradient.
Point plane_gradient(Model model, const Vector4<double>& n, const Point& p) {
  const double q = n[2] - n[3];
  switch (model) {
  case Model::half_space:
    return {n[0] + q * p[0], n[1] + q * p[1], q * p[2]};
  case Model::ball:
    return {n[0] - n[3] * p[0], n[1] - n[3] * p[1], n[2] - n[3] * p[2]};
  case Model::klein:
    break;
  }
  return {n[0], n[1], n[2]};
}

} // namespace

const char* to_string(Model model) {
  return names[static_cast<std::size_t>(model)];
}

std::optional<Model> model_named(std::string_view name) {
  for (std::size_t m = 0; m < names.size(); ++m)
    if (name == names[m]) return static_cast<Model>(m);
  return std::nullopt;
}

Point to_model(Model model, const Vector4<double>& x) {
  switch (model) {
  case Model::half_space: {
    // (t - z)(t + z) = 1 + x^2 + y^2 on the hyperboloid: t - z itself loses its digits where z is near t.
    const double height = x[2] > 0 ? (x[3] + x[2]) / (1 + x[0] * x[0] + x[1] * x[1]) : 1 / (x[3] - x[2]);
    return {x[0] * height, x[1] * height, height};
  }
  case Model::ball:
    return {x[0] / (1 + x[3]), x[1] / (1 + x[3]), x[2] / (1 + x[3])};
  case Model::klein:
    break;
  }
  return {x[0] / x[3], x[1] / x[3], x[2] / x[3]};
}

Vector4<double> from_model(Model model, const Point& p) {
  const double s = square(p);
  if (model == Model::half_space ? !(p[2] > 0) : !(s < 1))
    throw PreconditionError("from_model: a point at infinity or beyond");
  switch (model) {
  case Model::half_space:
    return {p[0] / p[2], p[1] / p[2], (s - 1) / (2 * p[2]), (s + 1) / (2 * p[2])};
  case Model::ball:
    return {2 * p[0] / (1 - s), 2 * p[1] / (1 - s), 2 * p[2] / (1 - s), (1 + s) / (1 - s)};
  case Model::klein:
    break;
  }
  const double t = 1 / std::sqrt(1 - s);
  return {p[0] * t, p[1] * t, p[2] * t, t};
}

Point plane_normal(Model model, const Vector4<double>& n, const Point& p) {
  return unit(plane_gradient(model, n, p));
}

Point horosphere_normal(Model model, const Vector4<double>& v, const Point& p) {
  // The gradient of <x,v> + 1 in the same units; it points into the horoball.
  Point g = plane_gradient(model, v, p);
  switch (model) {
  case Model::half_space:
    g[2] += 1;
    break;
  case Model::ball:
    g = {g[0] - p[0], g[1] - p[1], g[2] - p[2]};
    break;
  case Model::klein: {
    const double r = std::sqrt(1 - square(p));
    g = {g[0] - p[0] / r, g[1] - p[1] / r, g[2] - p[2] / r};
    break;
  }
  }
  return unit(g);
}

CircleAtInfinity circle_at_infinity(const Vector4<double>& n) {
  const double q = n[3] - n[2];
  if (std::abs(q) < 1e-12) {
    const double length = std::hypot(n[0], n[1]);
    return {true, {n[0] / length, n[1] / length}, (n[2] + n[3]) / 2 / length};
  }
  return {false, {n[0] / q, n[1] / q}, 1 / std::abs(q)};
}

} // namespace tetrarch::embed
