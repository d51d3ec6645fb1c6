// SPDX-License-Identifier: GPL-2.0-or-later
// The zoo has the invariants that it says, and the core agrees with them.
#include "support/zoo.hpp"

#include "support/laws.hpp"
#include "tetrarch/core/truncated.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::support;

TEST_CASE("the zoo's invariants are found again", "[zoo]") {
  for (const ZooEntry& animal : zoo()) {
    INFO(animal.name);
    const Triangulation tri = animal.triangulation();
    const Skeleton s(tri);
    CHECK(laws::all_hold(tri) == "");
    CHECK(is_valid(s));
    CHECK(s.is_connected());
    CHECK(s.vertex_count() == animal.vertices);
    CHECK(s.edge_count() == animal.edges);
    CHECK(s.is_orientable() == animal.orientable);
    CHECK(signature(tri) == animal.signature);
    CHECK(automorphisms(tri).size() == static_cast<std::size_t>(animal.automorphisms));
    int linked = 0;
    for (const auto& [count, type] : animal.links) {
      int found = 0;
      for (const VertexId v : all<VertexId>(s.vertex_count())) found += s.link(v) == type;
      CHECK(found == count);
      linked += count;
    }
    CHECK(linked == animal.vertices);
  }
}

TEST_CASE("the knotted Y is the gluing that the dissertation prints", "[zoo]") {
  const Triangulation tri = knotted_y();
  CHECK(signature(tri) == zoo("knotted Y").signature);
  // Section 4.2.3: its boundary is one surface of genus 2; figure 4.7: all edges are one.
  const TruncatedTriangulation truncated(tri);
  CHECK(truncated.boundary_component_count() == 1);
  CHECK(truncated.boundary_type(VertexId(0)).str() == "genus 2");
  CHECK(truncated.edge_count() == 1);
  CHECK(truncated.preimages(EdgeId(0)).size() == 12);
  CHECK(orientation(tri).has_value());
}

TEST_CASE("cubical balls and tori are what they are called", "[zoo]") {
  // Counts by hand: a cube adds one vertex, 3 axis edges, 3 face diagonals and 1 diagonal to the torus.
  for (const auto& size :
       {std::array{1, 1, 1}, std::array{1, 1, 2}, std::array{1, 2, 3}, std::array{3, 3, 3}}) {
    const int n = size[0] * size[1] * size[2];
    const Triangulation tri = cubical_torus(size[0], size[1], size[2]);
    const Skeleton s(tri);
    CHECK(tri.size() == 6 * n);
    CHECK(s.vertex_count() == n);
    CHECK(s.edge_count() == 7 * n);
    CHECK(is_valid(s));
    CHECK(topology_text(tri) == "valid, orientable, 1 component(s)");
  }
  // The 3-torus of one cube is Regina's six-tetrahedron 3-torus.
  CHECK(signature(cubical_torus(1, 1, 1)) == zoo("3-torus").signature);
  for (const auto& size : {std::array{1, 1, 1}, std::array{2, 1, 3}, std::array{4, 3, 5}}) {
    const auto [x, y, z] = size;
    const Triangulation tri = cubical_ball(x, y, z);
    const Skeleton s(tri);
    CHECK(s.vertex_count() == (x + 1) * (y + 1) * (z + 1));
    CHECK(s.boundary_face_count() == 4 * (x * y + y * z + z * x));
    CHECK(topology_text(tri) == "valid, orientable, 1 component(s), real sphere");
  }
}

TEST_CASE("the same seed gives the same random triangulation", "[random]") {
  RandomGluing wanted;
  wanted.tets = 12;
  Random first(7);
  Random second(7);
  const Triangulation tri = random_gluing(wanted, first);
  CHECK(tri == random_gluing(wanted, second));
  CHECK_FALSE(tri == random_gluing(wanted, second));
}
