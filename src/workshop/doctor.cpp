// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/doctor.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/doctor/weld.hpp"

#include <cmath>
#include <utility>

namespace tetrarch::workshop {

std::vector<std::string> mend(format::Soup& soup, const Doctor& doctor) {
  std::vector<std::string> done;
  if (doctor.weld) {
    if (!std::isfinite(*doctor.weld)) throw InputError("the tolerance of welding is not finite");
    doctor::Repaired welded = doctor::weld(std::move(soup), *doctor.weld);
    soup = std::move(welded.soup);
    done = std::move(welded.done);
  }
  if (doctor.component) {
    const int count = doctor::component_count(soup);
    soup = doctor::component(std::move(soup), *doctor.component);
    done.push_back("took component " + std::to_string(*doctor.component) + " of " + std::to_string(count));
  }
  const auto soup_of = [&done](doctor::Repaired repaired) {
    done.insert(done.end(), repaired.done.begin(), repaired.done.end());
    return std::move(repaired.soup);
  };
  if (doctor.split_pinches && soup.tetrahedra.empty()) soup = soup_of(doctor::split_pinches(std::move(soup)));
  if (doctor.repair) soup = soup_of(doctor::repair(std::move(soup)));
  return done;
}

} // namespace tetrarch::workshop
