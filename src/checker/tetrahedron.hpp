// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One tetrahedron, known by the triangles at its truncated corners; and its volume.

#include "interval.hpp"

#include <functional>
#include <optional>

namespace tetrarch::checker {

/// hyperideal[v]: vertex v lies beyond infinity; else it is ideal.
using Corners = std::array<bool, 4>;

/// Called now and then in long computations; may throw to end them.
using StillWanted = std::function<void()>;

/// The dihedral angles at its edges (in the order of `ends_of_edge`) with their derivatives by the lengths;
/// nothing unless it exists for all lengths in these intervals.
std::optional<std::array<Dual, 6>> dihedral_angles(const std::array<Interval, 6>& lengths,
                                                   const Corners& hyperideal);

/// Of the angles of a tetrahedron that exists: Lobachevsky's formula if all vertices are ideal, else
/// Ushijima's.
Interval volume(const std::array<Interval, 6>& angles, const Corners& hyperideal, const StillWanted& ask);

} // namespace tetrarch::checker
