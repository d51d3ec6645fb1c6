// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/split_edges.hpp"

#include "support/solids.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/core/tet.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;
using solid::EdgePoint;
using solid::TetMesh;

namespace {

double volume(const TetMesh& mesh, std::size_t t) {
  const auto& v = mesh.tetrahedra[t];
  std::array<std::array<double, 3>, 3> d{};
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) d[k][c] = mesh.points[v[k + 1]][c] - mesh.points[v[0]][c];
  return (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
          d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
          d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
         6;
}

std::set<std::array<int, 2>> edges_of(const TetMesh& mesh) {
  std::set<std::array<int, 2>> edges;
  for (const auto& v : mesh.tetrahedra)
    for (const auto& [a, b] : edge_vertex) edges.insert({std::min(v[a], v[b]), std::max(v[a], v[b])});
  return edges;
}

TetMesh frame() {
  support::Voxels voxels({3, 3, 1}, true);
  voxels.set({1, 1, 0}, false);
  const support::TetMesh made = support::mesh_of(voxels);
  return {made.points, made.tets};
}

} // namespace

TEST_CASE("One tetrahedron split at one edge is halved, its faces remembered", "[split_edges]") {
  const TetMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  const solid::SplitTets split = solid::split_edges(one, {{0, 1, 0.25}});
  REQUIRE(split.mesh.points.back() == std::array<double, 3>{0.25, 0, 0});
  REQUIRE(split.mesh.tetrahedra == std::vector<std::array<int, 4>>{{4, 1, 2, 3}, {0, 4, 2, 3}});
  REQUIRE(split.face_of == std::vector<int>{0, -1, 2, 3, -1, 1, 2, 3});
}

TEST_CASE("Random edges split leave a manifold of the same shape", "[split_edges]") {
  const TetMesh solid = frame();
  const auto edges = edges_of(solid);
  SplitMix64 random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<EdgePoint> splits;
    for (const auto& [a, b] : edges)
      if (random.below(20) < round) splits.push_back({a, b, 0.1 + 0.8 * random.uniform()});
    const solid::SplitTets split = solid::split_edges(solid, splits);

    // Law: pieces fill what they are pieces of, all handed alike.
    std::vector<double> filled(solid.tetrahedra.size(), 0.0);
    for (std::size_t t = 0; t < split.origin.size(); ++t) {
      REQUIRE(volume(split.mesh, t) > 0);
      filled[split.origin[t]] += volume(split.mesh, t);
    }
    for (std::size_t t = 0; t < filled.size(); ++t) REQUIRE(filled[t] == Approx(volume(solid, t)));

    // Law: a solid torus stays one (its boundary is a torus, by hand), and no face is torn: as many boundary
    // faces as pieces of boundary faces.
    const Triangulation before = solid::triangulation_of(solid);
    const Triangulation after = solid::triangulation_of(split.mesh);
    const auto boundary = boundary_components(after, Skeleton(after));
    REQUIRE(boundary.size() == 1);
    REQUIRE(boundary[0].type.str() == "torus");
    for (int t = 0; t < after.size(); ++t)
      for (int f = 0; f < 4; ++f) {
        const int face = split.face_of[4 * t + f];
        REQUIRE(after.is_boundary({t, f}) == (face >= 0 && before.is_boundary({split.origin[t], face})));
      }
  }
}

TEST_CASE("Split where it changes its sign, a function has one sign in each tetrahedron", "[split_edges]") {
  const TetMesh solid = frame();
  SplitMix64 random(7);
  std::vector<double> f(solid.points.size());
  for (double& value : f) value = random.uniform() - 0.5;
  std::vector<EdgePoint> splits;
  for (const auto& [a, b] : edges_of(solid))
    if (f[a] * f[b] < 0) splits.push_back({a, b, f[a] / (f[a] - f[b])});
  f.resize(f.size() + splits.size(), 0.0);
  for (const auto& v : solid::split_edges(solid, splits).mesh.tetrahedra)
    for (const auto& [a, b] : edge_vertex) REQUIRE(f[v[a]] * f[v[b]] >= 0);
}

TEST_CASE("Edges that are none are refused", "[split_edges]") {
  const TetMesh solid = frame();
  REQUIRE_THROWS_AS(solid::split_edges(solid, {{0, 1}, {1, 0}}), PreconditionError);
  REQUIRE_THROWS_AS(solid::split_edges(solid, {{3, 3}}), PreconditionError);
  const int last = static_cast<int>(solid.points.size()) - 1;
  REQUIRE_THROWS_AS(solid::split_edges(solid, {{0, last}}), PreconditionError);
  REQUIRE_THROWS_AS(solid::split_edges(solid, {{0, last + 1}}), PreconditionError);
}
