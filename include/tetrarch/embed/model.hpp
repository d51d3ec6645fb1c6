// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Three models of hyperbolic space, and the plane at infinity. This is the only home of these conventions:
///
///   upper half space   (x, y, 1) / (t - z)      the base point is (0,0,1), the z axis the vertical geodesic
///   Poincare ball      (x, y, z) / (1 + t)      the base point is the center
///   Klein ball         (x, y, z) / t            planes are flat
///
/// The plane at infinity of the half space is the complex plane, zeta = (x + i y) / (t - z) for a vector of
/// the light cone. Source: Yin, section 4.4.1.

#include "tetrarch/embed/lorentz.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tetrarch::embed {

enum class Model : std::uint8_t { half_space, ball, klein };
/// "half-space", "ball", "klein", as the program spells them; and back.
const char* to_string(Model model);
std::optional<Model> model_named(std::string_view name);

/// The picture of a point of hyperbolic space.
std::array<double, 3> to_model(Model model, const Vector4<double>& x);
/// The point of hyperbolic space at p, which must lie in the model: above height 0, or inside the ball.
Vector4<double> from_model(Model model, const std::array<double, 3>& p);

/// The Euclidean unit normal at the picture p of a point of the plane with normal n, on the side to which n
/// points; `horosphere_normal`: of the horosphere of v, into its horoball.
std::array<double, 3> plane_normal(Model model, const Vector4<double>& n, const std::array<double, 3>& p);
std::array<double, 3> horosphere_normal(Model model, const Vector4<double>& v,
                                        const std::array<double, 3>& p);

/// Where a plane meets the plane at infinity of the half space: a circle, or a line
/// direction . zeta = offset with a unit vector `direction` where the plane is vertical.
struct CircleAtInfinity {
  bool line = false;
  std::array<double, 2> center{}; ///< or the unit vector perpendicular to the line
  double radius = 0;              ///< or the offset
};
/// A circle so large that its radius overflows 1e12 is given as a line.
CircleAtInfinity circle_at_infinity(const Vector4<double>& n);

} // namespace tetrarch::embed
