// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/canonical/canonize.hpp"

#include "proved.hpp"
#include "scrambled.hpp"

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/hyperbolic/search.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <utility>

using namespace tetrarch;
using namespace tetrarch::canonical;
using hyperbolic::Outcome;
using support::decorated;

namespace {

Canonical canonized(const Triangulation& tri) {
  const auto structure = hyperbolic::hyperbolize(tri, Skeleton(tri));
  REQUIRE(structure.outcome == Outcome::geometric);
  Canonical c = canonize(tri, structure);
  REQUIRE(c.outcome == Canonical::Outcome::canonical);
  return c;
}

Canonical canonized(const char* name) {
  return canonized(from_signature(name));
}

/// A few random 2-3 moves.
Triangulation grown(Triangulation tri, std::mt19937_64& random) {
  for (int made = 0; made < 3;) {
    const auto ball =
        moves::two_three_ball(tri, {static_cast<int>(random() % static_cast<unsigned>(tri.size())),
                                    static_cast<int>(random() % 4)});
    if (!std::holds_alternative<moves::Ball>(ball)) continue;
    tri = moves::replace(tri, std::get<moves::Ball>(ball)).tri;
    ++made;
  }
  return tri;
}

// By isomorphism signature: the knotted Y and another manifold of two tetrahedra, one gluing of three (with a
// cusp) and one of four whose canonical cells are eight tetrahedra.
const char* const compact[] = {"cPcbbbihq", "cMcabbjdw", "dLQbcccdero", "eLAkbccddhlfir"};

} // namespace

TEST_CASE("a face looks alike from both sides", "[canonical]") {
  for (const char* name : compact) {
    const Triangulation tri = from_signature(name);
    if (hyperbolic::hyperbolize(tri, Skeleton(tri)).outcome != Outcome::geometric) continue;
    const Decorated<double> m = decorated(tri);
    for (int t = 0; t < tri.size(); ++t) {
      for (int f = 0; f < 4; ++f) {
        const Across<double> here = look_across(m, {t, f});
        const Across<double> there = look_across(m, tri.partner({t, f}));
        CHECK((here.tilt > 0) == (there.tilt > 0));
        CHECK(here.a[f] < 0); // the tetrahedra lie on different sides
        CHECK(product_across(m, {t, f}, here) ==
              Approx(product_across(m, tri.partner({t, f}), there)).epsilon(1e-10));
      }
    }
  }
}

TEST_CASE("the isometry signature does not depend on the triangulation", "[canonical]") {
  std::mt19937_64 random(3);
  int compared = 0;
  for (const char* name : compact) {
    const Triangulation tri = from_signature(name);
    if (hyperbolic::hyperbolize(tri, Skeleton(tri)).outcome != Outcome::geometric) continue;
    const std::string expected = canonized(tri).isometry_signature;
    for (int k = 0; k < 60; ++k) {
      const Triangulation other = grown(tri, random);
      const auto structure = hyperbolic::hyperbolize(other, Skeleton(other));
      if (structure.outcome != Outcome::geometric) continue; // most random triangulations are not
      const Canonical c = canonize(other, structure);
      REQUIRE(c.outcome == Canonical::Outcome::canonical);
      CHECK(c.isometry_signature == expected);
      CHECK(c.geometric_moves > 0);
      ++compared;
    }
  }
  CHECK(compared >= 10);
}

TEST_CASE("known canonical cells and symmetries", "[canonical]") {
  // The figure-eight knot complement: two regular ideal tetrahedra, isometry group of order 8 (Thurston's
  // notes, 3.1; SnapPy's m004.symmetry_group() is D4).
  const Canonical figure_eight = canonized("cPcbbbiht");
  CHECK(figure_eight.cells == std::vector<std::string>{"tetrahedron", "tetrahedron"});
  CHECK(isometry_group(figure_eight).size() == 8);
  CHECK_FALSE(figure_eight.has_flat_faces);
  // The Gieseking manifold: one regular ideal tetrahedron, doubly covered by the former; its isometry group
  // has order 2.
  CHECK(isometry_group(canonized("bkaaid")).size() == 2);
  // The Whitehead link complement (Regina's Example3.whiteheadLink()): with cusps of equal area its cells are
  // four tetrahedra and not Thurston's octahedron; the SnapPea kernel says so too. Symmetry group D4 by
  // SnapPy.
  const Canonical whitehead = canonized("eLPkbdcddhgggb");
  CHECK(whitehead.isometry_signature == "eLPkbdcddhgggb");
  CHECK(isometry_group(whitehead).size() == 8);
}

