// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The helper of the room workshop by which errors name a file, by its short name.

#include "tetrarch/workshop/in_file.hpp"

namespace tetrarch::program {

using workshop::in_file;

} // namespace tetrarch::program
