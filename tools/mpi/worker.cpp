// SPDX-License-Identifier: GPL-2.0-or-later
#include "worker.hpp"

#include "messages.hpp"

#include "tetrarch/catalogue/units.hpp"

#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <chrono>
#include <optional>
#include <thread>

namespace tetrarch::mpi {

void doze() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

bool work_for_others(const boost::mpi::communicator& world) {
  std::optional<catalogue::ClassificationUnits> units;
  int job = 0; // to which they belong
  Report report;
  while (true) {
    world.send(0, asking, report);
    while (!world.iprobe(0, ordering)) doze();
    Order order;
    world.recv(0, ordering, order);
    report = {order.job, -1, {}};
    if (order.kind == Order::leave || order.kind == Order::leave_at_once) return order.kind == Order::leave;
    if (order.kind == Order::wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      continue;
    }
    if (order.job != job)
      units.emplace(catalogue::TableKey(order.tetrahedra, order.orientable), order.angles);
    job = order.job;
    report.unit = order.unit;
    report.records = units->make(order.unit);
  }
}

} // namespace tetrarch::mpi
