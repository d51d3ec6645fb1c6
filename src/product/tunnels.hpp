// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The partition of a solid with handles, however small, around loops of its boundary.
///
///        ____________           The loops are a basis of the solid's homology: each goes around a tunnel,
///       /   ceiling  \          and they do not meet. Cut along them, the boundary is a sphere with two
///      |   _.-"""-._  |         holes for each, and on it a function is harmonic, 1 on one bank of each loop
///      |--(  loop   )-| wall    and 0 on the other. Where it is high but for bands along banks is the floor,
///      |   "-.___.-"  |         where it is low the ceiling; the bands are inner walls, and what lies
///       \____floor___/          halfway between is the outer one.
///
/// Each half of the banks is joined by a tree, and limbs would lie in floor or ceiling alone; so branches.hpp
/// sends both into them. What the trees reach is held at 0.8 and 0.2.

#include "homology.hpp"
#include "levels.hpp"

#include "tetrarch/surface/cuts.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::product {

struct TunnelLoops {
  surface::MarkedSurface surface;   ///< the boundary; loop k, from 0, is marked k + 1
  std::vector<surface::Loop> loops; ///< as many as there are handles
  std::vector<double> length;       ///< of each
};

/// The shortest loop that is part of a basis of the homology, then the shortest that completes it and does
/// not touch the first, and so on. None where one of them is not found. O(handles n log n) for each of some
/// roots.
[[nodiscard]] std::optional<TunnelLoops> tunnel_loops(const Solid& solid, const FirstHomology& homology);

struct Tunnel {
  CornerValues values; ///< of the harmonic function
  /// In increasing order: from the first on to the second is the ceiling, from the third on to the fourth the
  /// floor. Outside of them are the inner walls, as wide as a quarter of the loops are long; in the middle
  /// the outer one, a fifth of the boundary.
  std::array<double, 4> levels{};
  std::string how;
};

/// The function for so many branches. None where the banks cannot be joined by trees. A sparse factorisation,
/// and O(n log n) for each loop and branch.
[[nodiscard]] std::optional<Tunnel> tunnel(const Solid& solid, const TunnelLoops& around, int branches);

} // namespace tetrarch::product
