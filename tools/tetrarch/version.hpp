// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace tetrarch::program {

/// Version, build type and the versions of the libraries, several lines.
std::string version_text();

} // namespace tetrarch::program
