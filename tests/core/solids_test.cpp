// SPDX-License-Identifier: GPL-2.0-or-later
// The solids of the generator are what they are called.
#include "support/laws.hpp"
#include "support/links.hpp"
#include "tetrarch/algebra/homology.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

std::string h1(const Triangulation& tri) {
  return algebra::homology(tri, Skeleton(tri), 1).str();
}

std::string free_abelian(int rank) {
  return algebra::AbelianGroup(rank).str();
}

/// "valid, orientable, 1 component(s), real sphere, real torus, ...": what an exterior must be.
std::string exterior_text(int components) {
  std::string text = "valid, orientable, 1 component(s), real sphere";
  for (int c = 0; c < components; ++c) text += ", real torus";
  return text;
}

std::string handlebody_text(int genus) {
  const SurfaceType surface{2 - 2 * genus, 0, true};
  return "valid, orientable, 1 component(s), real " + surface.str();
}

} // namespace

TEST_CASE("a solid is a manifold unless cubes meet in an edge or a corner only", "[solids]") {
  Voxels solid({2, 2, 2});
  solid.set({0, 0, 0}, true);
  CHECK(is_manifold(solid));
  for (const Point& other : {Point{1, 1, 0}, Point{1, 1, 1}}) {
    Voxels bad = solid;
    bad.set(other, true);
    CHECK_FALSE(is_manifold(bad));
    CHECK_FALSE(is_manifold(bad.complement()));
  }
  solid.set({0, 1, 0}, true);
  solid.set({1, 1, 0}, true);
  CHECK(is_manifold(solid));
  // Every solid in a 2*2*2 grid, by another route: gluing by faces pulls cubes apart that meet in less, so
  // there are more vertex classes than points; and a ring of cubes around a point leaves an annulus for a
  // link.
  for (unsigned bits = 1; bits < 256; ++bits) {
    Voxels some({2, 2, 2});
    for (int i = 0; i < 8; ++i) some.set({i & 1, i / 2 & 1, i / 4}, (bits >> i & 1U) != 0);
    const Skeleton s(triangulation_of(some));
    INFO(bits);
    CHECK(is_manifold(some) ==
          (is_valid(s) && s.vertex_count() == static_cast<int>(mesh_of(some).points.size())));
  }
}

TEST_CASE("a mesh of a solid glues up to its triangulation", "[solids]") {
  const Voxels solid = exterior(named_link("Hopf link").grid);
  const Triangulation tri = triangulation_of(solid);
  const TetMesh mesh = mesh_of(solid);
  REQUIRE(static_cast<int>(mesh.tets.size()) == tri.size());
  CHECK(static_cast<int>(mesh.points.size()) == Skeleton(tri).vertex_count());
  // Two tetrahedra are glued exactly if they share three points.
  std::map<std::vector<int>, std::vector<int>> sides;
  double volume = 0;
  for (int t = 0; t < tri.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    std::array<std::array<double, 3>, 3> edge{};
    for (int k = 0; k < 3; ++k) {
      edge[0][k] = mesh.points[b][k] - mesh.points[a][k];
      edge[1][k] = mesh.points[c][k] - mesh.points[a][k];
      edge[2][k] = mesh.points[d][k] - mesh.points[a][k];
    }
    double det = 0;
    for (int k = 0; k < 3; ++k)
      det += edge[0][k] *
             (edge[1][(k + 1) % 3] * edge[2][(k + 2) % 3] - edge[1][(k + 2) % 3] * edge[2][(k + 1) % 3]);
    CHECK(det == 1); // positively handed, a sixth of a cube
    volume += det / 6;
    for (int f = 0; f < 4; ++f) {
      std::vector<int> side;
      for (const int v : face_vertex[f]) side.push_back(mesh.tets[t][v]);
      std::sort(side.begin(), side.end());
      sides[side].push_back(t);
    }
  }
  CHECK(volume == Approx(solid.count()));
  int glued = 0;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const int other = tri.gluing({t, f}).tet;
      if (other < 0) continue;
      ++glued;
      int shared = 0;
      for (const int p : mesh.tets[t])
        shared += std::count(mesh.tets[other].begin(), mesh.tets[other].end(), p) > 0;
      CHECK(shared == 3);
    }
  int inner = 0;
  for (const auto& [side, tets] : sides) inner += tets.size() == 2;
  CHECK(glued == 2 * inner);
}

TEST_CASE("exteriors of links have the homology and the boundary of link exteriors", "[solids]") {
  for (const NamedLink& l : links())
    for (const Scale& scale : {Scale{2, 1}, Scale{5, 2}}) {
      if (scale.spacing > 2 && l.grid.size() > 5) continue;
      INFO(l.name);
      CHECK(component_count(l.grid) == l.components);
      const Voxels solid = exterior(l.grid, scale);
      CHECK(is_manifold(solid));
      const Triangulation tri = triangulation_of(solid);
      CHECK(topology_text(tri) == exterior_text(l.components));
      CHECK(h1(tri) == free_abelian(l.components));
    }
}

TEST_CASE("random links and handlebodies are as ordered", "[solids]") {
  Random random(1);
  for (int round = 0; round < 6; ++round) {
    const int components = 1 + round % 3;
    const GridDiagram grid = random_link(6 + round, components, random);
    CHECK(component_count(grid) == components);
    const Voxels solid = exterior(grid);
    CHECK(is_manifold(solid));
    const Triangulation tri = triangulation_of(solid);
    CHECK(topology_text(tri) == exterior_text(components));
    CHECK(h1(tri) == free_abelian(components));
  }
  for (int genus = 0; genus < 8; ++genus) {
    const Voxels solid = bars(random_graph({3, 2, 3}, genus, random), {2 + genus % 2, 1});
    CHECK(is_manifold(solid));
    const Triangulation tri = triangulation_of(solid);
    CHECK(topology_text(tri) == handlebody_text(genus));
    CHECK(h1(tri) == free_abelian(genus));
  }
  // What is left of the box around a graph, however it is embedded, has H1 = Z^genus by Alexander duality.
  const Triangulation around = triangulation_of(bars(random_graph({3, 3, 3}, 2, random), {}).complement());
  CHECK(topology_text(around) == "valid, orientable, 1 component(s), real genus 2, real sphere");
  CHECK(h1(around) == free_abelian(2));
  // The lattice of 2*1*1 points has one step.
  CHECK_THROWS_AS(random_graph({2, 1, 1}, 1, random), PreconditionError);
  CHECK_THROWS_AS(bars({{{{0, 0, 0}, {1, 1, 0}}}}, {2, 1}), PreconditionError);
  CHECK_THROWS_AS(bars({}, {2, 2}), PreconditionError);
}
