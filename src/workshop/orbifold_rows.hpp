// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is told of a structure with marked edges or finite vertices besides what every structure tells.

#include "tetrarch/workshop/structure.hpp"

namespace tetrarch::workshop {

/// With the marks, or of a closed manifold: the search, and the struct of the usual search filled from it.
hyperbolic::OrbifoldSearch find_marked(const Triangulation& tri, const StructureOptions& options,
                                       const Progress& progress);
hyperbolic::Search as_search(const hyperbolic::OrbifoldSearch& found);

/// Whether a closed manifold of so many tetrahedra is worth a try.
bool is_worth_trying(const Triangulation& tri);

/// "solved by", "tetrahedra", "vertex 0", ...
void add_orbifold(const hyperbolic::OrbifoldSearch& found, const Skeleton& skeleton, Rows& rows);

Tree vertices_tree(const hyperbolic::OrbifoldSearch& found, const Skeleton& skeleton);
Tree marks_tree(const Marks& marks);
/// Of that tree.
Type marks_type();

} // namespace tetrarch::workshop
