// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/surface/strands.hpp"

#include "src/surface/corner_sides.hpp"
#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace {

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::support;

/// From the corner of triangle 0 opposite its side 0 across that side, `count` strands side by side to the
/// corner beyond.
struct Bundle {
  MarkedSurface surface = icosphere(1).marked();
  std::vector<Strand> strands;
  Table<Side, std::vector<Crossing>> order{surface.surface.side_count()};

  explicit Bundle(int count) {
    const Side s(0, 0);
    const Side m = surface.surface.mate(s);
    for (int k = 0; k < count; ++k) {
      strands.push_back({corner_at(0, 0), {s}, corner_at(m.triangle(), m.corner()), k + 1});
      order[Side(std::min(s.value, m.value))].push_back({k, 0});
    }
  }
};

TEST_CASE("Strands become edges from corner to corner") {
  for (const int count : {1, 2, 5}) {
    Bundle bundle(count);
    MarkedSurface surface = bundle.surface;
    const int triangles = surface.surface.triangle_count();
    CHECK(lay_strands(surface, bundle.strands, bundle.order) == count);
    CHECK(type_of(surface.surface).is_sphere());
    // By hand: each of the two triangles is cut into count + 1 from its corner.
    CHECK(surface.surface.triangle_count() == triangles + 2 * count);
    for (int k = 1; k <= count; ++k) {
      CHECK(std::count(surface.mark.begin(), surface.mark.end(), k) == 2);
    }
    int starts = 0;
    for (int k = 0; k < surface.surface.side_count(); ++k)
      if (const Side s(k); surface[s] > 0 && surface.surface.from(s) == bundle.surface.surface.corners(0)[0])
        ++starts;
    CHECK(starts == count);
    for (int t = 0; t < surface.surface.triangle_count(); ++t)
      CHECK((surface.origin[t] >= 0 && surface.origin[t] < triangles));
  }
}

TEST_CASE("New vertices halve an edge, and its halves") {
  Bundle bundle(3);
  MarkedSurface surface = bundle.surface;
  lay_strands(surface, bundle.strands, bundle.order);
  REQUIRE(surface.splits.size() == 3);
  const Side first(std::min(0, bundle.surface.surface.mate(Side(0, 0)).value));
  const int from = bundle.surface.surface.from(first);
  const int to = bundle.surface.surface.to(first);
  CHECK(surface.splits[0].of == std::array{from, to, -1});
  CHECK(surface.splits[1].of == std::array{from, surface.splits[0].vertex, -1});
  CHECK(surface.splits[2].of == std::array{surface.splits[0].vertex, to, -1});
}

TEST_CASE("Strands do not cross marks or run along edges") {
  Bundle marked(1);
  set_mark(marked.surface, Side(0, 0), 7);
  CHECK_THROWS_AS(lay_strands(marked.surface, marked.strands, marked.order), PreconditionError);
  Bundle along(1);
  along.strands[0].from = corner_at(0, 1); // at the end of the side crossed
  CHECK_THROWS_AS(lay_strands(along.surface, along.strands, along.order), PreconditionError);
}

TEST_CASE("A surface from corners and mates is the one that they were taken from") {
  for (const TriangleList& mesh : {icosphere(1), torus_grid(4, 5)}) {
    const Surface surface = mesh.surface();
    std::vector<Side> mates;
    for (int k = 0; k < surface.side_count(); ++k) mates.push_back(surface.mate(Side(k)));
    const Surface again(surface.vertex_count(), surface.triangles(), Table<Side, Side>(mates));
    CHECK(again.triangles() == surface.triangles());
    CHECK(type_of(again) == type_of(surface));
    std::vector<Side> wrong = mates;
    std::swap(wrong[0], wrong[1]);
    CHECK_THROWS_AS(Surface(surface.vertex_count(), surface.triangles(), Table<Side, Side>(wrong)),
                    PreconditionError);
    CHECK_THROWS_AS(Surface(3, surface.triangles(), Table<Side, Side>(mates)), PreconditionError);
    mates.pop_back();
    CHECK_THROWS_AS(Surface(surface.vertex_count(), surface.triangles(), Table<Side, Side>(mates)),
                    PreconditionError);
  }
}

} // namespace
