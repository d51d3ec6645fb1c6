// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The walls of a cell that is given by its corners.

#include "tiling.hpp"

#include <optional>
#include <vector>

namespace tetrarch::canonical {

/// psi vanishes on the wall's corners and is positive on the others, at most 1.
template <class Scalar>
struct PolytopeWall {
  Vector4<Scalar> psi;
  std::vector<int> corners; ///< in cyclic order
};

/// The cone over the corners is a polytope of dimension 3 times the rays: its walls, in the order of their
/// first corners; nothing if these are not the corners of one (two walls at each edge, V - E + F = 2, three
/// walls at least at each corner). Values within `margin` of 0 count as 0. O(V^4) for V corners.
template <class Scalar>
std::optional<std::vector<PolytopeWall<Scalar>>> polytope_walls(const std::vector<Vector4<Scalar>>& corners,
                                                                double margin);

} // namespace tetrarch::canonical
