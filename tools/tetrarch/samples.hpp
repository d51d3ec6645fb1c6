// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace tetrarch::program {

/// Where the samples lie that were installed with the program: PREFIX/share/tetrarch/samples, found from
/// where the program itself lies. Empty on a system that does not say where that is.
std::string samples_folder();

/// Where the file that an argument names lies: a file of the user's, or a sample, as `workshop::located`
/// says.
std::string located(const std::string& argument);

} // namespace tetrarch::program
