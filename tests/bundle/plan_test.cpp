// SPDX-License-Identifier: GPL-2.0-or-later
/// Unit tangent bundles by the dissertation's constructions: chapters 5, 6 and 7 on every kind of surface.
#include "bundle/bundles.hpp"
#include "support/homology.hpp"
#include "tetrarch/bundle/gluable.hpp"
#include "tetrarch/bundle/plan.hpp"
#include "tetrarch/bundle/section.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/moves/simplify.hpp"
#include "tetrarch/surface/canonical_loops.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <stop_token>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

Plan plan_of(const surface::Surface& surface, const PlanOptions& options) {
  return std::get<Plan>(plan(surface::MarkedSurface(surface), options));
}

Triangulation simplified(const Triangulation& tri) {
  moves::Complex complex(tri);
  moves::simplify(complex);
  return complex.triangulation();
}

/// Assembles, proves, and audits the gluing maps.
CircleBundle checked(const Plan& plan) {
  CircleBundle bundle = assemble(plan.recipe);
  const Proof proof = prove(bundle, Skeleton(bundle.total));
  CHECK(proof.failure.empty());
  if (proof.has_euler_number) CHECK(proof.euler_number == plan.euler);
  for (const auto& pair : bands(plan.cut)) CHECK(why_not_gluable(pair, plan.recipe) == "");
  return bundle;
}

/// A base edge or diagonal of the total space: over side s, from level a above its start to level b above its
/// end. None if there is no such edge.
std::optional<EdgeId> edge_over(const CircleBundle& bundle, const Skeleton& skeleton, Side s, int a, int b) {
  const auto level = [&](int j) { return ((j % bundle.fiber) + bundle.fiber) % bundle.fiber; };
  for (int k = 0; k < 3 * bundle.fiber; ++k) {
    const int tet = 3 * bundle.fiber * s.triangle() + k;
    for (int v = 0; v < 4; ++v)
      for (int w = 0; w < 4; ++w)
        if (v != w && bundle.corner({tet, v}) == s.next().corner() &&
            bundle.corner({tet, w}) == s.previous().corner() && level(bundle.level({tet, v})) == level(a) &&
            level(bundle.level({tet, w})) == level(b) &&
            bundle.level({tet, w}) - bundle.level({tet, v}) == b - a)
          return skeleton.edge({tet, edge_number[v][w]});
  }
  return std::nullopt;
}

} // namespace

TEST_CASE("Spheres: closed, H1 = Z/2, and two tetrahedra in the end, which are RP^3", "[bundle]") {
  // Regina 7.3: Example3.lens(2, 1) has two tetrahedra and this signature.
  Random random(2);
  for (const TriangleList& list : {tetrahedron_surface(), cube_surface(), icosphere(0), icosphere(2),
                                   retriangulated(icosphere(1), random, 60, 20)})
    for (const int fiber : {1, 2, 3, 4, 7}) {
      INFO(list.triangles.size() << " triangles, N = " << fiber);
      const Plan p = plan_of(list.surface(), {fiber, {}, {}, {}});
      CHECK(p.method == Plan::Method::equator);
      const CircleBundle bundle = checked(p);
      CHECK(first_homology(bundle.total) == "Z/2");
      if (bundle.total.size() > 2000) continue;
      const Triangulation small = simplified(bundle.total);
      CHECK(small.size() == 2);
      CHECK(signature(small) == "cMcabbgqw");
    }
}

