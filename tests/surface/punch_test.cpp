// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/surface/punch.hpp"

#include "opened_meshes.hpp"
#include "support/errors.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

using namespace tetrarch;
using namespace tetrarch::surface;
using namespace tetrarch::surface::test;
using Catch::Matchers::Contains;
using support::error_of;

namespace {

/// What is left is what was there: names, points and corners, in their order.
void check_kept(const OpenedMesh& before, const OpenedMesh& after) {
  CHECK(is_valid(after.mesh));
  CHECK(std::is_sorted(after.number.begin(), after.number.end()));
  CHECK(std::is_sorted(after.triangle_of.begin(), after.triangle_of.end()));
  for (std::size_t v = 0; v < after.number.size(); ++v)
    CHECK(after.mesh.points[v] == before.mesh.points[static_cast<std::size_t>(after.number[v])]);
  for (int t = 0; t < after.mesh.surface.triangle_count(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(after.number[after.mesh.surface.corners(t)[c]] ==
            before.mesh.surface.corners(after.triangle_of[t])[c]);
}

} // namespace

TEST_CASE("A round hole takes the triangles whose corners lie in the ball", "[punch]") {
  const OpenedMesh whole = plane();
  const OpenedMesh punched = punch(whole, {{at(5, 5), 1.5}});
  check_kept(whole, punched);
  // By hand: the ball of radius 1.5 has the 3 x 3 vertices around the centre, so 4 squares of 2 triangles go,
  // and with them the centre.
  CHECK(punched.mesh.surface.triangle_count() == 192);
  CHECK(punched.mesh.surface.vertex_count() == 120);
  CHECK(std::count(punched.number.begin(), punched.number.end(), at(5, 5)) == 0);
  CHECK(type_of(punched.mesh.surface).str() == "sphere, 2 holes");
  // The neighbours across diagonals are at sqrt(2); that is what a radius must reach.
  CHECK(punch(whole, {{at(5, 5), std::sqrt(2.0)}}).number == punched.number);
  CHECK_THAT(error_of([&] {
               static_cast<void>(punch(whole, {{at(5, 5), 1.4}}));
             }),
             Contains("radius 1.4") && Contains("vertex 60") && Contains("1.414213562"));
}

TEST_CASE("A ball does not reach through to another sheet", "[punch]") {
  // Two sheets 0.1 apart in the middle, which meet far away.
  support::TriangleList flat = support::icosphere(4);
  for (auto& p : flat.points) p[2] *= 0.05;
  const OpenedMesh whole = opened(flat);
  const auto north = std::find(flat.points.begin(), flat.points.end(), std::array<double, 3>{0, 0, 0.05});
  const OpenedMesh punched = punch(whole, {{north - flat.points.begin(), 0.5}});
  check_kept(whole, punched);
  CHECK(type_of(punched.mesh.surface).is_disk());
  for (std::size_t v = 0; v < flat.points.size(); ++v) {
    const bool is_kept = std::count(punched.number.begin(), punched.number.end(), v) == 1;
    if (flat.points[v][2] <= 0) CHECK(is_kept);
  }
}

TEST_CASE("A hole that touches itself, or surrounds something, takes that too", "[punch]") {
  const OpenedMesh whole = plane();
  // The triangles of squares.
  const auto squares = [](const std::vector<std::array<int, 2>>& lower) {
    std::vector<int> triangles;
    for (const auto& [i, j] : lower)
      for (const int half : {0, 1}) triangles.push_back(2 * (10 * i + j) + half);
    return triangles;
  };
  // Around square (4, 4), less a corner: the ring meets itself at vertex (5, 5) alone. The star there closes
  // the ring, and all nine squares are gone; by hand.
  const auto ring = squares({{3, 3}, {3, 4}, {3, 5}, {4, 3}, {4, 5}, {5, 3}, {5, 4}});
  const OpenedMesh pinched = punch_triangles(whole, {ring});
  check_kept(whole, pinched);
  CHECK(pinched.mesh.surface.triangle_count() == 200 - 18);
  CHECK(pinched.mesh.surface.vertex_count() == 121 - 4);
  CHECK(type_of(pinched.mesh.surface).str() == "sphere, 2 holes");
  auto closed = ring;
  for (const int t : squares({{5, 5}})) closed.push_back(t);
  CHECK(punch_triangles(whole, {closed}).number == pinched.number);
}

TEST_CASE("Many holes in random surfaces leave what they should", "[punch]") {
  support::Random random(3);
  int done = 0;
  for (int round = 0; round < 60; ++round) {
    const auto list = support::relabelled(
        support::retriangulated(support::torus_grid(24, 16), random, 30 * (round % 4), 60), random);
    const OpenedMesh whole = opened(list);
    std::vector<RoundHole> holes;
    for (int k = 0; k < 1 + round % 3; ++k)
      holes.push_back({random.below(list.vertices), 0.8 + 0.1 * random.below(4)});
    OpenedMesh punched;
    if (!error_of([&] { punched = punch(whole, holes); }).empty()) continue;
    ++done;
    check_kept(whole, punched);
    CHECK(parts(punched.mesh.surface).count == 1);
    CHECK(type_of(punched.mesh.surface).genus() == 1);
    CHECK(type_of(punched.mesh.surface).boundary_curves == static_cast<int>(holes.size()));
    for (const RoundHole& hole : holes)
      CHECK(std::count(punched.number.begin(), punched.number.end(), hole.vertex) == 0);
    // One after the other comes to the same.
    OpenedMesh by_one = whole;
    for (const RoundHole& hole : holes) by_one = punch(by_one, {hole});
    CHECK(by_one.number == punched.number);
    CHECK(by_one.triangle_of == punched.triangle_of);
  }
  CHECK(done > 20);
}

TEST_CASE("Holes that cannot be are refused by name", "[punch]") {
  const OpenedMesh whole = plane();
  const auto error = [&](const OpenedMesh& mesh, const std::vector<RoundHole>& holes) {
    return error_of([&] { static_cast<void>(punch(mesh, holes)); });
  };
  CHECK_THAT(error(whole, {{500, 1.0}}), Contains("no vertex 500"));
  CHECK_THAT(error(whole, {{-1, 1.0}}), Contains("no vertex -1"));
  CHECK_THAT(error(whole, {{at(5, 5), std::nan("")}}), Contains("too small"));
  CHECK_THAT(error(whole, {{at(0, 5), 1.5}}), Contains("vertex 5 reaches the boundary"));
  CHECK_THAT(error(whole, {{at(5, 5), 7}}), Contains("vertex 60 reaches the boundary"));
  // The first takes squares up to the line j = 4, the second from there on.
  CHECK_THAT(error(whole, {{at(5, 3), 1.5}, {at(5, 5), 1.5}}), Contains("vertex 60 reaches another hole"));
  CHECK(error(whole, {{at(5, 3), 1.5}, {at(5, 6), 1.5}}).empty());
  // A second hole where the first one was.
  CHECK_THAT(error(whole, {{at(5, 5), 1.5}, {at(5, 5), 1.5}}), Contains("vertex 60 reaches another hole"));
  CHECK_THAT(error(punch(whole, {{at(5, 5), 1.5}}), {{at(5, 5), 1.5}}), Contains("no vertex 60"));
  // Within 2.5 of an outermost point lies all of the tube there, a band.
  const OpenedMesh ring = opened(support::torus_grid(24, 12));
  CHECK_THAT(error(ring, {{0, 2.5}}), Contains("vertex 0 is no disk"));
  CHECK_THAT(error(ring, {{0, 100}}), Contains("leaves nothing"));
  const auto error_of_set = [&](const std::vector<int>& triangles) {
    return error_of([&] { static_cast<void>(punch_triangles(whole, {triangles})); });
  };
  CHECK_THAT(error_of_set({88, 132}), Contains("triangle 88 is not connected"));
  CHECK_THAT(error_of_set({88, 200}), Contains("no triangle 200"));
  CHECK_THAT(error_of_set({0}), Contains("triangle 0 reaches the boundary"));
  CHECK_THAT(error_of_set({}), Contains("no triangles"));
}
