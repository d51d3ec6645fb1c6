// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Hexahedra fitted to the surface of a solid.
///
///      .--.--.        Springs draw the points of the mesh's surface to their homes: the plane that touches
///      |  |  '-.      the solid's surface at the nearest point, the line along a ridge, a corner. The
///      .--.--.  \     energy of the room `unfold` keeps hexahedra from folding meanwhile. Springs grow
///      |  |  |--.|    stronger, nearest points are found anew; at last points go to where they are drawn.
///      '--'--'--'

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hex/grid.hpp"
#include "tetrarch/hex/targets.hpp"

#include <vector>

namespace tetrarch::hex {

struct FitOptions {
  int rounds = 8;      ///< in which nearest points are found
  int iterations = 40; ///< of the energy's descent in a round
  double flat = 1e-5;  ///< gain of an iteration at which a round is over; a tenth of it in the last round
  double weakest = 10; ///< spring, in units of the energy for a motion by the length of a cell
  double strongest = 1e4;
  bool ends_there = true; ///< points go to their homes at last
};

/// Points so far inside that they stay where the grid has them: more than six hexahedra from the surface. 1
/// each. O(n).
std::vector<char> deep_points(const product::HexMesh& mesh, const std::vector<Home>& home);

/// Moves the points; `home` has one for each. O(n log n) a round.
void fit(SizedHexahedra& hexahedra, const std::vector<Home>& home, const Targets& targets,
         const FitOptions& options = {}, const Progress& progress = {});

/// Points of the surface go to their homes, or as far on the way as the hexahedra around them keep the scaled
/// Jacobian `least`, or nine tenths of a lesser one; returns how many are not there. O(n log n).
int land(product::HexMesh& mesh, const std::vector<Home>& home, const Targets& targets,
         const Progress& progress = {}, double least = 0.2);

/// The normal of the mesh's surface at each of its points, unit; zero inside. O(n log n).
std::vector<Vector> surface_normals(const product::HexMesh& mesh);

} // namespace tetrarch::hex
