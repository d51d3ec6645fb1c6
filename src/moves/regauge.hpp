// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Changing the words of one triangle of a link by an element of the group.

#include "tetrarch/core/tet.hpp"
#include "tetrarch/moves/monodromy.hpp"

namespace tetrarch::moves {

/// Crossings out of the triangle begin with the inverse of g, those into it end with g: no loop changes.
template <class Gluings>
void regauge(const Gluings& tri, Monodromy& monodromy, TetVertex at, const FreeWord& g) {
  if (g.empty()) return;
  const FreeWord back = inverse(g);
  for (int f = 0; f < 4; ++f) {
    if (f == at.vertex) continue;
    const Gluing out = tri.gluing(TetFace{at.tet, f});
    FreeWord& leaving = monodromy.at(at.tet, at.vertex, f);
    leaving = product(back, leaving);
    if (out.tet < 0) continue;
    // A triangle may be its own neighbor: then its entries are changed from both sides, as they should be.
    FreeWord& entering = monodromy.at(out.tet, out.perm[at.vertex], out.perm[f]);
    entering = product(entering, g);
  }
}

} // namespace tetrarch::moves
