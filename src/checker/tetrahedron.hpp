// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One tetrahedron, known by the triangles at its truncated corners; and its volume.

#include "gluing.hpp"
#include "interval.hpp"

#include <functional>
#include <optional>

namespace tetrarch::checker {

/// kinds[v]: 1 if vertex v lies beyond infinity (hyperideal), 0 if it is ideal, -1 if it is a point of the
/// space (finite): the vector's inner product with itself.
using Corners = std::array<int, 4>;

/// By the links of its vertices.
Corners kinds_at(const Classes& classes, int tet);

/// Called now and then in long computations; may throw to end them.
using StillWanted = std::function<void()>;

/// The dihedral angles at its edges (in the order of `ends_of_edge`) with their derivatives by the lengths;
/// nothing unless it exists for all lengths in these intervals.
std::optional<std::array<Dual, 6>> dihedral_angles(const std::array<Interval, 6>& lengths,
                                                   const Corners& kinds);

/// What the triangle at corner v knows of its side y in the face v a b: cosh y, y^2 or cos y, as v is
/// hyperideal, ideal or finite.
Interval corner_side(const std::array<Interval, 6>& lengths, const Corners& kinds, int v, int a, int b);

/// The inner products of its vertex vectors.
std::array<std::array<Interval, 4>, 4> products(const std::array<Interval, 6>& lengths, const Corners& kinds);

/// Of the angles of a tetrahedron that exists: Lobachevsky's formula if all vertices are ideal, else
/// Ushijima's.
Interval volume(const std::array<Interval, 6>& angles, const Corners& kinds, const StillWanted& ask);

} // namespace tetrarch::checker
