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
/// and Plassmann, "Local optimization-based simplicial mesh untangling and improvement" (2000). Where
/// vertices block each other, those of a part are moved together, by the foldover-free energy
/// (unfold/unfold.hpp).

#include "tetrarch/slit/circular_map.hpp"

#include <cstdint>

namespace tetrarch::slit {

/// Which triangles are to be set right: all, or only those that touch a slit or the circle that it becomes,
/// where maps flip a few triangles even if no weight is negative.
enum class Unflip : std::uint8_t { everywhere, at_slits };

/// Never worse than it was before: of all drawings met, the one with the fewest flipped triangles is taken.
struct Unflipped {
  int moved = 0;       ///< vertices
  double farthest = 0; ///< that one of them was moved: in the domain, whose outer radius is 1
  int left = 0;        ///< triangles still flipped, or much narrower than in space
};

/// On the cylinder. Ears stay flat. O(n), and a little time for each vertex near an inverted triangle: for
/// each of a hundred sweeps O(triangles at it).
Unflipped unflip_on_cylinder(const OneForms& forms, SlitMap& map, Unflip which = Unflip::everywhere,
                             const Progress& progress = {});
/// On the ring, where edges are straight.
Unflipped unflip_on_ring(const OneForms& forms, SlitMap& map, Unflip which = Unflip::everywhere,
                         const Progress& progress = {});
/// On circles other than the outer one ears stay as they are.
Unflipped unflip_in_disk(const surface::TriangleMesh& mesh, CircularMap& map,
                         Unflip which = Unflip::everywhere, const Progress& progress = {});

} // namespace tetrarch::slit