TEST_CASE("the SnapPea kernel finds the same canonical triangulations of cusped manifolds",
          "[canonical][oracle]") {
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/snappea_canonical.txt");
  int compared = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::string name = line.substr(0, line.find('|'));
    const std::string expected = line.substr(line.rfind('|') + 1);
    const Canonical c = canonized(name.c_str());
    INFO(line);
    if (expected == "flat")
      CHECK(c.has_flat_faces);
    else
      CHECK(c.isometry_signature == expected);
    ++compared;
  }
  CHECK(compared == 124);
}

TEST_CASE("the SnapPea kernel finds the same canonical triangulations of the cusped census",
          "[canonical][oracle]") {
  // All of m, s, x and y, some of v: by name, a minimal triangulation and SnapPea's canonical one. 99 of the
  // first four once got stuck.
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/snappea_census.txt");
  int compared = 0;
  int flat = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t bar = line.find('|');
    const std::string name = line.substr(bar + 1, line.rfind('|') - bar - 1);
    const std::string expected = line.substr(line.rfind('|') + 1);
    INFO(line);
    const hyperbolic::Search found = hyperbolic::find_structure(from_signature(name));
    REQUIRE(found.structure.outcome == Outcome::geometric);
    const Canonical c = canonize(found.triangulation, found.structure);
    REQUIRE(c.outcome == Canonical::Outcome::canonical);
    CHECK(c.restarts == 0);
    CHECK(c.has_flat_faces == (expected == "flat"));
    if (!c.has_flat_faces) CHECK(c.isometry_signature == expected);
    flat += c.has_flat_faces;
    ++compared;
  }
  CHECK(compared == 2966);
  CHECK(flat == 54);
}

TEST_CASE("no canonical decomposition gets stuck at a coordinate that is zero or negative", "[canonical]") {
  // Of each of these some concave face has an edge of valence 4 or 6 where neither a 3-2 nor a 4-4 move
  // applies. The signatures are those of the SnapPea kernel (Regina 7.3, SnapPeaTriangulation.canonize). The
  // last one has geodesic boundary, which SnapPea does not do: its witness is the convex hull, built without
  // moves.
  const std::pair<const char*, const char*> stuck[] = {
      {"eLAkbbcddbulxn", "iLLwQPcbeefgehhhbbaaaahah"},      // m065
      {"fLLQccceddehwhwww", "jLLwQLQbeefgehihihhaaaaaajj"}, // m084
      {"fLAMcbbcdeebulhqn", "iLLwQPcbeefgehhhbbahhahah"},
      {"fLAMcbccdeeeejlhw", "jLLPwAQccdfehgiiilknaaaaxxa"}};
  for (const auto& [name, expected] : stuck) {
    const Canonical c = canonized(name);
    CHECK(c.isometry_signature == expected);
    CHECK(c.restarts == 0);
  }
}

TEST_CASE("cells that are no tetrahedra are found as Frigerio, Martelli and Petronio list them",
          "[canonical]") {
  // With four tetrahedra the cells are tetrahedra (up to eight), two pyramids, or one octahedron (FMP 2004,
  // section 4).
  CHECK(canonized("eLAkbccddemoen").cells == std::vector<std::string>{"octahedron"});
  CHECK(canonized("eLAkccbdddejdj").cells == std::vector<std::string>(2, "square pyramid"));
  CHECK(canonized("eLAkbccddhlfir").cells == std::vector<std::string>(8, "tetrahedron"));
}

