// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The options that mend a mesh before anything is done with it, the same for every command that takes
/// meshes.

#include "options.hpp"

#include "tetrarch/workshop/doctor.hpp"

namespace tetrarch::program {

using workshop::Doctor;

/// --weld, --component, --repair.
void declare_doctor(OptionTable& table, Doctor& doctor);

} // namespace tetrarch::program
