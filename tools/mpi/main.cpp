// SPDX-License-Identifier: GPL-2.0-or-later
/// tetrarch-mpi: the program on several machines at once. Rank 0 is the program as it is typed; where it
/// classifies manifolds, the other ranks help.
#include "master.hpp"
#include "worker.hpp"

#include "../tetrarch/crew.hpp"
#include "../tetrarch/memory.hpp"
#include "../tetrarch/program.hpp"

#include <boost/mpi.hpp>
#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
  using namespace tetrarch;
  constexpr double patience = 10;  // seconds that a worker may need to end its unit
  program::prepare_for_want(argv); // it may start the program again, which MPI must not see
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator world;
  MPI_Comm_set_errhandler(world, MPI_ERRORS_RETURN);
  if (world.rank() != 0) {
    if (!mpi::work_for_others(world)) std::_Exit(0);
    return 0;
  }
  mpi::Master master(world);
  program::set_crew(
      [&master](catalogue::TableKey table, bool angles, const catalogue::UnitRecords& records,
                const Progress& progress) { master.share_out(table, angles, records, progress); });
  const int status = program::run_program("tetrarch-mpi", argv);
  const int lost = master.dismiss(patience);
  if (lost > 0) {
    std::cerr << "tetrarch-mpi: " << lost << " of " << world.size() << " ranks do not answer" << std::endl;
    std::_Exit(status); // MPI's own end would wait for them
  }
  return status;
}
