// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/workshop/in_file.hpp"

namespace tetrarch::program {

using workshop::in_file;

} // namespace tetrarch::program
