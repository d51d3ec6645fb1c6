// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <boost/mpi/communicator.hpp>

namespace tetrarch::mpi {

/// The life of a rank other than 0: it makes units until it is told to leave. Of errors it knows nothing that
/// rank 0 could use: whatever is thrown ends the process, and its unit is given to another one. Whether all
/// ranks leave: MPI's own end would wait for those who are dead.
bool work_for_others(const boost::mpi::communicator& world);

/// Sleeps a little: between looks for a message, since waiting in MPI takes a whole core.
void doze();

} // namespace tetrarch::mpi