TEST_CASE("On a sphere the gluing map is that of Definition 6.3.1, and the fibres turn by 4 pi", "[bundle]") {
  // Definition 6.3.1, with grid structure [4N, 2N]: Psi(2, i, j) = (1, -i, j - i + N).
  for (const int n : {2, 3}) {
    const Plan p = plan_of(icosphere(2).surface(), {2 * n, {}, {}, {}});
    const auto pair = bands(p.cut)[0];
    REQUIRE(static_cast<int>(pair[0].sides.size()) == 4 * n);
    CHECK(pair[0].closed);
    CHECK(twist_along(pair[0], p.recipe) == -4 * n);
    for (const Band& band : pair)
      for (const Side s : band.sides) CHECK(p.recipe.value[s.value] == 1); // Definition 6.2.2
    // An equator has no first vertex: i = 0 is where the shift is N.
    int start = 0;
    while ((gluing_map(pair[0], p.recipe, {start, 0}).j - n) % (2 * n) != 0) ++start;
    REQUIRE(start < 4 * n);
    for (int i = 0; i < 4 * n; ++i)
      for (int j = 0; j < 2 * n; ++j) {
        const int at = (start + i) % (4 * n);
        const GridVertex image = gluing_map(pair[0], p.recipe, {at, j});
        CHECK((image.i + at) % (4 * n) == 0);
        CHECK((image.j - (j - i + n)) % (2 * n) == 0);
      }
  }
}

TEST_CASE("Genus g: canonical loops, two of them plain, all others of N edges with a turn of -2 pi",
          "[bundle]") {
  for (const int genus : {1, 2, 3})
    for (const int fiber : {1, 3, 8}) {
      INFO("genus " << genus << ", N = " << fiber);
      const Plan p = plan_of(genus_surface(genus).surface(), {fiber, {}, {}, {}});
      CHECK(p.method == Plan::Method::canonical_loops);
      CHECK(surface::why_not_canonical(p.cut).empty());
      CHECK(surface::boundary_word(p.cut) == canonical_word(genus));
      const auto all = bands(p.cut);
      REQUIRE(static_cast<int>(all.size()) == 2 * genus);
      for (std::size_t k = 0; k < all.size(); ++k) {
        // The shift of a loop goes from 0 to N, seen from the first bank; -2 pi as the text counts it.
        CHECK(twist_along(all[k][0], p.recipe) == (k < 2 ? 0 : fiber));
        if (k >= 2) CHECK(static_cast<int>(all[k][0].sides.size()) >= fiber);
        for (const Band& band : all[k])
          for (const int end : {0, static_cast<int>(band.sides.size())})
            CHECK(gluing_map(band, p.recipe, {end, 0}).j % fiber == 0); // Corollary 7.4.2: one border fibre
      }
      const CircleBundle bundle = checked(p);
      CHECK(first_homology(bundle.total) ==
            expected_homology(surface::type_of(p.cut.surface), 2 - 2 * genus));
    }
}

TEST_CASE("The expected group maps to that of the bundle: generators to paths, relators to paths that close",
          "[bundle]") {
  // < a_1, ..., a_2g, h | h central, [a_1, a_2] ... = h^e >: loop k goes to its base path at level 0, h to
  // the fibre over the base point. That a_k commutes with h is that the same path runs at every level. On the
  // disk's boundary the paths make one path in D x R, whose rise in all is that of h^e; D x R is simply
  // connected.
  for (const int genus : {1, 2, 3}) {
    const int fiber = 3;
    const Plan p = plan_of(genus_surface(genus).surface(), {fiber, {}, {}, {}});
    const CircleBundle bundle = assemble(p.recipe);
    const Skeleton skeleton(bundle.total);
    std::map<int, Band> band_of;
    for (const auto& pair : bands(p.cut))
      for (const Band& band : pair) band_of[band.mark] = band;
    int rise = 0;
    for (const int letter : surface::boundary_word(p.cut)) {
      const Band& band = band_of[letter];
      const Band& first = band_of[std::abs(letter)];
      const int length = static_cast<int>(band.sides.size());
      for (int i = 0; i < length; ++i) {
        // Along the second bank the path is seen where the gluing map takes it.
        GridVertex from{i, 0};
        GridVertex to{i + 1, 0};
        if (letter < 0) {
          from = gluing_map(first, p.recipe, {length - i, 0});
          to = gluing_map(first, p.recipe, {length - i - 1, 0});
        }
        CHECK(from.i == i);
        for (int j = 0; j < fiber; ++j) {
          const auto here = edge_over(bundle, skeleton, band.sides[i], from.j + j, to.j + j);
          const Side same = letter < 0 ? first.sides[length - 1 - i] : first.sides[i];
          REQUIRE(here.has_value());
          CHECK(*here == edge_over(bundle, skeleton, same, j, j));
        }
        if (i == 0) CHECK(from.j % fiber == 0);
        rise += to.j - from.j;
      }
    }
    CHECK(rise == p.euler * fiber);
  }
}

