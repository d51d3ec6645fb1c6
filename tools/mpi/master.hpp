// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Rank 0 shares the units of a classification out, does some itself, and keeps all records: it alone writes.
///
/// A unit whose worker is not heard of for long is given out again, and the first answer counts; so a worker
/// that dies costs its unit, provided that MPI lets the others live (mpirun --enable-recovery).

#include "messages.hpp"

#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/core/progress.hpp"

#include <boost/mpi/communicator.hpp>
#include <optional>
#include <utility>

namespace tetrarch::mpi {

class Master {
public:
  explicit Master(boost::mpi::communicator world) : world_(std::move(world)) {}

  /// Makes what the records do not hold. Lets through what `records.keep` throws, and `Stopped`.
  void share_out(catalogue::TableKey table, bool angles, const catalogue::UnitRecords& records,
                 const Progress& progress);
  /// Waits until all the others have asked, `grace` seconds at most, and lets those leave who have. The
  /// number of those who have not.
  int dismiss(double grace);

private:
  /// What some rank has to report, with its number. If there is nothing, dozes and gives nothing.
  std::optional<std::pair<int, Report>> next_report();

  boost::mpi::communicator world_;
  int job_ = 0;
};

} // namespace tetrarch::mpi
