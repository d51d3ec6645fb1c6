// SPDX-License-Identifier: GPL-2.0-or-later
// Laws over all 234,674 labelled gluings of one and two tetrahedra, and the skeleton against a second route.
#include "core/naive.hpp"
#include "support/enumeration.hpp"
#include "support/laws.hpp"
#include "support/random.hpp"
#include "tetrarch/core/error.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::support;

namespace {

/// Where the classes of local simplices, with directions and senses, differ from the second route, or
/// nothing.
std::string classes_differ(const Triangulation& tri, const Skeleton& s, naive::Classes& classes) {
  naive::SamePartition edges(16 * tri.size());
  naive::SamePartition vertices(4 * tri.size());
  for (int t = 0; t < tri.size(); ++t) {
    if (classes.hand.same(2 * t, 2 * t + 1) && s.is_orientable()) return "orientability differs";
    for (int a = 0; a < 4; ++a) {
      if (!vertices.agrees(classes.vertex.find(4 * t + a), s.vertex({t, a}).value))
        return "vertex classes differ";
      for (int b = 0; b < 4; ++b) {
        if (a == b) continue;
        const EdgeId e = s.edge({t, edge_number[a][b]});
        if (classes.is_reversed(t, a, b) != s.is_reversed(e)) return "reversed edges differ";
        const int along = !s.is_reversed(e) && s.runs_along({t, a, b}) ? 1 : 0;
        if (!edges.agrees(classes.edge.find(naive::directed(t, a, b)), 2 * e.value + along))
          return "edge classes or their directions differ";
      }
    }
    for (int k = 0; k < 4 * (t + 1) * 4; ++k) {
      const TetFace f{t, k % 4};
      const TetFace g{k / 16, k / 4 % 4};
      const bool partners = !tri.is_boundary(f) && tri.partner(f) == g;
      if ((partners || f == g) != (s.face(f) == s.face(g))) return "face classes differ";
    }
  }
  return {};
}

/// Where links, defects or boundary components differ from the second route, or nothing.
std::string surfaces_differ(const Triangulation& tri, const Skeleton& s, naive::Classes& classes) {
  int defects = 0;
  for (const VertexId v : all<VertexId>(s.vertex_count())) {
    const TetVertex at = s.preimages(v).front();
    const SurfaceType link = naive::link_type(tri, classes, 4 * at.tet + at.vertex);
    if (link != s.link(v)) return "links differ";
    defects += link.boundary_curves > 0 && (link.boundary_curves > 1 || link.euler != 1);
  }
  for (const EdgeId e : all<EdgeId>(s.edge_count())) defects += s.is_reversed(e);
  if (defects != static_cast<int>(check(s).size())) return "defects differ";
  std::vector<SurfaceType> real;
  for (const BoundaryComponent& b : boundary_components(tri, s))
    if (b.kind == BoundaryComponent::Kind::real) real.push_back(b.type);
  if (real != naive::real_boundary(tri, classes)) return "real boundary components differ";
  return {};
}

std::string against_naive(const Triangulation& tri) {
  const Skeleton s(tri);
  naive::Classes classes(tri);
  const std::string difference = classes_differ(tri, s, classes);
  return difference.empty() ? surfaces_differ(tri, s, classes) : difference;
}

/// Ungluing and gluing again gives the same triangulation, and ungluing everything gives single tetrahedra.
std::string unglue_undoes_glue(const Triangulation& tri) {
  Triangulation copy = tri;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (g.tet < 0) continue;
      copy.unglue({t, f});
      if (copy == tri || !copy.is_boundary(tri.partner({t, f}))) return "unglue frees both faces";
      copy.glue({t, f}, g.tet, g.perm);
      if (!(copy == tri)) return "glue undoes unglue";
    }
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) copy.unglue({t, f});
  return copy == Triangulation(tri.size()) ? "" : "unglueing everything leaves nothing glued";
}

} // namespace

TEST_CASE("there are 145 gluings of one tetrahedron and 234,529 of two", "[enumeration]") {
  // Hand count: the sum over k of (matchings of k pairs among 4n faces) * 6^k; see enumeration.hpp.
  long one = 0;
  long two = 0;
  for_each_gluing(1, [&](const Triangulation&) { ++one; });
  for_each_gluing(2, [&](const Triangulation&) { ++two; });
  CHECK(one == one_tetrahedron_gluings);
  CHECK(two == two_tetrahedra_gluings);
}

TEST_CASE("every law holds for every gluing of one and two tetrahedra", "[laws]") {
  for_each_small_gluing([](const Triangulation& tri) {
    const std::string broken = laws::all_hold(tri);
    if (!broken.empty()) FAIL(broken);
  });
}

TEST_CASE("the skeleton agrees with union-find over directed edges for every small gluing", "[skeleton]") {
  for_each_small_gluing([](const Triangulation& tri) {
    const std::string difference = against_naive(tri);
    if (!difference.empty()) FAIL(difference << " in " << gluing_text(tri));
  });
}

TEST_CASE("unglue undoes glue for every small gluing", "[triangulation]") {
  for_each_small_gluing([](const Triangulation& tri) {
    const std::string broken = unglue_undoes_glue(tri);
    if (!broken.empty()) FAIL(broken << " in " << gluing_text(tri));
  });
}

TEST_CASE("every law holds for random gluings, and the second route agrees", "[laws]") {
  Random random(1);
  for (int k = 0; k < 600; ++k) {
    RandomGluing wanted;
    wanted.tets = 3 + random.below(12);
    wanted.boundary_faces = random.below(2) == 0 ? 0 : random.below(2 * wanted.tets + 3);
    wanted.orientable = random.below(2) == 0;
    wanted.connected = random.below(3) > 0;
    const Triangulation tri = random_gluing(wanted, random);
    INFO(gluing_text(tri));
    CHECK(laws::all_hold(tri) == "");
    CHECK(against_naive(tri) == "");
    CHECK(unglue_undoes_glue(tri) == "");
    if (wanted.orientable) CHECK(orientation(tri).has_value());
    if (wanted.connected) CHECK(components(tri).count == 1);
    const Triangulation other = relabelled(tri, random_relabelling(tri.size(), random));
    CHECK(topology_text(other) == topology_text(tri));
  }
}

TEST_CASE("laws hold and the second route agrees for 200,000 gluings of three to six tetrahedra",
          "[laws][slow]") {
  Random random(11);
  for (int k = 0; k < 200000; ++k) {
    RandomGluing wanted;
    wanted.tets = 3 + k % 4;
    wanted.boundary_faces = random.below(2) == 0 ? 0 : random.below(2 * wanted.tets + 3);
    wanted.orientable = random.below(2) == 0;
    wanted.connected = random.below(3) > 0;
    const Triangulation tri = random_gluing(wanted, random);
    const std::string broken = laws::all_hold(tri);
    const std::string difference = against_naive(tri);
    if (!broken.empty() || !difference.empty()) FAIL(broken << difference << " in " << gluing_text(tri));
  }
}

TEST_CASE("laws hold for large random gluings and cubical pieces", "[laws]") {
  Random random(2);
  RandomGluing wanted;
  wanted.tets = 3000;
  CHECK(laws::all_hold(random_gluing(wanted, random)) == "");
  wanted.boundary_faces = 500;
  wanted.orientable = true;
  CHECK(laws::all_hold(random_gluing(wanted, random)) == "");
  CHECK(laws::all_hold(cubical_ball(5, 6, 7)) == "");
  CHECK(laws::all_hold(cubical_torus(4, 5, 6)) == "");
}
