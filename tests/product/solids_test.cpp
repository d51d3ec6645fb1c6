// SPDX-License-Identifier: GPL-2.0-or-later
#include "product/solids.hpp"

#include "tetrarch/product/partition.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

struct Case {
  std::string name;
  Extrusion solid;
};

std::vector<Case> all_solids() {
  std::vector<Case> out;
  out.push_back({"box", box({2, 1, 3}, {3, 2, 4})});
  out.push_back({"cylinder", cylinder(4, 3)});
  out.push_back({"pipe", pipe(0.4, 1, 3)});
  out.push_back({"radial pipe", radial_pipe(0.4, 4)});
  for (int holes = 0; holes <= 5; ++holes) {
    const std::string count = std::to_string(holes);
    out.push_back({"plate with round holes: " + count, plate(holes, 6, 2)});
    out.push_back({"plate with square holes: " + count, plate(holes, 6, 2, Hole::square)});
    out.push_back({"shell with holes: " + count, shell(holes, 0.5, 4)});
    out.push_back({"bent plate with holes: " + count, bent(holes, 6, 3)});
  }
  return out;
}

/// Of the triangles of a base together.
double area(const product::Solid& solid, const std::vector<int>& base, int which) {
  double sum = 0;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    if (base[t] != which) continue;
    product::Point e{};
    product::Point f{};
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = solid.point(solid.corner(t, 1))[k] - solid.point(solid.corner(t, 0))[k];
      f[k] = solid.point(solid.corner(t, 2))[k] - solid.point(solid.corner(t, 0))[k];
    }
    sum += 0.5 * std::hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]);
  }
  return sum;
}

} // namespace

TEST_CASE("the solids of the tests are solids of the genus that they say", "[product]") {
  for (const Case& c : all_solids()) {
    INFO(c.name);
    const product::Solid solid = product::solid_of(c.solid.mesh);
    CHECK(product::genus(solid) == c.solid.holes);
    const std::vector<int> base = bases(solid, c.solid);
    CHECK(std::count(base.begin(), base.end(), 0) == std::count(base.begin(), base.end(), 1));
    CHECK(std::count(base.begin(), base.end(), -1) > 0);
    CHECK(product::partition(solid, base).holes() == c.solid.holes);
    for (int t = 0; t < solid.size(); ++t) {
      int lowest = c.solid.layers;
      int highest = 0;
      for (const int v : solid.corners(t)) {
        lowest = std::min(lowest, c.solid.layer(v));
        highest = std::max(highest, c.solid.layer(v));
      }
      if (highest != lowest + 1) FAIL("a tetrahedron of one base, or across layers");
    }
  }
}

TEST_CASE("the solids of the tests have the size that they say", "[product]") {
  const auto check = [](const Extrusion& e, int base, double expected) {
    const product::Solid solid = product::solid_of(e.mesh);
    CHECK(area(solid, bases(solid, e), base) == Approx(expected).epsilon(0.02));
  };
  const double pi = std::numbers::pi;
  check(box({2, 1, 3}, {3, 2, 4}), 0, 2);
  check(box({2, 1, 3}, {3, 2, 4}), -1, 2 * 3 * (2 + 1));
  check(cylinder(12, 4), 1, pi);
  check(cylinder(12, 4), -1, 2 * pi);
  check(plate(5, 12, 2), 0, 5 - 5 * pi / 16);
  check(plate(3, 6, 2, Hole::square), 1, 3 - 3 * 0.25);
  check(radial_pipe(0.4, 8), 0, 0.4 * 2 * pi * 0.5);
  check(radial_pipe(0.4, 8), 1, 2 * pi * 0.5);
  check(radial_pipe(0.4, 8), -1, 2 * pi * (1 - 0.16));
}

TEST_CASE("a solid of any usual size is taken, and a size that doubles cannot compute with is refused",
          "[product]") {
  const auto scaled = [](double factor) {
    solid::TetMesh mesh = box({2, 1, 3}, {3, 2, 4}).mesh;
    for (auto& p : mesh.points)
      for (double& x : p) x *= factor;
    return mesh;
  };
  for (const double factor : {1e-49, 1e-3, 1.0, 1e9, 1e49})
    CHECK(product::volume(product::solid_of(scaled(factor))) == Approx(6 * factor * factor * factor));
  for (const double factor : {1e-60, 1e60, 1e-300, 1e300})
    CHECK_THROWS_WITH(product::solid_of(scaled(factor)),
                      Catch::Contains(" across; sizes between 1e-50 and 1e50"));
}
