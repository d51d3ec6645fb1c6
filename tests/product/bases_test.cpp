// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/bases.hpp"

#include "product/solids.hpp"
#include "support/errors.hpp"
#include "tetrarch/product/automatic.hpp"
#include "tetrarch/product/partition.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::product;
using support::error_of;

namespace {

int find_vertex(const Solid& solid, const Point& p) {
  const auto at = std::find_if(solid.mesh.points.begin(), solid.mesh.points.end(), [&](const Point& q) {
    return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 1e-9;
  });
  REQUIRE(at != solid.mesh.points.end());
  return static_cast<int>(at - solid.mesh.points.begin());
}

/// The rims of floor and ceiling as walks, from the bases that are known.
std::vector<std::vector<int>> rims(const Solid& solid, const std::vector<int>& base) {
  surface::Surface torn = solid.boundary;
  for (int k = 0; k < torn.side_count(); ++k) {
    const surface::Side s(k);
    if (base[s.triangle()] != base[solid.boundary.mate(s).triangle()] && !torn.is_boundary(s)) torn.unglue(s);
  }
  std::vector<std::vector<int>> walks;
  for (const auto& curve : surface::boundary_curves(torn)) {
    if (base[curve.front().side.triangle()] < 0) continue; // each rim once
    std::vector<int>& walk = walks.emplace_back();
    for (const surface::SideEnd e : curve) walk.push_back(solid.vertex[torn.vertex(e)]);
  }
  return walks;
}

/// The same patches, floor and ceiling exchanged or not.
bool same(const std::vector<int>& a, const std::vector<int>& b) {
  bool equal = true;
  bool exchanged = true;
  for (std::size_t t = 0; t < a.size(); ++t) {
    equal = equal && a[t] == b[t];
    exchanged = exchanged && a[t] == (b[t] < 0 ? -1 : 1 - b[t]);
  }
  return equal || exchanged;
}

} // namespace

TEST_CASE("Labels point out the bases, whatever the order of vertices", "[bases]") {
  const support::Extrusion from = support::plate(2, 4, 2);
  const Solid whole = solid_of(from.mesh);
  const std::vector<int> base = support::bases(whole, from);
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> label;
  for (int t = whole.boundary.triangle_count() - 1; t >= 0; --t) {
    triangles.push_back({whole.corner(t, 1), whole.corner(t, 0), whole.corner(t, 2)});
    label.push_back(base[t] + 5);
  }
  CHECK(bases_with_labels(whole, triangles, label, {5, 6}) == base);
  CHECK(error_of([&] {
          (void)bases_with_labels(whole, triangles, label, {5, 9});
        }) == "no triangle has label 9");
  triangles.push_back({0, 1, static_cast<int>(whole.mesh.points.size()) - 1});
  label.push_back(6);
  CHECK(error_of([&] {
          (void)bases_with_labels(whole, triangles, label, {5, 6});
        }).find("is not on the boundary") != std::string::npos);
}

TEST_CASE("Rims cut the boundary into bases and walls", "[bases]") {
  for (int holes = 0; holes <= 3; ++holes) {
    const support::Extrusion from = support::plate(holes, 6, 2);
    const Solid whole = solid_of(from.mesh);
    const std::vector<int> base = support::bases(whole, from);
    const auto walks = rims(whole, base);
    REQUIRE(static_cast<int>(walks.size()) == 2 * (holes + 1));
    const std::vector<int> found = bases_between_cycles(whole, walks);
    // With one hole all pieces are annuli; a plate's bases are flatter than its walls.
    CHECK(same(found, base));
    CHECK(partition(whole, found).holes() == holes);
  }
}

TEST_CASE("Rims that are none or too few are refused", "[bases]") {
  const support::Extrusion from = support::plate(2, 6, 2);
  const Solid whole = solid_of(from.mesh);
  auto walks = rims(whole, support::bases(whole, from));
  walks.resize(1); // does not even separate
  CHECK(error_of([&] { (void)bases_between_cycles(whole, walks); }).find("expected two bases") !=
        std::string::npos);
  CHECK(error_of([&] {
          (void)bases_between_cycles(whole, {{0, 1, 100}});
        }).find("are no edge") != std::string::npos);
}

TEST_CASE("Flooding goes as far as triangles face the way of the seed", "[bases]") {
  const support::Extrusion from = support::plate(2, 6, 2, support::Hole::round, 0.5, 0);
  const Solid whole = solid_of(from.mesh);
  const std::vector<int> base = support::bases(whole, from);
  const Flooding seeds{{find_vertex(whole, {1, 0.5, 0}), find_vertex(whole, {1, 0.5, 0.5})}, 0.3};
  CHECK(bases_by_flooding(whole, seeds) == base);
  // On a sphere: normals are within acos(1 - threshold) of that at the seed.
  const support::Extrusion shell = support::shell(0, 0.6, 8);
  const Solid round = solid_of(shell.mesh);
  int floor_seed = -1;
  int ceiling_seed = -1;
  for (int v = 0; v < static_cast<int>(shell.at.size()); ++v) {
    if (std::hypot(shell.at[v][0] - 0.5, shell.at[v][1] - 0.5) > 0.1) continue;
    if (shell.layer(v) == 0) floor_seed = v;
    if (shell.layer(v) == shell.layers) ceiling_seed = v;
  }
  const auto area_at = [&](double threshold) {
    const auto found = bases_by_flooding(round, {{floor_seed, ceiling_seed}, threshold});
    return std::count(found.begin(), found.end(), 0);
  };
  CHECK(area_at(0.02) < area_at(0.1));
  CHECK(area_at(0.1) < area_at(0.9));
}

