// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What `slit` does to a surface before it is mapped: holes punched, slices cut, handles opened; and what the
/// words on the command line mean by a loop or a vertex.

#include "surface_input.hpp"

#include "tetrarch/core/progress.hpp"
#include "tetrarch/slit/slit_map.hpp"
#include "tetrarch/workshop/openings.hpp"

#include <string>
#include <vector>

namespace tetrarch::program {

struct OpeningWords {
  std::vector<std::string> punch; ///< "v17:0.5", a vertex and a radius
  std::vector<std::string> slice; ///< "3,17,20", vertices to run through
  bool open_handles = false;
};

/// Vertices are numbered as in the file, counted from 0. Throws InputError that names the word.
workshop::HoledSurface opened(const SurfaceInput& surface, const OpeningWords& words,
                              const Progress& progress);

/// The loop that "2" or "v17" means. Throws InputError that names the option and what is there.
int loop_named(const std::string& name, const char* option, const workshop::HoledSurface& surface);

/// The loops that --outer and --inner name; where one is empty, 0 and 1. Throws InputError as above.
slit::LoopPair circles_named(const std::string& outer, const std::string& inner,
                             const workshop::HoledSurface& surface);

/// The vertex that "v17" means. Throws InputError as above.
int vertex_named(const std::string& name, const char* option, const workshop::HoledSurface& surface);

} // namespace tetrarch::program
