// SPDX-License-Identifier: GPL-2.0-or-later
#include "doctor.hpp"

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

} // namespace tetrarch::program
