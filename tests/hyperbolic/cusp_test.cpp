// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/cusp.hpp"

#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/moves/simplify.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;

namespace {

std::vector<Cusp> cusps_of(const Triangulation& tri) {
  const Search found = find_structure(tri);
  REQUIRE(found.structure.outcome == Outcome::geometric);
  return cusps(found.triangulation, Skeleton(found.triangulation), found.structure.lengths);
}

std::vector<Cusp> cusps_of(const std::string& name) {
  return cusps_of(from_signature(name));
}

Triangulation mirror_image(const Triangulation& tri) {
  std::vector<int> image;
  for (int t = 0; t < tri.size(); ++t) image.push_back(t);
  return relabelled(tri, image, std::vector<Perm4>(image.size(), Perm4::swap(0, 1)));
}

double distance(std::complex<double> a, std::complex<double> b) {
  return std::abs(a - b);
}

} // namespace

TEST_CASE("shapes of cusps are those of the literature", "[hyperbolic]") {
  // The figure-eight knot: eight equilateral triangles, a lattice of sides 1 and 2 sqrt(3) (Thurston's notes,
  // chapter 4). Its sister: the same eight, the hexagonal lattice of side 2. The Whitehead link: regular
  // octahedron, squares. 5_2: SnapPy's documentation prints -0.49024466751 + 2.97944706648 i.
  // The magic manifold (6^3_1): arithmetic over Q(sqrt -7).
  const double root = std::sqrt(3.0);
  const struct {
    const char* signature;
    std::size_t count;
    std::complex<double> shape;
    double accuracy;
  } known[] = {{"cPcbbbiht", 1, {0, 2 * root}, 1e-12},
               {"cPcbbbdxm", 1, {0.5, root / 2}, 1e-12},
               {"eLPkbdcddhgggb", 2, {0, 2}, 1e-12},
               {"gvLQQcdeffeffffaafa", 3, {0.5, std::sqrt(7.0) / 2}, 1e-12},
               {"dLQbcccdero", 1, {-0.49024466751, 2.97944706648}, 1e-11}};
  for (const auto& k : known) {
    const std::vector<Cusp> found = cusps_of(k.signature);
    INFO(k.signature);
    REQUIRE(found.size() == k.count);
    for (const Cusp& cusp : found) {
      CHECK(cusp.orientable);
      CHECK(distance(cusp.shape, k.shape) < k.accuracy);
      CHECK(cusp.residual < 1e-12);
    }
  }
}

TEST_CASE("the Klein bottle of the Gieseking manifold is covered by the torus of the figure-eight knot",
          "[hyperbolic]") {
  const std::vector<Cusp> found = cusps_of("bkaaid");
  REQUIRE(found.size() == 1);
  CHECK_FALSE(found[0].orientable);
  CHECK(distance(found[0].shape, {0, 2 * std::sqrt(3.0)}) < 1e-12);
  // Four equilateral triangles, between horospheres at distance 1, so of side exp(-1/2).
  CHECK(found[0].area == Approx(std::sqrt(3.0) / std::exp(1.0)).epsilon(1e-12));
}

TEST_CASE("a shape does not depend on the horosphere; mirrored, it is minus its conjugate", "[hyperbolic]") {
  const Triangulation tri = from_signature("dLQbcccdero");
  const Skeleton skeleton(tri);
  auto found = hyperbolize(tri, skeleton);
  const Cusp before = cusps(tri, skeleton, found.lengths).at(0);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count()))
    found.lengths[e] += 2 * 0.3; // both ends move out by 0.3
  const Cusp after = cusps(tri, skeleton, found.lengths).at(0);
  CHECK(distance(before.shape, after.shape) < 1e-12);
  CHECK(after.area == Approx(before.area * std::exp(-0.6)).epsilon(1e-12));

  const Cusp seen = cusps_of(mirror_image(tri)).at(0);
  CHECK(distance(seen.shape, -std::conj(before.shape)) < 1e-12);
}

TEST_CASE("on the rim, where both translations are equally long, the real part is not negative",
          "[hyperbolic]") {
  // m207 has (1 + 4 sqrt(3) i) / 7, of absolute value 1: so say the gluing equations of SnapPea's kernel
  // (tests/oracle/record_cusp_shapes.py), up to -1 / shape. Mirrored, the other translation comes first.
  const Triangulation tri = from_signature("eLMkbcdddhxqlm");
  const std::complex<double> known{1 / 7.0, 4 * std::sqrt(3.0) / 7};
  for (const Triangulation& given : {tri, mirror_image(tri)}) {
    const std::vector<Cusp> found = cusps_of(given);
    REQUIRE(found.size() == 1);
    CHECK(distance(found[0].shape, known) < 1e-12);
  }
}

TEST_CASE("shapes survive other triangulations", "[hyperbolic]") {
  // Three cusps of one shape (the magic manifold, s776), and a mixture of a cusp and a geodesic boundary.
  for (const char* name : {"gvLQQcdeffeffffaafa", "dLQbcccdero", "eLPkbdcddhgggb"}) {
    const Triangulation tri = from_signature(name);
    std::vector<Cusp> first = cusps_of(tri);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      moves::Complex complex(tri);
      SplitMix64 random(seed);
      moves::shake(complex, 12, random);
      const std::vector<Cusp> other = cusps_of(complex.triangulation());
      REQUIRE(other.size() == first.size());
      for (const Cusp& cusp : other) {
        CHECK(cusp.residual < 1e-9);
        // In another order, and perhaps mirrored: tetrahedron 0 decides.
        CHECK(std::any_of(first.begin(), first.end(), [&](const Cusp& f) {
          return distance(f.shape, cusp.shape) < 1e-9 || distance(f.shape, -std::conj(cusp.shape)) < 1e-9;
        }));
      }
    }
  }
}

TEST_CASE("where lengths are those of no structure, the residual tells", "[hyperbolic]") {
  const Triangulation tri = from_signature("dLQbcccdero");
  const Skeleton skeleton(tri);
  auto found = hyperbolize(tri, skeleton);
  found.lengths[EdgeId(1)] += 0.05;
  CHECK(cusps(tri, skeleton, found.lengths).at(0).residual > 1e-3);
}
