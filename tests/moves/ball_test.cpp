// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/ball.hpp"

#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>

using namespace tetrarch;
using namespace tetrarch::moves;

namespace {

/// What no Pachner move may change: connectedness, orientability, validity, Euler characteristic of the
/// pseudo-manifold, and the types of the boundary components.
std::string invariants(const Triangulation& tri) {
  const Skeleton s(tri);
  std::vector<std::string> boundary;
  for (const BoundaryComponent& b : boundary_components(tri, s))
    boundary.push_back((b.kind == BoundaryComponent::Kind::real ? "real " : "ideal ") + b.type.str());
  std::sort(boundary.begin(), boundary.end());
  std::string text = std::to_string(s.component_count()) +
                     (s.is_orientable() ? " orientable" : " nonorientable") +
                     (is_valid(s) ? " valid" : " invalid") + " euler " +
                     std::to_string(s.vertex_count() - s.edge_count() + s.face_count() - tri.size());
  for (const std::string& b : boundary) text += ", " + b;
  return text;
}

/// Closed and bounded, orientable and not, one to five tetrahedra; from Regina's census (tricensus).
const char* const signatures[] = {"bkaagb",    "cMcabbgqs",   "cMcabbjdw",   "cPcbbbihq",
                                  "cPcbbbiht", "dLQacccjcog", "dLQbcccdero", "baa"};

} // namespace

TEST_CASE("a 2-3 move and the 3-2 move on its new edge restore the signature", "[moves]") {
  int moved = 0;
  for (const char* name : signatures) {
    const Triangulation tri = from_signature(name);
    for (int t = 0; t < tri.size(); ++t) {
      for (int f = 0; f < 4; ++f) {
        const BallOrObstacle ball = two_three_ball(tri, {t, f});
        if (!std::holds_alternative<Ball>(ball)) continue;
        const Replaced up = replace(tri, std::get<Ball>(ball));
        REQUIRE(up.tri.size() == tri.size() + 1);
        CHECK(invariants(up.tri) == invariants(tri));
        // The new edge joins corners 3 and 4 of the first new tetrahedron, its vertices 2 and 3.
        const BallOrObstacle back = three_two_ball(up.tri, {up.first_new, 2, 3});
        REQUIRE(std::holds_alternative<Ball>(back));
        CHECK(signature(replace(up.tri, std::get<Ball>(back)).tri) == signature(tri));
        ++moved;
      }
    }
  }
  CHECK(moved > 20);
}

TEST_CASE("random moves keep the manifold, and a 4-4 move can be undone", "[moves]") {
  std::mt19937_64 random(7);
  int four_fours = 0;
  for (const char* name : {"cPcbbbihq", "cMcabbjdw", "dLQacccjcog"}) {
    Triangulation tri = from_signature(name);
    const std::string before = invariants(tri);
    for (int step = 0; step < 200; ++step) {
      const int t = static_cast<int>(random() % static_cast<unsigned>(tri.size()));
      const int i = static_cast<int>(random() % 4);
      const int j = (i + 1 + static_cast<int>(random() % 3)) % 4;
      BallOrObstacle ball = tri.size() < 8 ? two_three_ball(tri, {t, i}) : three_two_ball(tri, {t, i, j});
      if (step % 2 == 1) ball = four_four_ball(tri, {t, i, j}, step / 2 % 2);
      if (!std::holds_alternative<Ball>(ball)) continue;
      const Replaced next = replace(tri, std::get<Ball>(ball));
      REQUIRE(invariants(next.tri) == before);
      if (step % 2 == 1) {
        // The new axis is the edge 01 of each new tetrahedron; one of its two 4-4 moves leads back.
        bool restored = false;
        for (const int axis : {0, 1}) {
          const BallOrObstacle back = four_four_ball(next.tri, {next.first_new, 0, 1}, axis);
          REQUIRE(std::holds_alternative<Ball>(back));
          restored |= signature(replace(next.tri, std::get<Ball>(back)).tri) == signature(tri);
        }
        CHECK(restored);
        ++four_fours;
      }
      tri = next.tri;
    }
  }
  CHECK(four_fours > 10);
}

TEST_CASE("a move that cannot be made names its obstacle", "[moves]") {
  const Triangulation one = from_signature("baa"); // one tetrahedron, nothing glued
  CHECK(std::get<Obstacle>(two_three_ball(from_signature("bkaagb"), {0, 0})) ==
        Obstacle::repeated_tetrahedron);
  int boundary = 0;
  for (int f = 0; f < 4; ++f) {
    const BallOrObstacle ball = two_three_ball(one, {0, f});
    REQUIRE(std::holds_alternative<Obstacle>(ball));
    boundary += std::get<Obstacle>(ball) == Obstacle::boundary_face;
  }
  CHECK(boundary == 4);
  // The knotted Y has one edge class, of valence 12.
  CHECK(std::get<Obstacle>(three_two_ball(from_signature("cPcbbbihq"), {0, 0, 1})) ==
        Obstacle::wrong_valence);
  CHECK(std::string(to_string(Obstacle::wrong_valence)) == "another number of tetrahedra meets there");
}

TEST_CASE("a filling with another boundary is refused", "[moves]") {
  const Triangulation tri = from_signature("cPcbbbihq");
  Ball ball = std::get<Ball>(two_three_ball(tri, {0, 0}));
  ball.after[2] = {2, 1, 3, 4};
  CHECK_THROWS_AS(replace(tri, ball), PreconditionError);
}
