// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/double_cover.hpp"

namespace tetrarch {

Triangulation orientable_double_cover(const Triangulation& tri) {
  const int n = tri.size();
  Triangulation cover(2 * n);
  for (int t = 0; t < n; ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet < 0) continue;
      const int change = g.perm.sign() < 0 ? 0 : n; // a gluing of equally handed tetrahedra is odd
      if (cover.is_boundary({t, f})) cover.glue({t, f}, (g.tet + change) % (2 * n), g.perm);
      if (cover.is_boundary({t + n, f})) cover.glue({t + n, f}, (g.tet + n + change) % (2 * n), g.perm);
    }
  return cover;
}

} // namespace tetrarch
