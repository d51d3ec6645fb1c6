// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The solid inside a closed surface, filled with tetrahedra by the program TetGen.
///
/// TetGen (Si, ACM Trans. Math. Software 41, 2015; Debian package `tetgen`) is not part of Tetrarch: if
/// TetGen is installed, the library runs it as a process of its own in a temporary directory and removes the
/// directory afterwards. The surface stays as it is (TetGen's option -Y): points are added inside only.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/soup.hpp"

#include <string>

namespace tetrarch::tetgen {

/// The solid as a soup of TetGen's tetrahedra; its points begin with those of the surface. `program` is
/// looked up in PATH. Throws InputError if the surface is not closed (doctor/closed_surface.hpp), if the
/// program is missing (it names the package), or if it fails (its last line of output says why: the surface
/// may meet itself). Stopping ends the process.
format::Soup fill(const format::Soup& surface, const Progress& progress = {},
                  const std::string& program = "tetgen");

} // namespace tetrarch::tetgen