TEST_CASE("Seeds that are none are refused", "[bases]") {
  const support::Extrusion from = support::plate(1, 6, 2);
  const Solid whole = solid_of(from.mesh);
  const int below = find_vertex(whole, {0, 0, 0});
  int inside = -1;
  for (int v = 0; v < static_cast<int>(whole.on_boundary.size()); ++v)
    if (whole.on_boundary[v] < 0) inside = v;
  REQUIRE(inside >= 0);
  const auto error = [&](int floor, int ceiling, double threshold) {
    return error_of([&] { (void)bases_by_flooding(whole, {{floor, ceiling}, threshold}); });
  };
  CHECK(error(inside, below, 0.3).find("not on the boundary") != std::string::npos);
  CHECK(error(100'000, below, 0.3).find("not on the boundary") != std::string::npos);
  CHECK(error(below, below, 2).find("meet") != std::string::npos);
  CHECK(error(below, below, 0).find("it may lie on a ridge") != std::string::npos);
}

TEST_CASE("Tunnels grow to walls", "[bases]") {
  // A pipe 2 high, loops half way up: walls 2 * 0.45 high, and the rest of the walls goes with the bases.
  const support::Extrusion from = support::pipe(0.5, 2, 8, 0);
  const Solid whole = solid_of(from.mesh);
  std::vector<std::vector<int>> loops;
  for (const double radius : {0.5, 1.0}) {
    std::vector<int>& loop = loops.emplace_back();
    for (int k = 0; k < 48; ++k) {
      const double angle = 2 * 3.14159265358979323846 * k / 48;
      loop.push_back(find_vertex(whole, {radius * std::cos(angle), radius * std::sin(angle), 1}));
    }
  }
  const std::vector<int> found = bases_beyond_tunnels(whole, loops, 0.45);
  const Partition p = partition(whole, found);
  CHECK(p.walls == 2);
  for (int t = 0; t < whole.boundary.triangle_count(); ++t) {
    double low = 9;
    double high = -9;
    for (int c = 0; c < 3; ++c) {
      low = std::min(low, whole.point(whole.corner(t, c))[2]);
      high = std::max(high, whole.point(whole.corner(t, c))[2]);
    }
    CHECK((p.patch[t] >= first_wall) == (low > 0.5 && high < 1.5));
  }
  CHECK(error_of([&] { (void)bases_beyond_tunnels(whole, {loops[0]}, 0.45); }) != "");
}

TEST_CASE("Without help the bases of plates are found between ridges, however they lie", "[bases]") {
  for (int holes = 0; holes <= 3; ++holes) {
    support::Extrusion from = support::plate(holes, 6, 2, support::Hole::round, 0.3);
    for (Point& p : from.mesh.points) p = {0.6 * p[0] - 0.8 * p[2], p[1] + 3, 0.8 * p[0] + 0.6 * p[2]};
    const Solid whole = solid_of(from.mesh);
    const auto found = automatic_partition(whole);
    REQUIRE(found);
    std::vector<int> base;
    for (const int patch : found->partition.patch) base.push_back(patch < first_wall ? patch : -1);
    if (holes > 0) CHECK(same(base, support::bases(whole, from)));
    CHECK(found->partition.holes() == holes);
  }
}

TEST_CASE("Without help a smooth solid is divided by the way it faces, rims being split", "[bases]") {
  // A ring, its section a circle: a torus.
  support::Extrusion from = support::pipe(0.5, 1, 6, 0);
  for (Point& p : from.mesh.points) {
    const double around = std::hypot(p[0], p[1]);
    // The square [0.5, 1] x [0, 1] to a disk of radius 0.25 about (0.75, 0).
    const double x = 4 * around - 3;
    const double z = 2 * p[2] - 1;
    const double round_x = x * std::sqrt(1 - z * z / 2);
    const double round_z = z * std::sqrt(1 - x * x / 2);
    p = {p[0] / around * (0.75 + 0.25 * round_x), p[1] / around * (0.75 + 0.25 * round_x), 0.25 * round_z};
  }
  const Solid whole = solid_of(from.mesh);
  const auto found = automatic_partition(whole);
  REQUIRE(found);
  CHECK(found->partition.holes() == 1);
  CAPTURE(found->how, found->score);
  CHECK(found->how.find("the axis (") != std::string::npos);
  // Of a round torus, with bases where the cosine between normal and its axis is beyond c, the score is
  // 2 sqrt(1 - c c) / pi; of the thresholds 0.2 gives the most.
  CHECK(found->score == Approx(2 / std::numbers::pi * std::sqrt(1 - 0.2 * 0.2)).epsilon(0.01));
  CHECK(found->solid.size() > whole.size());
  for (std::size_t v = 0; v < whole.mesh.points.size(); ++v)
    REQUIRE(found->solid.mesh.points[v] == whole.mesh.points[v]);
  // What was split is told, in order, so that anything known at the old vertices can be carried to the new.
  std::vector<Point> carried = whole.mesh.points;
  for (const solid::EdgePoint& s : found->splits) {
    REQUIRE(std::max(s.from, s.to) < static_cast<int>(carried.size()));
    Point p{};
    for (std::size_t a = 0; a < 3; ++a) p[a] = (1 - s.part) * carried[s.from][a] + s.part * carried[s.to][a];
    carried.push_back(p);
  }
  REQUIRE(carried.size() == found->solid.mesh.points.size());
  CHECK(carried.size() > whole.mesh.points.size());
  CHECK(carried == found->solid.mesh.points);
  AutomaticOptions options;
  options.threads = 3;
  const auto again = automatic_partition(whole, options);
  REQUIRE(again);
  CHECK(again->how == found->how);
  CHECK(again->solid.mesh.points == found->solid.mesh.points);
  CHECK(again->partition.patch == found->partition.patch);
}