TEST_CASE("the coned triangulation forgets how a cell was cut", "[canonical]") {
  const Canonical c = canonized("eLAkbccddemoen");
  const Triangulation& tri = c.triangulation;
  const Skeleton skeleton(tri);
  int tried = 0;
  for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
    // The octahedron's axis: an edge of valence 4 with four flat faces around it.
    const auto around = skeleton.around(e);
    if (around.size() != 4) continue;
    if (!std::all_of(around.begin(), around.end(),
                     [&](const Walk& w) { return c.flat[w.tet][w.left_face().face]; }))
      continue;
    for (const int axis : {0, 1}) {
      const Walk& w = around.front();
      const auto ball = moves::four_four_ball(tri, {w.tet, w.from(), w.to()}, axis);
      REQUIRE(std::holds_alternative<moves::Ball>(ball));
      const moves::Replaced other = moves::replace(tri, std::get<moves::Ball>(ball));
      FlatFaces flat(4, {false, false, false, false});
      for (auto& faces : flat)
        faces[2] = faces[3] = true; // the faces at the new axis, which is edge 01 of each
      const CellDecomposition again = cell_decomposition(other.tri, Skeleton(other.tri), flat);
      CHECK(again.cells.size() == 1);
      CHECK(signature(again.coned) == c.isometry_signature);
      ++tried;
    }
  }
  CHECK(tried == 2);
}

TEST_CASE("coning without flat faces makes twelve tetrahedra of each", "[canonical]") {
  const Triangulation tri = from_signature("cPcbbbihq");
  const CellDecomposition parts = cell_decomposition(tri, Skeleton(tri), FlatFaces(2));
  CHECK(parts.coned.size() == 24);
  CHECK(parts.cells.size() == 2);
  const Skeleton coned(parts.coned);
  // Vertices by hand: the old one of genus 2, two centres of cells, four centres of walls.
  CHECK(coned.vertex_count() == 7);
  int spheres = 0;
  for (const VertexId v : all<VertexId>(coned.vertex_count())) spheres += coned.link(v).is_sphere();
  CHECK(spheres == 6);
}

TEST_CASE("isometry is decided both ways, and only a no is left open where cells are not proved",
          "[canonical]") {
  using Proof = IsometryAnswer::Proof;
  using Verdict = IsometryAnswer::Verdict;
  const Canonical y = support::proved(canonized("cPcbbbihq"));
  const Canonical other = support::proved(canonized("cMcabbjdw"));
  const Canonical octahedron = canonized("eLAkbccddemoen");
  const IsometryAnswer same = compare(y, y);
  REQUIRE(same.verdict == Verdict::isometric);
  CHECK(same.proof == Proof::isomorphism);
  CHECK(relabelled(y.canonical_triangulation, same.isometry) == y.canonical_triangulation);
  CHECK(compare(y, other).verdict == Verdict::not_isometric);
  CHECK(compare(y, other).proof == Proof::cells);
  // An isomorphism of the coned triangulations is a homeomorphism, whatever is flat.
  std::mt19937_64 random(5);
  int solved = 0;
  while (solved < 5) {
    const Triangulation grown_one = grown(from_signature("eLAkbccddemoen"), random);
    if (hyperbolic::hyperbolize(grown_one, Skeleton(grown_one)).outcome != Outcome::geometric) continue;
    const Canonical again = canonized(grown_one);
    REQUIRE(again.has_flat_faces);
    const IsometryAnswer flat = compare(octahedron, again);
    REQUIRE(flat.verdict == Verdict::isometric);
    CHECK(relabelled(octahedron.canonical_triangulation, flat.isometry) == again.canonical_triangulation);
    ++solved;
  }
  // A no needs both proofs.
  CHECK(compare(y, octahedron).verdict == Verdict::undecided);
  CHECK(compare(y, octahedron).proof == Proof::none);
  CHECK(compare(y, support::proved(octahedron)).verdict == Verdict::not_isometric);
}

TEST_CASE("only a solved structure is canonised", "[canonical]") {
  const Triangulation tri = from_signature("dLQacccjcog"); // a false convergence
  CHECK_THROWS_AS(canonize(tri, hyperbolic::hyperbolize(tri, Skeleton(tri))), PreconditionError);
}
