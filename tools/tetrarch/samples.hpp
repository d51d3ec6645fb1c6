// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace tetrarch::program {

/// Where the file that an argument names lies. A name that begins with "samples/" and is no file here is one
/// of those that were installed with the program: samples/torus.off, say, is then
/// PREFIX/share/tetrarch/samples/torus.off, found from where the program itself lies. Every other argument
/// comes back as it is. Throws InputError, with the list of samples, where there is no sample of that name.
std::string located(const std::string& argument);

} // namespace tetrarch::program