TEST_CASE("Higher genus and random retriangulations: H1 = Z^2g + Z/(2g-2)", "[bundle][slow]") {
  Random random(17);
  for (const int genus : {1, 2, 3, 5, 10}) {
    const TriangleList surface = genus_surface(genus);
    for (int trial = 0; trial < 50; ++trial) {
      const TriangleList list = relabelled(retriangulated(surface, random, 40 * genus, 10 * genus), random);
      const Plan p = plan_of(list.surface(), {1 + trial % 4, {}, {}, {}});
      const CircleBundle bundle = checked(p);
      CHECK(first_homology(bundle.total) ==
            expected_homology(surface::type_of(p.cut.surface), 2 - 2 * genus));
    }
  }
}

TEST_CASE("Any Euler number on equators, canonical loops and short cut graphs", "[bundle]") {
  for (const auto& list :
       {icosphere(1), torus_grid(4, 5), genus_surface(2), crosscaps(1), crosscaps(3), klein_grid(5, 4)})
    for (const int e : {-2, -1, 0, 1, 3})
      for (const auto cut : {PlanOptions::Cut::dissertation, PlanOptions::Cut::any}) {
        const SurfaceType type = surface::type_of(list.surface());
        INFO(type.str() << ", e = " << e);
        const CircleBundle bundle = checked(plan_of(list.surface(), {4, e, {}, cut}));
        CHECK(first_homology(bundle.total) == expected_homology(type, e));
      }
}

TEST_CASE("Where every edge of a cut is twisted and no vertex lies inside, one is put there", "[bundle]") {
  // By hand: the torus of one vertex has two edges in its cut, and e = 2 twists both if fibres have one edge;
  // then the values of the two triangles would all be the same.
  const Plan p = plan_of(glued_polygon(canonical_word(1)), {1, 2, {}, PlanOptions::Cut::any});
  CHECK(p.splits() == 1);
  CHECK(first_homology(checked(p).total) == "Z^2 + Z/2");
}

TEST_CASE("The audit of gluing maps finds what is wrong with them", "[bundle]") {
  const Plan good = plan_of(genus_surface(2).surface(), {4, {}, {}, {}});
  for (const auto& pair : bands(good.cut))
    for (std::size_t i = 0; i < pair[0].sides.size(); ++i) {
      const Side s = pair[0].sides[i];
      REQUIRE(why_not_gluable(pair, good.recipe) == "");
      Recipe bad = good.recipe;
      bad.value[s.value] = static_cast<std::int8_t>(-bad.value[s.value]);
      CHECK(why_not_gluable(pair, bad) == "the gluing map is no bijection of triangles that turns them over");
      bad = good.recipe;
      ++bad.shift[s.value].start; // this twists the edge the other way, or once more
      CHECK(!why_not_gluable(pair, bad).empty());
      ++bad.shift[s.value].stop; // this turns the whole edge
      const bool alone = pair[0].sides.size() == 1;
      if (!alone)
        CHECK(why_not_gluable(pair, bad) ==
              "edge " + std::to_string(i == 0 ? 1 : i) + ": the gluing map jumps along the curve");
      auto crossed = pair;
      std::swap(crossed[1], crossed[0]);
      std::reverse(crossed[1].sides.begin(), crossed[1].sides.end());
      if (!alone) CHECK(!why_not_gluable(crossed, good.recipe).empty());
    }
}

