// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Repairing inverted triangles of a map by moving a few vertices.
///
///       .---.             .---.        A vertex inside goes to where it is as far as can be from all the
///      / \ / \   -->     /\ | /\       sides that it must see from the left: a linear program in two
///     /   x---\         /  \|/  \      coordinates and that distance. One on a loop slides along its circle
///     \  / \  /         \  /|\  /      or slit likewise. Vertices of flipped triangles first, then, where
///      `-----'           `-----'       that is not enough, those around.
///
/// Harmonic maps flip nothing where no weight is negative, but for triangles near the ends of slits, where
/// the turning point lies between vertices. Meshes with obtuse angles have negative weights. Source: Freitag
/// and Plassmann, "Local optimization-based simplicial mesh untangling and improvement" (2000).

#include "tetrarch/slit/circular_map.hpp"

namespace tetrarch::slit {

struct Unflipped {
  int moved = 0;       ///< vertices
  double farthest = 0; ///< that one of them was moved: in the domain, whose outer radius is 1
  int left = 0;        ///< triangles still flipped when the budget of sweeps was used up
};

/// On the cylinder. Ears stay flat. O(n), and a little time for each vertex near an inverted triangle.
Unflipped unflip_on_cylinder(const OneForms& forms, SlitMap& map);
/// On the ring, where edges are straight.
Unflipped unflip_on_ring(const OneForms& forms, SlitMap& map);
Unflipped unflip_in_disk(const mesh::TriangleMesh& mesh, CircularMap& map);

} // namespace tetrarch::slit
