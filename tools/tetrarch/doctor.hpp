// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The options that mend a mesh before anything is done with it, the same for every command that takes
/// meshes.

#include "options.hpp"

#include "tetrarch/format/soup.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::program {

struct Doctor {
  std::optional<double> weld;   ///< a tolerance
  std::optional<int> component; ///< counted from 0
  bool repair = false;
};

/// --weld, --component, --repair.
void declare_doctor(OptionTable& table, Doctor& doctor);

/// Welds, chooses the component and repairs, in this order, as far as asked for; returns a sentence for each
/// thing that was done. Throws InputError if there is no such component.
std::vector<std::string> mend(format::Soup& soup, const Doctor& doctor);

} // namespace tetrarch::program
