// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The solid inside a closed surface, filled with tetrahedra by the program TetGen.
///
/// TetGen (Si, ACM Trans. Math. Software 41, 2015; Debian package `tetgen`) is not part of Tetrarch: if
/// TetGen is installed, the library runs it as a process of its own in a temporary directory and removes the
/// directory afterwards. The surface stays as it is (TetGen's option -Y): points are added inside only.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/soup.hpp"

#include <cstddef>
#include <string>

namespace tetrarch::tetgen {

struct Options {
  std::string program = "tetgen"; ///< looked up in PATH
  /// Processor seconds that it may take; 0: `budget` of the surface. On surfaces that meet themselves it may
  /// never end.
  int seconds = 0;
};

/// Processor seconds for a surface of so many triangles: some ten times what TetGen takes for good ones.
int budget(std::size_t triangles);

/// The solid as a soup of TetGen's tetrahedra; its points begin with those of the surface. Throws InputError
/// if the surface is not closed (doctor/closed_surface.hpp), if the program is missing (it names the
/// package), or if it fails or does not end in time (its last line of output says why: the surface may meet
/// itself). Stopping ends the process, and whatever ends this one, the process ends when its time is over.
format::Soup fill(const format::Soup& surface, const Progress& progress = {}, const Options& options = {});

} // namespace tetrarch::tetgen
