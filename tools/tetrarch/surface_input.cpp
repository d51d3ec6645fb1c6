// SPDX-License-Identifier: GPL-2.0-or-later
#include "surface_input.hpp"

#include "input.hpp"

namespace tetrarch::program {

SurfaceInput read_surface(const std::string& argument, const Context& context, const Doctor& doctor) {
  return workshop::surface_of(read_soup(argument, context), doctor);
}

} // namespace tetrarch::program
