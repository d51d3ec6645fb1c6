// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/partition.hpp"

#include "product/solids.hpp"
#include "support/errors.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::product;
using support::error_of;

namespace {

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("A plate with holes has as many walls as holes and one", "[partition]") {
  for (int holes = 0; holes <= 5; ++holes) {
    const support::Extrusion from = support::plate(holes, 6, 2);
    const Solid whole = solid_of(from.mesh);
    const Partition p = partition(whole, support::bases(whole, from));
    CHECK(p.walls == holes + 1);
    CHECK(p.holes() == holes);
    // Everything is covered, and wall 0 is the outer one.
    for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
      const int patch = p.patch[t];
      REQUIRE((patch >= 0 && patch < first_wall + p.walls));
      bool outside = true;
      for (int c = 0; c < 3; ++c) {
        const Point& q = whole.point(whole.corner(t, c));
        outside = outside && (q[0] == 0 || q[0] == std::max(holes, 1) || q[1] == 0 || q[1] == 1);
      }
      if (patch >= first_wall) CHECK(outside == (patch == first_wall));
    }
  }
}

TEST_CASE("The outer wall may be chosen", "[partition]") {
  const support::Extrusion from = support::plate(2, 6, 2);
  const Solid whole = solid_of(from.mesh);
  const std::vector<int> base = support::bases(whole, from);
  const Partition longest = partition(whole, base);
  for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
    if (longest.patch[t] != first_wall + 2) continue;
    const Partition chosen = partition(whole, base, t);
    CHECK(chosen.patch[t] == first_wall);
    return;
  }
  FAIL("there is no third wall");
}

TEST_CASE("A floor whose loops bound in the solid is refused", "[partition]") {
  // A ring cut like a cake: floor and ceiling are strips around its section, whose rims are meridians.
  const support::Extrusion from = support::pipe(0.4, 1, 3);
  const Solid whole = solid_of(from.mesh);
  std::vector<int> base(static_cast<std::size_t>(whole.boundary.triangle_count()), -1);
  for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
    std::array<double, 2> p{};
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 2; ++k) p[k] += whole.point(whole.corner(t, c))[k];
    if (std::abs(p[1]) < 0.9 * std::abs(p[0])) base[t] = p[0] > 0 ? 0 : 1;
  }
  CHECK(says(error_of([&] { (void)partition(whole, base); }), "do not generate the first homology"));
}

TEST_CASE("A floor that goes around the handle twice is refused", "[partition]") {
  // On a ring, strips that go around it twice while they go around its section once: all patches are
  // cylinders as they should be, but the floor's loop is twice a generator.
  const support::Extrusion from = support::pipe(0.4, 1, 12, 0);
  const Solid whole = solid_of(from.mesh);
  for (const int turns : {1, 2}) {
    std::vector<int> base(static_cast<std::size_t>(whole.boundary.triangle_count()), -1);
    for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
      double least = 1;
      double greatest = -1;
      for (int c = 0; c < 3; ++c) {
        const Point& p = whole.point(whole.corner(t, c));
        const double around = std::atan2(p[1], p[0]);
        const double section = std::atan2(p[2] - 0.5, (std::hypot(p[0], p[1]) - 0.7) / 0.6);
        least = std::min(least, std::cos(turns * section - around));
        greatest = std::max(greatest, std::cos(turns * section - around));
      }
      if (least > 0.2) base[t] = 0;
      if (greatest < -0.2) base[t] = 1;
    }
    const std::string error = error_of([&] { (void)partition(whole, base); });
    INFO(turns << ": " << error);
    CHECK(error.empty() == (turns == 1));
    if (turns == 2) CHECK(says(error, "do not generate the first homology"));
  }
}

TEST_CASE("Where floor and ceiling touch, and where a floor is pinched, is named", "[partition]") {
  // A box of 4 x 2 x 2 boxes; vertex i + 5 j + 15 k is at (i, j, k).
  const support::Extrusion from = support::box({4, 2, 2}, {4, 2, 2}, 0);
  const Solid whole = solid_of(from.mesh);
  // Of each triangle the middle of the square of the boundary that it is a half of.
  const auto bases_where = [&](const auto& base_at) {
    std::vector<int> base;
    for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
      Point middle{};
      for (int k = 0; k < 3; ++k) {
        std::array<double, 3> x{};
        for (int c = 0; c < 3; ++c) x[c] = whole.point(whole.corner(t, c))[k];
        const auto [least, greatest] = std::minmax_element(x.begin(), x.end());
        middle[k] = (*least + *greatest) / 2;
      }
      base.push_back(base_at(middle));
    }
    return base;
  };
  const auto error = [&](const auto& base_at) {
    const std::vector<int> base = bases_where(base_at);
    return error_of([&] { (void)partition(whole, base); });
  };
  const auto square = [](const Point& m, double x, double y) { return m[0] == x && m[1] == y; };
  CHECK(error([&](const Point& m) {
          return m[2] == 2 ? 1 : m[2] == 0 && square(m, 1.5, 0.5) ? 0 : -1;
        }) == "");
  // Two squares below that meet at (1, 1, 0), vertex 6, corner to corner.
  CHECK(error([&](const Point& m) {
          if (m[2] != 0) return -1;
          return square(m, 0.5, 0.5) ? 0 : square(m, 1.5, 1.5) ? 1 : -1;
        }) == "floor and ceiling touch at vertex 6");
  // Two that meet at (2, 1, 0), vertex 7, corner to corner, joined by a strip around the lower half of the
  // box's end.
  CHECK(error([&](const Point& m) {
          if (m[2] == 2) return 1;
          if (m[2] == 0) return square(m, 1.5, 0.5) || square(m, 2.5, 1.5) || square(m, 3.5, 1.5) ? 0 : -1;
          return m[2] == 0.5 && ((m[1] == 0 && m[0] > 1) || m[0] == 4) ? 0 : -1;
        }) == "the floor is pinched at vertex 7: several fans of its triangles meet there");
}

TEST_CASE("What has the wrong topology is named", "[partition]") {
  const support::Extrusion from = support::plate(1, 6, 3);
  const Solid whole = solid_of(from.mesh);
  const std::vector<int> good = support::bases(whole, from);
  const auto error = [&](const auto& change) {
    std::vector<int> base = good;
    change(base);
    return error_of([&] { (void)partition(whole, base); });
  };
  CHECK(error([](auto&) {}) == "");
  CHECK(says(error([](auto& b) { std::replace(b.begin(), b.end(), 1, -1); }), "ceiling"));
  CHECK(says(error([](auto& b) { std::replace(b.begin(), b.end(), -1, 1); }), "touch"));
  // A hole in the floor that is no hole of the solid.
  const std::string punched = error([&](auto& b) {
    for (int t = 0; t < whole.boundary.triangle_count(); ++t)
      for (int c = 0; c < 3; ++c) {
        const Point& p = whole.point(whole.corner(t, c));
        if (p[2] == 0 && std::abs(p[0] - 0.12) < 0.1 && std::abs(p[1] - 0.12) < 0.1) b[t] = -1;
      }
  });
  CHECK(says(punched, "floor"));
  // Half of the ceiling is a ceiling, too, the other half a wall: no cylinder.
  const std::string half = error([&](auto& b) {
    for (int t = 0; t < whole.boundary.triangle_count(); ++t)
      if (b[t] == 1 && whole.point(whole.corner(t, 0))[0] < 0.5) b[t] = -1;
  });
  CHECK(says(half, "ceiling"));
}
