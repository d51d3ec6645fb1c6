// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/metric.hpp"

#include "samples.hpp"
#include "support/enumeration.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::hyperbolic;
using samples::Random;

namespace {

/// The largest violation of "K_v is the sum of K_e over the ends of edges at v", for angles chosen at random.
double law_violation(const Triangulation& tri, Random& random) {
  const Skeleton skeleton(tri);
  AngleTable<double> angles(static_cast<std::size_t>(tri.size()));
  for (auto& theta : angles)
    for (double& x : theta) x = samples::between(random, 0, 3);
  const auto at_edges = edge_curvature(skeleton, angles);
  auto rest = vertex_curvature(skeleton, angles);
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    if (skeleton.is_reversed(e)) return 0;
    const auto [a, b] = skeleton.ends(e);
    rest[a] -= at_edges[e];
    rest[b] -= at_edges[e];
  }
  return max_curvature(Table<EdgeId, double>(rest.values()));
}

} // namespace

TEST_CASE("vertex types are read from the links", "[metric]") {
  CHECK(vertex_type({2, 0, true}) == VertexType::finite);
  CHECK(vertex_type({1, 1, true}) == VertexType::finite);
  CHECK(vertex_type({0, 0, true}) == VertexType::ideal);
  CHECK(vertex_type({0, 0, false}) == VertexType::ideal);
  CHECK(vertex_type({-2, 0, true}) == VertexType::hyperideal);
  CHECK(vertex_type({-1, 0, false}) == VertexType::hyperideal);
  CHECK_FALSE(vertex_type({1, 0, false}));
  CHECK_FALSE(vertex_type({0, 2, true}));
  const Skeleton y(support::knotted_y());
  CHECK(types_at(y, vertex_types(y), 0) == all_hyperideal);
}

TEST_CASE("vertex curvature is the sum of the edge curvatures, on every gluing of one or two tetrahedra",
          "[metric]") {
  Random random(1);
  double worst = 0;
  support::for_each_gluing(
      1, [&](const Triangulation& tri) { worst = std::max(worst, law_violation(tri, random)); });
  int count = 0;
  support::for_each_gluing(2, [&](const Triangulation& tri) {
    if (++count % 7 == 0) worst = std::max(worst, law_violation(tri, random));
  });
  CHECK(worst < 1e-12);
}

TEST_CASE("a single tetrahedron: boundary edges and vertices", "[metric]") {
  // By hand: nothing is glued, so K_e = pi - theta and K_v = 2 pi - (sum of theta - pi).
  const Skeleton skeleton{Triangulation(1)};
  const Metric<double> metric(6, 0.7);
  const auto angles = dihedral_angles(skeleton, metric);
  const double theta = angles[0][0];
  for (const double k : edge_curvature(skeleton, angles)) CHECK(k == Approx(M_PI - theta));
  for (const double k : vertex_curvature(skeleton, angles)) CHECK(k == Approx(3 * M_PI - 3 * theta));
}

TEST_CASE("the 4-simplex boundary with regular finite tetrahedra", "[metric]") {
  // Ten edges of valence 3, five vertices that meet four tetrahedra each (by hand).
  const Triangulation tri = support::zoo("S^3, boundary of a 4-simplex").triangulation();
  const Skeleton skeleton(tri);
  const auto angles = dihedral_angles(skeleton, Metric<double>(10, 0.5));
  const double theta = angles[0][0];
  const auto k = edge_curvature(skeleton, angles);
  for (const double x : k) CHECK(x == Approx(2 * M_PI - 3 * theta));
  CHECK(total_squared_curvature(k) == Approx(10 * std::pow(2 * M_PI - 3 * theta, 2)));
  for (const double x : vertex_curvature(skeleton, angles))
    CHECK(x == Approx(4 * M_PI - 4 * (3 * theta - M_PI)));
}

TEST_CASE("a metric of the wrong size and a projective plane are the caller's mistakes", "[metric]") {
  const Skeleton y(support::knotted_y());
  CHECK_THROWS_AS(dihedral_angles(y, Metric<double>(2, 1.0)), PreconditionError);
  Triangulation found;
  support::for_each_gluing(1, [&](const Triangulation& tri) {
    const Skeleton s(tri);
    for (const VertexId v : all<VertexId>(s.vertex_count()))
      if (s.link(v).is_closed() && s.link(v).euler == 1) found = tri;
  });
  REQUIRE(found.size() == 1);
  CHECK_THROWS_AS(vertex_types(Skeleton(found)), PreconditionError);
}
