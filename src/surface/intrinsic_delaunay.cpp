// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/intrinsic_delaunay.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tetrarch::surface {
namespace {

/// A negative sum of cotangents above this may be a rounding error, and is so for all corners of a square.
constexpr double tolerance = 1e-12;

/// The apex of the triangle at s, where s runs from (0, 0) along the first axis. The area is Kahan's, which
/// stays exact for needles.
std::array<double, 2> apex(const std::vector<double>& length, Side s) {
  double base = length[s.value];
  double right = length[s.next().value];
  double left = length[s.previous().value];
  // Products of four tiny lengths underflow, of huge ones overflow; powers of two change no digit.
  int power = 0;
  constexpr double least = 1e-60;
  constexpr double most = 1e60;
  if (base > 0 && !(least < base && base < most)) power = std::ilogb(base);
  if (power != 0)
    for (double* const x : {&base, &right, &left}) *x = std::ldexp(*x, -power);
  std::array sorted{base, right, left};
  std::sort(sorted.begin(), sorted.end());
  const auto [c, b, a] = sorted;
  const double squared = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  const double twice_area = std::sqrt(std::max(squared, 0.0)) / 2;
  const std::array<double, 2> result{(base + (left - right) * (left + right) / base) / 2, twice_area / base};
  if (power == 0) return result;
  return {std::ldexp(result[0], power), std::ldexp(result[1], power)};
}

/// Half the cotangent of the angle opposite s.
double half_cotangent(const std::vector<double>& length, Side s) {
  const double base = length[s.value];
  const auto [x, y] = apex(length, s);
  return (y - x * ((base - x) / y)) / (2 * base);
}

/// The flipping itself: a queue of edges that may have to be flipped.
class Flipper {
public:
  Flipper(IntrinsicTriangulation& out, std::vector<std::vector<int>>* closed)
      : out_(out), closed_(closed), waits_(out.length.size(), 0) {
    for (int k = 0; k < out.surface.side_count(); ++k) push(Side(k));
  }

  void run() {
    const long long budget = 100LL * out_.surface.triangle_count();
    while (!queue_.empty()) {
      const Side s = queue_.back();
      queue_.pop_back();
      waits_[s.value] = 0;
      if (!should_flip(s)) continue;
      if (out_.flips == budget) {
        out_.is_delaunay = false;
        return;
      }
      flip(s);
    }
  }

private:
  void push(Side s) {
    if (!out_.surface.mate(s).exists() || waits_[s.value]) return;
    waits_[s.value] = 1;
    queue_.push_back(s);
  }

  bool should_flip(Side s) const {
    const Side m = out_.surface.mate(s);
    if (!m.exists() || m.triangle() == s.triangle()) return false;
    return half_cotangent(out_.length, s) + half_cotangent(out_.length, m) < -tolerance;
  }

  /// The new diagonal is s.next(), from the apex of the mate to that of s; s and m become the sides that m's
  /// and s's next sides were.
  void flip(Side s) {
    const Side m = out_.surface.mate(s);
    const auto [x, y] = apex(out_.length, s);
    const auto [back, below] = apex(out_.length, m);
    const double diagonal = std::hypot(x - (out_.length[s.value] - back), y + below);
    out_.surface.flip_edge(s);
    const auto rename = [&](auto& of_side, auto on_diagonal) {
      of_side[s.value] = of_side[m.next().value];
      of_side[m.value] = of_side[s.next().value];
      of_side[s.next().value] = on_diagonal;
    };
    rename(out_.length, diagonal);
    out_.length[m.next().value] = diagonal;
    if (closed_)
      for (auto& form : *closed_) {
        rename(form, -form[m.next().value] - form[s.previous().value]);
        form[m.next().value] = -form[s.next().value];
      }
    ++out_.flips;
    for (const Side around : {s, s.previous(), m, m.previous()}) push(around);
  }

  IntrinsicTriangulation& out_;
  std::vector<std::vector<int>>* closed_;
  std::vector<char> waits_;
  std::vector<Side> queue_;
};

} // namespace

IntrinsicTriangulation intrinsic_delaunay(const TriangleMesh& mesh, std::vector<std::vector<int>>* closed) {
  IntrinsicTriangulation out;
  static_cast<void>(half_cotangents(mesh)); // refuses triangles without area
  out.surface = mesh.surface;
  out.length.resize(static_cast<std::size_t>(mesh.surface.side_count()));
  for (int k = 0; k < mesh.surface.side_count(); ++k) {
    if (mesh.surface.is_turned(Side(k)))
      throw PreconditionError("intrinsic Delaunay triangulations need oriented surfaces");
    out.length[k] =
        numeric::distance(mesh.points[out.surface.from(Side(k))], mesh.points[out.surface.to(Side(k))]);
  }
  Flipper(out, closed).run();
  return out;
}

std::vector<double> half_cotangents(const IntrinsicTriangulation& triangulation) {
  std::vector<double> weight(triangulation.length.size());
  for (std::size_t k = 0; k < weight.size(); ++k)
    if (weight[k] = half_cotangent(triangulation.length, Side(static_cast<int>(k)));
        !std::isfinite(weight[k]))
      throw InputError("triangle " + std::to_string(Side(static_cast<int>(k)).triangle()) +
                       " of the intrinsic triangulation is so thin that its lengths leave it no area");
  return weight;
}

} // namespace tetrarch::surface
