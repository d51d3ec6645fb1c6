// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/edge_weights.hpp"

#include "support/solids.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/core/tet.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

using namespace tetrarch;
using solid::TetMesh;
using solid::WeightedEdge;

namespace {

/// Cubes with random corners.
TetMesh uneven_cubes() {
  const support::TetMesh made = support::mesh_of(support::Voxels({3, 2, 2}, true));
  TetMesh mesh{made.points, made.tets};
  SplitMix64 random(3);
  for (auto& p : mesh.points)
    for (double& x : p) x += 0.3 * (random.uniform() - 0.5);
  return mesh;
}

/// The Dirichlet energy by elements: the gradient of f solves three equations in each tetrahedron.
double energy(const TetMesh& mesh, const std::vector<double>& f) {
  double sum = 0;
  for (const auto& v : mesh.tetrahedra) {
    Eigen::Matrix3d edges;
    Eigen::Vector3d rise;
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) edges(k, c) = mesh.points[v[k + 1]][c] - mesh.points[v[0]][c];
      rise[k] = f[v[k + 1]] - f[v[0]];
    }
    sum += std::abs(edges.determinant()) / 6 * (edges.inverse() * rise).squaredNorm();
  }
  return sum;
}

} // namespace

TEST_CASE("The edges of a regular tetrahedron have its opposite edge's cotangent", "[edge_weights]") {
  const TetMesh regular{{{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}};
  const auto edges = solid::edge_weights(regular);
  REQUIRE(edges.size() == 6);
  // By hand: edges of length sqrt 8, dihedral angles of cosine 1/3, so of cotangent 1 / sqrt 8.
  for (const WeightedEdge& e : edges) CHECK(e.weight == Approx(1.0 / 6));
}

TEST_CASE("Edge weights are those of the opposite edges, not of the edges themselves", "[edge_weights]") {
  // A right corner with legs 1, 1 and 2: at the leg 01 the faces are at right angles, at 23 the cotangent is
  // cot(atan(2)) = 1/2, as the distance of vertex 0 from the edge 12 is 1/sqrt 2, and so on; the opposite
  // edge of 03, of length 2, is 12, of length sqrt 2: its dihedral angle has the tangent 2 / (1/sqrt 2).
  const TetMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}}, {{0, 1, 2, 3}}};
  for (const WeightedEdge& e : solid::edge_weights(corner)) {
    if (e.from == 0 && e.to == 3) CHECK(e.weight == Approx(std::sqrt(2) / (2 * std::sqrt(2)) / 6));
    if (e.from == 1 && e.to == 2) CHECK(e.weight == Approx(0).margin(1e-15)); // 03 has a right angle
  }
}

TEST_CASE("The energy of the edges is that of the elements", "[edge_weights]") {
  const TetMesh mesh = uneven_cubes();
  const auto edges = solid::edge_weights(mesh);
  SplitMix64 random(4);
  for (int round = 0; round < 10; ++round) {
    std::vector<double> f(mesh.points.size());
    for (double& x : f) x = random.uniform();
    double by_edges = 0;
    const std::vector<double> flux = solid::fluxes(edges, f);
    for (std::size_t v = 0; v < f.size(); ++v) by_edges += f[v] * flux[v];
    CHECK(by_edges == Approx(energy(mesh, f)).epsilon(1e-12));
  }
}

TEST_CASE("Edges come once, in order, and linear functions do not flow inside", "[edge_weights]") {
  const TetMesh mesh = uneven_cubes();
  const auto edges = solid::edge_weights(mesh);
  std::map<std::pair<int, int>, int> count;
  for (const auto& v : mesh.tetrahedra)
    for (const auto& [a, b] : edge_vertex) count[std::minmax(v[a], v[b])] = 1;
  REQUIRE(edges.size() == count.size());
  for (std::size_t k = 1; k < edges.size(); ++k)
    REQUIRE(std::pair(edges[k - 1].from, edges[k - 1].to) < std::pair(edges[k].from, edges[k].to));

  // Of 3 x 2 x 2 cubes two vertices are inside: (1,1,1) and (2,1,1).
  const support::TetMesh straight = support::mesh_of(support::Voxels({3, 2, 2}, true));
  std::vector<double> f;
  for (const auto& p : mesh.points) f.push_back(2 * p[0] - 3 * p[1] + p[2]);
  const std::vector<double> flux = solid::fluxes(edges, f);
  int inside = 0;
  for (std::size_t v = 0; v < f.size(); ++v) {
    const auto& p = straight.points[v];
    if (p[0] < 0.5 || p[0] > 2.5 || p[1] < 0.5 || p[1] > 1.5 || p[2] < 0.5 || p[2] > 1.5) continue;
    ++inside;
    CHECK(flux[v] == Approx(0).margin(1e-12));
  }
  CHECK(inside == 2);
}
