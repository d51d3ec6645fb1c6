// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The dissertation's algorithms for cutting patterns, one for each kind of boundary condition.
///
///   I    restricted (5.2): values given on the boundary, and a triangle with two or more boundary edges has
///        both +1 and -1 among them. Round by round the unsolved triangles are partitioned, the breaking
///        edges are given values (Procedure 5.2.1), strips are solved whole and aggregated pieces in their
///        frontier. Always succeeds.
///   II   general (5.3): any values on the boundary. Dangerous pieces of the first partition are relieved by
///        their neighbors (Procedure 5.3.1) and solved (Procedure 5.3.2), or there is an obstruction; the
///        rest is Algorithm I.
///   III  free (5.4): boundary values are chosen (Procedure 5.4.1), then Algorithm I.
///
/// All are linear: see partition.hpp. Arbitrary choices fall on +1, so results are reproducible. Source: Yin,
/// sections 5.2 to 5.4; the code says where it departs from the text.

#include "tetrarch/bundle/assignment.hpp"

#include <functional>
#include <string>

namespace tetrarch::bundle {

/// A view of a round between its steps.
struct Round {
  enum class Stage {
    begun,     ///< the mesh is partitioned, but no breaking edge has a value (in step 2a)
    completed, ///< breaking edges have values (end of step 2a)
    solved     ///< all sides of the frontier have values (end of step 2b)
  };
  int number = 1; ///< 1, 2, ...
  Stage stage = Stage::begun;
  bool dangerous = false; ///< the round of Algorithm II that relieves dangerous pieces
  const UnsolvedMesh& mesh;
  const Partition& partition;
  const CuttingPattern& pattern;
};
/// Called three times a round. It may throw, which ends the job.
using Watch = std::function<void(const Round&)>;

/// The broken invariant of Definition 5.2.2 (completeness, consistency, safeness) at this point, for audits;
/// empty if all hold. In a dangerous round "safe" weakens to "not extremely dangerous" once breaking edges
/// have values, and nothing is asked before. O(frontier).
std::string broken_invariant(const Round& round);

/// Algorithm I. Throws `PreconditionError` if the boundary is not restricted, and as `with_boundary`. O(n).
CuttingPattern cut_restricted(const Disk& disk, const BoundaryValues& boundary, const Watch& watch = {});

/// Algorithm II. Throws as `with_boundary`. O(n).
[[nodiscard]] CuttingResult cut_general(const Disk& disk, const BoundaryValues& boundary,
                                        const Watch& watch = {});

/// Algorithm III. O(n).
CuttingPattern cut_free(const Disk& disk, const Watch& watch = {});

/// Procedure 5.4.1: boundary values that are restricted, whatever the disk. O(n).
BoundaryValues restricted_boundary(const Disk& disk);

} // namespace tetrarch::bundle
