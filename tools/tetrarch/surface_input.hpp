// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a surface is expected: OBJ, OFF, PLY, STL, or the triangles of another mesh format.

#include "command.hpp"
#include "doctor.hpp"

#include "tetrarch/workshop/surface.hpp"

#include <string>

namespace tetrarch::program {

using SurfaceInput = workshop::NumberedSurface;

/// Throws InputError that names what is wrong and where; `doctor` mends what can be mended first.
SurfaceInput read_surface(const std::string& argument, const Context& context, const Doctor& doctor);

} // namespace tetrarch::program
