// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/surfaces.hpp"
#include "tetrarch/surface/marked_surface.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

/// Whether corners and mates tell the same: mates have the same ends, in reverse.
void check_corners(const Surface& surface) {
  for (int k = 0; k < surface.side_count(); ++k) {
    const Side s(k);
    CHECK(surface.mate(surface.mate(s)) == s);
    CHECK(surface.from(s) == surface.to(surface.mate(s)));
    CHECK(surface.to(s) == surface.from(surface.mate(s)));
  }
}

TEST_CASE("Flips keep the surface, its vertices and its marks") {
  Random random(4);
  for (MarkedSurface surface : {cube_surface().marked(), genus_surface(2).marked(),
                                MarkedSurface(glued_polygon(canonical_word(2)))}) {
    const SurfaceType type = type_of(surface.surface);
    for (int k = 0; k < 3; ++k) set_mark(surface, Side(7 * k % surface.surface.side_count()), k + 1);
    std::vector<int> marks = surface.mark;
    for (int k = 0; k < 200; ++k) {
      const Side s(random.below(surface.surface.side_count()));
      const Side m = surface.surface.mate(s);
      if (surface.is_cut(s) || m.triangle() == s.triangle()) continue;
      const int a = surface.surface.apex(s);
      const int b = surface.surface.apex(m);
      flip_edge(surface, s);
      // The edge is the next side of both triangles now, between the apexes.
      CHECK(surface.surface.mate(s.next()) == m.next());
      CHECK(surface.surface.from(m.next()) == a);
      CHECK(surface.surface.to(m.next()) == b);
    }
    check_corners(surface.surface);
    CHECK(type_of(surface.surface) == type);
    // Named by gluings alone, there are as many vertices as before.
    Table<Side, Side> mate(surface.surface.side_count());
    for (int k = 0; k < mate.size(); ++k) mate[Side(k)] = surface.surface.mate(Side(k));
    CHECK(Surface(mate).vertex_count() == surface.surface.vertex_count());
    for (int k = 0; k < mate.size(); ++k) CHECK(surface[Side(k)] == -surface[mate[Side(k)]]);
    std::sort(marks.begin(), marks.end());
    std::vector<int> now = surface.mark;
    std::sort(now.begin(), now.end());
    CHECK(now == marks);
  }
}

} // namespace
