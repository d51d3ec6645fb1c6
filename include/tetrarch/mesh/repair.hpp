// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Repairs of a soup that need no question about its meaning.
///
/// Of a solid: a tetrahedron of negative volume gets its last two vertices exchanged; of several tetrahedra
/// on the same four vertices the first is kept; points that no tetrahedron names are removed.
///
/// Of a surface, which is a soup of triangles alone: a triangle that names a vertex twice is removed (what is
/// left of it is an edge, at which its neighbors then meet); of several triangles on the same three vertices
/// the first is kept; each orientable component gets the orientation that most of its triangles have, of two
/// halves that of the first triangle; points that no triangle names are removed.
///
/// Law: of the findings of `validate` or `validate_surface` on the result, none is repairable, unless an
/// index is out of range; then unused points are kept, as renumbering would make another point of it. So a
/// second repair does nothing. What is fatal stays fatal: nothing is removed or cut to make a manifold.

#include "tetrarch/format/soup.hpp"

#include <string>
#include <vector>

namespace tetrarch::mesh {

struct Repaired {
  format::Soup soup;
  std::vector<std::string> done; ///< a sentence for each kind of repair that was needed
};

/// The rest keeps its numbers and lines in the file. O(n log n) in the worst case, in practice linear.
Repaired repair(format::Soup soup);

} // namespace tetrarch::mesh
