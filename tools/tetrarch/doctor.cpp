// SPDX-License-Identifier: GPL-2.0-or-later
#include "doctor.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/repair.hpp"
#include "tetrarch/mesh/weld.hpp"

#include <cmath>
#include <utility>

namespace tetrarch::program {

void declare_doctor(OptionTable& table, Doctor& doctor) {
  table
      .add("--weld", doctor.weld,
           "first join vertices at most TOL apart (alone: vertices of equal coordinates)")
      .value_name("TOL")
      .not_negative()
      .may_stand_alone("0");
  table.add("--component", doctor.component, "take only this component of the mesh, counted from 0")
      .value_name("K")
      .not_negative();
  table.add(
      "--repair", doctor.repair,
      "first repair the mesh: orientation, duplicates, pinched and unused vertices, degenerate triangles");
}

std::vector<std::string> mend(format::Soup& soup, const Doctor& doctor) {
  std::vector<std::string> done;
  if (doctor.weld) {
    if (!std::isfinite(*doctor.weld)) throw InputError("--weld: expected a finite tolerance");
    mesh::Repaired welded = mesh::weld(std::move(soup), *doctor.weld);
    soup = std::move(welded.soup);
    done = std::move(welded.done);
  }
  if (doctor.component) {
    const int count = mesh::component_count(soup);
    soup = mesh::component(std::move(soup), *doctor.component);
    done.push_back("took component " + std::to_string(*doctor.component) + " of " + std::to_string(count));
  }
  if (doctor.repair) {
    mesh::Repaired repaired = mesh::repair(std::move(soup));
    soup = std::move(repaired.soup);
    done.insert(done.end(), repaired.done.begin(), repaired.done.end());
  }
  return done;
}

} // namespace tetrarch::program
