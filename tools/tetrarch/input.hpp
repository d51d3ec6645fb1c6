// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What may stand where a triangulation is expected: a file (its format found from its content), `-` for
/// standard input, the name of a census manifold, an isomorphism signature; or a mesh: of tetrahedra, or a
/// closed surface, which TetGen fills.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/document.hpp"

#include <string>

namespace tetrarch::program {

struct ReadOptions {
  bool repair = false; ///< mend in a mesh what can be mended
  Progress progress;   ///< for filling a surface
};

/// Tried in this order: `-`, an existing file, a census name, a signature. Throws InputError that says what
/// was tried; of a bad mesh, what is wrong and where.
format::Document read_triangulation(const std::string& argument, const ReadOptions& options = {});

/// Throws InputError that names the first defect unless the triangulation is a connected manifold (with ideal
/// vertices) of at least one tetrahedron.
void require_manifold(const Triangulation& tri, const std::string& source);

} // namespace tetrarch::program
