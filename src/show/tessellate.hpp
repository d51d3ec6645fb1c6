// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Patches and arcs cut into pieces that are nearly straight in a model.

#include "tetrarch/scene/scene.hpp"
#include "tetrarch/show/body.hpp"

#include <array>
#include <functional>
#include <vector>

namespace tetrarch::show {

/// Says whether the piece of a curve from a to b should be cut at its middle m. It must not depend on the
/// order of a and b, so that neighbouring pieces agree.
using TooCoarse = std::function<bool(const Vector4& a, const Vector4& m, const Vector4& b)>;

/// How far the middle m of a curve is from the chord between its ends a and b.
double sagitta(const scene::Point& a, const scene::Point& m, const scene::Point& b);

inline bool is_horocycle(const Vector4& cusp) {
  return cusp[3] != 0;
}
/// The middle of the geodesic from a to b, or of the horocycle in the horosphere of `cusp`.
Vector4 midpoint(const Vector4& a, const Vector4& b, const Vector4& cusp);

struct Tessellation {
  std::vector<Vector4> points; ///< first the patch's corners
  std::vector<std::array<int, 3>> triangles;
};

/// A fan around the patch's middle, its triangles cut until no side is too coarse, at most `most_rounds`
/// times.
Tessellation tessellated(const Patch& patch, const TooCoarse& too_coarse, int most_rounds = 8);

/// From one end to the other, both included.
std::vector<Vector4> subdivided(const Arc& arc, const TooCoarse& too_coarse, int most_rounds = 8);

/// The patch and the arc moved by an isometry.
Patch moved(const Matrix4& by, const Patch& patch);
Arc moved(const Matrix4& by, const Arc& arc);

} // namespace tetrarch::show
