// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What rank 0 and the others say to each other. A worker asks, with the records of the unit that it has
/// done; rank 0 orders; nobody speaks otherwise, so that a worker that is gone leaves nobody waiting for it.

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::mpi {

constexpr int asking = 1;
constexpr int ordering = 2;

struct Report {
  int job = 0;   ///< of the order that this answers
  int unit = -1; ///< that was done; -1: none
  std::vector<std::pair<std::string, std::string>> records;

  template <class Archive>
  void serialize(Archive& archive, unsigned) {
    archive& job& unit& records;
  }
};

struct Order {
  /// To leave at once is not to wait for the others, since some of them are dead.
  enum Kind { make, wait, leave, leave_at_once };
  int kind = wait;
  int job = 0; ///< number of the classification, from 1
  int tetrahedra = 0;
  bool orientable = true;
  bool angles = false;
  int unit = -1;

  template <class Archive>
  void serialize(Archive& archive, unsigned) {
    archive& kind& job& tetrahedra& orientable& angles& unit;
  }
};

} // namespace tetrarch::mpi
