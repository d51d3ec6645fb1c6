// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/untangle.hpp"

#include "support/random.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/product/polycube.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::product;
using support::Random;

namespace {

/// Those of 3 x 3 x 3 cubes that are wanted.
template <class Wanted>
HexMesh cubes(const Wanted& wanted) {
  Polycube polycube;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if (wanted(x, y, z)) polycube.cubes.push_back({x, y, z});
  return hexahedra(polycube);
}

HexMesh block() {
  return cubes([](int, int, int) { return true; });
}
/// A frame, three cubes high, around a square hole.
HexMesh frame() {
  return cubes([](int x, int y, int) { return x != 1 || y != 1; });
}

int count(const std::vector<Sliding>& all, Sliding::Kind kind) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](const Sliding& s) { return s.kind == kind; }));
}

/// Moves all points as they may slide.
void shake(HexMesh& mesh, double by, int seed, bool with_surface) {
  Random random(seed);
  const std::vector<Sliding> may = sliding(mesh);
  for (std::size_t v = 0; v < may.size(); ++v) {
    numeric::Vector step{};
    for (double& x : step) x = by * (2 * random.uniform() - 1);
    const double along = numeric::dot(step, may[v].direction);
    for (std::size_t a = 0; a < 3; ++a) {
      const double part = along * may[v].direction[a];
      if (may[v].kind == Sliding::Kind::free) mesh.points[v][a] += step[a];
      if (may[v].kind == Sliding::Kind::plane && with_surface) mesh.points[v][a] += step[a] - part;
      if (may[v].kind == Sliding::Kind::ridge && with_surface) mesh.points[v][a] += part;
    }
  }
}

} // namespace

TEST_CASE("Points of blocks and frames slide in planes and along ridges", "[untangle]") {
  // By hand, of 4^3 points: 8 corners, 12 ridges of 2, 6 sides of 4, 8 inside.
  const std::vector<Sliding> of_block = sliding(block());
  CHECK(count(of_block, Sliding::Kind::fixed) == 8);
  CHECK(count(of_block, Sliding::Kind::ridge) == 24);
  CHECK(count(of_block, Sliding::Kind::plane) == 24);
  CHECK(count(of_block, Sliding::Kind::free) == 8);
  // The frame has 8 corners more, and 4 ridges of 2 in the hole instead of 8 points inside; on top and bottom
  // the 4 points are those corners.
  const std::vector<Sliding> of_frame = sliding(frame());
  CHECK(count(of_frame, Sliding::Kind::fixed) == 16);
  CHECK(count(of_frame, Sliding::Kind::ridge) == 32);
  CHECK(count(of_frame, Sliding::Kind::plane) == 16);
  CHECK(count(of_frame, Sliding::Kind::free) == 0);
  // A corner that is pushed bends three sides, and holds what is on the squares around.
  HexMesh bent = block();
  *std::find(bent.points.begin(), bent.points.end(), Point{3, 3, 3}) = {3.2, 3.1, 3.3};
  CHECK(count(sliding(bent), Sliding::Kind::fixed) == 8 + 3 + 3);
}

TEST_CASE("Random foldings of a block are untangled, with a fixed surface or a sliding one", "[untangle]") {
  int most = 0;
  for (int seed = 0; seed < 60; ++seed)
    for (const bool slides : {false, true}) {
      HexMesh mesh = slides && seed % 2 == 1 ? frame() : block();
      const HexMesh flat = mesh;
      shake(mesh, 0.4 + 0.02 * seed, seed, slides);
      const HexMesh tangled = mesh;
      std::vector<char> fixed;
      if (!slides)
        for (const Sliding& s : sliding(flat))
          fixed.push_back(static_cast<char>(s.kind != Sliding::Kind::free));
      const Untangled done = untangle(mesh, fixed);
      most = std::max(most, done.bad_before);
      CAPTURE(seed, slides, done.bad_before, done.iterations);
      CHECK(done.bad_after == 0);
      CHECK(quality(mesh).minimum == done.minimum_after);
      // The solid is what it was.
      CHECK(volume(mesh) == Approx(static_cast<double>(flat.hexahedra.size())).epsilon(1e-9));
      for (std::size_t v = 0; v < fixed.size(); ++v)
        if (fixed[v] != 0) REQUIRE(mesh.points[v] == tangled.points[v]);
      CHECK(mesh.hexahedra == flat.hexahedra);
    }
  CHECK(most > 15);
}

TEST_CASE("Untangling makes no mesh worse", "[untangle]") {
  HexMesh good = block();
  const HexMesh before = good;
  CHECK(untangle(good).bad_after == 0);
  CHECK(quality(good).minimum > 1 - 1e-6);
  for (std::size_t v = 0; v < before.points.size(); ++v)
    CHECK(numeric::distance(good.points[v], before.points[v]) < 1e-6);
  // A corner beyond the opposite one: the boundary encloses 27 - 40, so nothing can be done in full.
  HexMesh hopeless = block();
  *std::find(hopeless.points.begin(), hopeless.points.end(), Point{0, 0, 0}) = {40, 40, 40};
  const HexQuality then = quality(hopeless);
  const Untangled done = untangle(hopeless);
  CHECK(done.bad_after > 0);
  CHECK_FALSE(is_better(then, quality(hopeless)));
  HexMesh none;
  CHECK(untangle(none).bad_after == 0);
  CHECK_THROWS_AS(untangle(good, {1}), PreconditionError);
}