TEST_CASE("Two disks whose every boundary edge is twisted make lens spaces L(e,1)", "[bundle]") {
  // Regina 7.3 calls e = 1 to 3 S3, RP3 and L(3,1): see the small bundles. By hand: H1 = Z/e.
  for (const int e : {1, 2, 3, 5, 8}) {
    const Plan p = plan_of(icosphere(1).surface(), {3, e, {}, {}});
    CHECK(static_cast<int>(bands(p.cut)[0][0].sides.size()) >= 3 * e);
    const CircleBundle bundle = checked(p);
    CHECK(first_homology(bundle.total) == (e == 1 ? "0" : "Z/" + std::to_string(e)));
    CHECK(simplified(bundle.total).size() <= std::max(2, e));
  }
}

TEST_CASE("A disk takes the values of its boundary, or says which part cannot", "[bundle]") {
  // By hand: a square cut in two has no vertex inside; all values equal have no solution, others have one.
  const surface::Surface square(4, {{0, 1, 2}, {0, 2, 3}});
  const auto refused = plan(surface::MarkedSurface(square), {2, {}, BoundaryValues{1, 1, 1, 1}, {}});
  REQUIRE(std::holds_alternative<Obstruction>(refused));
  CHECK(std::get<Obstruction>(refused).triangles == std::vector<int>{0, 1});
  const auto solved = plan(surface::MarkedSurface(square), {2, {}, BoundaryValues{1, -1, 1, 1}, {}});
  const Plan& p = std::get<Plan>(solved);
  const std::vector<Side> sides = boundary_sides(square);
  for (std::size_t k = 0; k < sides.size(); ++k)
    CHECK(p.recipe.value[sides[k].value] == std::vector<int>{1, -1, 1, 1}[k]);
  checked(p);
}

TEST_CASE("Coordinates near the end of what doubles hold plan the bundle that small ones do", "[bundle]") {
  // Lengths of edges of 1e308 are infinite in doubles, and those of 1e-308 vanish in squares.
  for (const double size : {1e308, -1e308, 1.0, 1e-308}) {
    INFO(size);
    surface::MarkedSurface tetrahedron = tetrahedron_surface().marked();
    tetrahedron.points = {{size, 0, 0}, {-size, 0, 0}, {0, size, 0}, {0, 0, size}};
    for (const int fiber : {1, 8}) {
      const Plan p = std::get<Plan>(plan(tetrahedron, {fiber, {}, {}, {}}));
      checked(p);
      for (const auto& point : p.cut.points)
        for (const double x : point) CHECK(std::fabs(x) <= std::fabs(size));
      CHECK(p.cut.points[0] == tetrahedron.points[0]);
    }
  }
}

TEST_CASE("Planning stops when it is told to, whatever it cuts along", "[bundle]") {
  std::stop_source source;
  source.request_stop();
  const Progress stopped({}, source.get_token());
  for (const surface::MarkedSurface& surface : {icosphere(2).marked(), genus_surface(3).marked()})
    CHECK_THROWS_AS(static_cast<void>(plan(surface, {4, {}, {}, {}}, stopped)), Stopped);
}

TEST_CASE("What a surface does not have cannot be asked of its bundle", "[bundle]") {
  const surface::MarkedSurface sphere = tetrahedron_surface().marked();
  const surface::MarkedSurface disk(surface::Surface(3, {{0, 1, 2}}));
  CHECK_THROWS_AS(plan(sphere, {0, {}, {}, {}}), PreconditionError);
  CHECK_THROWS_AS(plan(sphere, {1, {}, BoundaryValues{}, {}}), PreconditionError);
  CHECK_THROWS_AS(plan(disk, {1, 1, {}, {}}), PreconditionError);
}
