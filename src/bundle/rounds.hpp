// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What Algorithms I and II share: the state between rounds, and the rules of section 5.2.

#include "tetrarch/bundle/cut.hpp"

#include <optional>

namespace tetrarch::bundle {

struct Work {
  UnsolvedMesh mesh;
  Partition partition;
  CuttingPattern pattern;
  int round = 1;

  Work(const Disk& disk, const BoundaryValues& boundary)
      : mesh(disk), partition(disk), pattern(with_boundary(disk, boundary)) {}
  const Disk& disk() const { return mesh.disk(); }
  void set(Side s, int value) { pattern.set(disk(), s, value); }
};

void tell(const Watch& watch, const Work& work, Round::Stage stage, bool dangerous = false);

/// Step 2 of Algorithm I, until nothing is unsolved. Needs a safe mesh.
void run_rounds(Work& work, const Watch& watch);

/// The rules of 5.2.5 to 5.2.7, for a piece that is safe and has all its boundary values.
void solve_safe_piece(Work& work, const Piece& piece);

/// Procedure 5.3.1: gives every breaking edge a value so that no piece is extremely dangerous, or finds the
/// obstruction. O(frontier).
std::optional<Obstruction> relieve(Work& work);

} // namespace tetrarch::bundle
