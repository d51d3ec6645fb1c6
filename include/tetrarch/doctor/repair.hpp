// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Repairs of a soup that need no question about its meaning.
///
/// Of a solid: of several tetrahedra on the same four vertices the first is kept; each component is oriented
/// as its gluings say, with the sign by which its volume is positive (what is inverted then stays so: it is
/// folded over, and turning it alone would hide that); a vertex at which tetrahedra fall apart becomes
/// several, one for each piece; points that no tetrahedron names are removed, with triangles on them.
///
/// Of a surface, which is a soup of triangles alone: a triangle that names a vertex twice is removed (what is
/// left of it is an edge, at which its neighbors then meet); of several triangles on the same three vertices
/// the first is kept; each orientable component gets the orientation that most of its triangles have, of two
/// halves that of the first triangle; a closed component that lies in no other one and is inside out is
/// turned round; a vertex at which triangles fall apart becomes several; a triangle with an angle below 1e-10
/// is taken out, as far as no other one is turned over: of a needle the shortest edge is collapsed, of a cap
/// the longest edge is flipped; points that no triangle names are removed.
///
/// Law: of the findings of `validate` or `validate_surface` on the result, none is repairable, unless an
/// index is out of range; then unused points are kept, as renumbering would make another point of it. So a
/// second repair does nothing, unless `done` says that thin triangles were left for it. What else is fatal
/// stays fatal: nothing is removed or cut along edges and faces to make a manifold.

#include "tetrarch/format/soup.hpp"

#include <string>
#include <vector>

namespace tetrarch::doctor {

struct Repaired {
  format::Soup soup;
  std::vector<std::string> done; ///< a sentence for each kind of repair that was needed
};

/// The rest keeps its numbers and lines in the file. O(n log n) in the worst case, in practice linear.
Repaired repair(format::Soup soup);

/// Of a surface, which is a soup of triangles alone, this alone: a vertex at which triangles fall apart
/// becomes several, so that holes that met in a vertex are one. O(n).
Repaired split_pinches(format::Soup surface);

} // namespace tetrarch::doctor
