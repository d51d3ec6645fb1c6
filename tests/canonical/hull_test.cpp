// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/hull.hpp"

#include "canonical/scrambled.hpp"
#include "src/canonical/polytope.hpp"
#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/canonical/flips.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/enumeration/gluings.hpp"
#include "tetrarch/numeric/real50.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <utility>

using namespace tetrarch;
using namespace tetrarch::canonical;
using numeric::Real50;
using support::decorated;

namespace {

bool all_tetrahedra(const std::vector<HullCell>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const HullCell& cell) { return cell.corner_count == 4; });
}

/// The signature of the canonical triangulation that the hull's cells make.
std::string signature_of(const std::vector<HullCell>& cells) {
  if (!all_tetrahedra(cells)) return signature(cell_decomposition(cells).coned);
  const auto tri = subdivision(cells);
  REQUIRE(tri);
  return signature(*tri);
}

std::string hull_signature(const Decorated<double>& m) {
  auto cells = direct_hull(m);
  if (!cells) cells = direct_hull(m, patient_hull_options(1e-8));
  REQUIRE(cells);
  return signature_of(*cells);
}

std::vector<std::string> cell_names(const std::vector<HullCell>& cells) {
  std::vector<std::string> names;
  for (const Cell& cell : cell_decomposition(cells).cells) names.push_back(cell.name());
  return names;
}

const char* const mixed[] = {
    "cPcbbbihq",      "cMcabbjdw",         "dLQbcccdero",       "eLAkbccddhlfir", // geodesic boundary, cusps
    "bkaaid",         "cPcbbbiht",         "cPcbbbdxm",         "eLPkbdcddhgggb", // cusps
    "eLAkbccddemoen", "eLAkccbdddejdj", // an octahedron, two pyramids
    "eLAkbbcddbulxn", "fLLQccceddehwhwww", "fLAMcbbcdeebulhqn", "fLAMcbccdeeeejlhw", // flat ones on the way
};

} // namespace

TEST_CASE("the walls of polytopes", "[canonical]") {
  // Corners (x, y, z, 1) of a cube, an octahedron and a square pyramid.
  std::vector<Vector4<double>> cube;
  for (int k = 0; k < 8; ++k) cube.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0, 1});
  const auto faces = polytope_walls<double>(cube, 1e-8);
  REQUIRE(faces);
  REQUIRE(faces->size() == 6);
  for (const auto& face : *faces) {
    REQUIRE(face.corners.size() == 4);
    for (int k = 0; k < 4; ++k) { // neighbours differ in one coordinate
      const auto& a = cube[face.corners[k]];
      const auto& b = cube[face.corners[(k + 1) % 4]];
      CHECK((a[0] != b[0]) + (a[1] != b[1]) + (a[2] != b[2]) == 1);
    }
    for (const auto& corner : cube) CHECK(dot<double>(face.psi, corner) >= 0);
  }
  const std::vector<Vector4<double>> octahedron{{1, 0, 0, 1},  {-1, 0, 0, 1}, {0, 1, 0, 1},
                                                {0, -1, 0, 1}, {0, 0, 1, 1},  {0, 0, -1, 1}};
  CHECK(polytope_walls<double>(octahedron, 1e-8)->size() == 8);
  // No polytopes: a corner inside; all in one plane; three corners.
  auto with_center = cube;
  with_center.push_back({0, 0, 0, 1});
  CHECK_FALSE(polytope_walls<double>(with_center, 1e-8));
  CHECK_FALSE(polytope_walls<double>({cube[0], cube[1], cube[2], cube[3]}, 1e-8));
  CHECK_FALSE(polytope_walls<double>({cube[0], cube[1], cube[2]}, 1e-8));
}

TEST_CASE("the hull and the flips find the same cells", "[canonical]") {
  for (const char* name : mixed) {
    INFO(name);
    const Triangulation tri = from_signature(name);
    const Skeleton skeleton(tri);
    const auto structure = hyperbolic::hyperbolize(tri, skeleton);
    const Canonical c = canonize(tri, structure);
    REQUIRE_FALSE(c.by_hull);
    CHECK(hull_signature(decorate(tri, skeleton, structure.lengths)) == c.isometry_signature);
  }
}

TEST_CASE("the hull of a scrambled start is the same", "[canonical]") {
  SplitMix64 random(11);
  for (const char* name : mixed) {
    INFO(name);
    const Decorated<double> start = decorated(from_signature(name));
    const std::string expected = hull_signature(start);
    for (int k = 0; k < 4; ++k)
      CHECK(hull_signature(support::scrambled(start, 1 + random.below(4), random)) == expected);
  }
}

TEST_CASE("the hull is the same in 60 digits", "[canonical]") {
  for (const char* name : {"eLAkbbcddbulxn", "eLAkccbdddejdj"}) {
    const Triangulation tri = from_signature(name);
    const Skeleton skeleton(tri);
    const auto structure = hyperbolic::hyperbolize(tri, skeleton);
    const auto refined = hyperbolic::refine<Real50>(skeleton, structure);
    HullOptions options;
    options.margin = 1e-30;
    const auto cells = direct_hull(decorate(tri, skeleton, refined.lengths), options);
    REQUIRE(cells);
    CHECK(signature_of(*cells) == hull_signature(decorate(tri, skeleton, structure.lengths)));
  }
}

