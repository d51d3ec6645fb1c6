// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The partition of a solid with one handle, however small, around a loop of its boundary.
///
///        ____________           The loop generates the homology of the solid: it goes around the tunnel. Cut
///       /   ceiling  \          along it, the boundary is a ring, and on it a function is harmonic, 1 on one
///      |   _.-"""-._  |         bank and 0 on the other. Where it is high but for a band along the bank is
///      |--(  loop   )-| wall    the floor, where it is low the ceiling; both bands are the inner wall, and
///      |   "-.___.-"  |         what lies halfway between is the outer one.
///       \____floor___/
///
/// Limbs would lie in one of both alone; branches.hpp sends both into them: what their trees reach is held
/// at 0.8 and 0.2.

#include "homology.hpp"
#include "levels.hpp"

#include "tetrarch/mesh/cuts.hpp"
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::product {

struct TunnelLoop {
  mesh::MarkedSurface surface; ///< the boundary
  mesh::Loop loop;
  double length = 0;
};

/// None where no short loop generates the homology, which one loop does only for one handle. O(n log n) for
/// each of some roots.
[[nodiscard]] std::optional<TunnelLoop> tunnel_loop(const Solid& solid, const FirstHomology& homology);

struct Tunnel {
  CornerValues values; ///< of the harmonic function
  /// In increasing order: from the first on to the second is the ceiling, from the third on to the fourth the
  /// floor. Outside of them is the inner wall, as wide as a quarter of the loop is long; in the middle the
  /// outer one, a fifth of the boundary.
  std::array<double, 4> levels{};
  std::string how;
};

/// The function for so many branches. A sparse factorisation, and O(n log n) for each branch.
Tunnel tunnel(const Solid& solid, const TunnelLoop& around, int branches);

} // namespace tetrarch::product