TEST_CASE("cells that are no tetrahedra are named and subdivided", "[canonical]") {
  // Frigerio, Martelli and Petronio 2004, section 4: an octahedron, two pyramids.
  const std::pair<const char*, std::vector<std::string>> known[] = {
      {"eLAkbccddemoen", {"octahedron"}}, {"eLAkccbdddejdj", {"square pyramid", "square pyramid"}}};
  for (const auto& [name, names] : known) {
    const auto cells = direct_hull(decorated(from_signature(name)));
    REQUIRE(cells);
    CHECK(cell_names(*cells) == names);
    const auto tri = subdivision(*cells);
    REQUIRE(tri);
    CHECK(tri->size() == 4);
    // What comes out carries the structure, and its flat faces are diagonals of these cells.
    const Skeleton skeleton(*tri);
    const auto structure = hyperbolic::hyperbolize(*tri, skeleton);
    REQUIRE(structure.outcome == hyperbolic::Outcome::geometric);
    const Canonical c = canonize(*tri, structure);
    CHECK(c.geometric_moves == 0);
    CHECK(c.isometry_signature == signature(cell_decomposition(*cells).coned));
  }
}

TEST_CASE("an oracle that sees too little is found out", "[canonical]") {
  int missed = 0;
  for (const char* name : mixed) {
    const Decorated<double> m = decorated(from_signature(name));
    const std::string expected = hull_signature(m);
    for (const int tiles : {0, 1, 2, 4, 8, 16, 32}) {
      HullOptions options;
      options.budgets = {{tiles, 4}};
      const auto cells = direct_hull(m, options);
      missed += !cells;
      if (cells) CHECK(signature_of(*cells) == expected); // never a wrong one
    }
  }
  CHECK(missed > 20);
}

TEST_CASE("where flips get stuck, the hull goes on", "[canonical]") {
  // All concave faces have a negative coordinate, and the edges there have valence 4 or more. Signatures by
  // the SnapPea kernel (Regina 7.3).
  const std::pair<const char*, const char*> stuck[] = {
      {"fLLQcbcedeetsakud", "fLLQcbcdeeetsrede"},
      {"gLLAQacdefefnsaaxjk", "gLLAQcecdfeflhccqrj"},
      {"gLLAQbddeeffhoklhkn", "gLLAQbcdeefftsreesj"},
      {"gLLMQbcefdfftsadjgw", "gLLAQcecdfeflhccqrj"},
      {"hLALPkbcbegffgxhjsaasw", "iLAwAMccbbdffghhhqnhvchhw"},
      {"hLLLQkcddffegghsvajjfk", "iLAwAMccbbdffghhhqnhvchxn"},
      {"hLLAMkcdedegfghsumuole", "iLLLMQccdgghffhhoafaqofqa"},
      {"hLLLQkcbfgffeggdrxhgdj", "hLvMQkbfdfegfgcltauaus"}};
  for (const auto& [name, expected] : stuck) {
    const Triangulation tri = from_signature(name);
    const Skeleton skeleton(tri);
    const auto structure = hyperbolic::hyperbolize(tri, skeleton);
    Decorated<double> m = decorate(tri, skeleton, structure.lengths);
    CHECK(flip_to_hull(m).end == Flips::End::stuck);
    const Canonical c = canonize(tri, structure);
    CHECK(c.by_hull);
    CHECK(c.isometry_signature == expected);
  }
}

TEST_CASE("all structures with geodesic boundary of four tetrahedra have the same cells by hull and flips",
          "[canonical][slow]") {
  // 5,033 of them, 84 with cells that are no tetrahedra, and the 8 + 151 of fewer tetrahedra once more
  // (Frigerio, Martelli and Petronio 2004).
  enumeration::GluingOptions options;
  options.tetrahedra = 4;
  options.orientability = enumeration::GluingOptions::Orientability::orientable;
  options.links = enumeration::parse_link_set("1,2,3,4");
  options.min_valence = 3;
  std::set<std::string> manifolds;
  std::set<std::string> with_flat_faces;
  enumeration::enumerate_gluings(options, [&](const Triangulation& tri) {
    const Skeleton skeleton(tri);
    bool geodesic_boundary = false;
    for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
      geodesic_boundary |= skeleton.link(v).genus() > 1;
    if (!geodesic_boundary) return;
    const auto structure = hyperbolic::hyperbolize(tri, skeleton);
    if (structure.outcome != hyperbolic::Outcome::geometric) return;
    const Canonical c = canonize(tri, structure);
    REQUIRE(c.outcome == Canonical::Outcome::canonical);
    CHECK(c.restarts == 0);
    CHECK(hull_signature(decorate(tri, skeleton, structure.lengths)) == c.isometry_signature);
    manifolds.insert(c.isometry_signature);
    if (c.has_flat_faces) with_flat_faces.insert(c.isometry_signature);
  });
  CHECK(manifolds.size() == 5033 + 8 + 151);
  CHECK(with_flat_faces.size() == 84);
}
