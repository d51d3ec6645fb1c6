// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/subdivide.hpp"

#include "support/enumeration.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/random.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/moves/truncate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

namespace {

/// Validity, orientability, number of components and the types of the boundary, whether real or ideal.
std::string topology_made_real(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  std::vector<std::string> types;
  for (const BoundaryComponent& b : boundary_components(tri, skeleton)) types.push_back(b.type.str());
  std::sort(types.begin(), types.end());
  std::string text = std::string(is_valid(skeleton) ? "valid, " : "invalid, ") +
                     (skeleton.is_orientable() ? "orientable, " : "non-orientable, ") +
                     std::to_string(skeleton.component_count()) + " component(s)";
  for (const std::string& type : types) text += ", " + type;
  return text;
}

/// The zoo and every so many of the valid gluings of one and two tetrahedra.
template <class Visit>
void for_each_sample(int every, Visit visit) {
  for (const ZooEntry& entry : zoo()) visit(entry.triangulation());
  int seen = 0;
  for_each_small_gluing([&](const Triangulation& tri) {
    if (seen++ % every == 0 && is_valid(Skeleton(tri))) visit(tri);
  });
}

/// Pieces that are glued lie in one tetrahedron or in two that are glued.
void check_origins(const Triangulation& tri, const Subdivision& made) {
  REQUIRE(static_cast<int>(made.origin.size()) == made.tri.size());
  REQUIRE(std::is_sorted(made.origin.begin(), made.origin.end()));
  for (int piece = 0; piece < made.tri.size(); ++piece)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = made.tri.gluing({piece, f});
      if (g.tet < 0 || made.origin[g.tet] == made.origin[piece]) continue;
      bool neighbours = false;
      for (int k = 0; k < 4; ++k) neighbours |= tri.gluing({made.origin[piece], k}).tet == made.origin[g.tet];
      REQUIRE(neighbours);
    }
}

} // namespace

TEST_CASE("a subdivision is the same manifold", "[subdivide]") {
  for_each_sample(53, [](const Triangulation& tri) {
    INFO(gluing_text(tri));
    const std::string before = topology_and_homology(tri);
    for (const Subdivision& made :
         {barycentric(tri), subdivided_1_4(tri), subdivided_1_4(tri, {tri.size() - 1})}) {
      if (const auto wrong = laws::all_hold(made.tri); !wrong.empty()) FAIL(wrong);
      if (topology_and_homology(made.tri) != before) FAIL(topology_and_homology(made.tri) + " was " + before);
      check_origins(tri, made);
    }
  });
}

TEST_CASE("a subdivision has the simplices that a count by hand gives", "[subdivide]") {
  for (const ZooEntry& entry : zoo()) {
    INFO(entry.name);
    const Triangulation tri = entry.triangulation();
    const Skeleton old(tri);
    // One vertex for each simplex; a triangle is cut into six.
    const Subdivision fine = barycentric(tri);
    const Skeleton b(fine.tri);
    CHECK(fine.tri.size() == 24 * tri.size());
    CHECK(b.vertex_count() == old.vertex_count() + old.edge_count() + old.face_count() + tri.size());
    CHECK(b.boundary_face_count() == 6 * old.boundary_face_count());
    // Edges: 2 on each edge, 6 more in each triangle, 14 more in each tetrahedron (from its centre to 4 + 6 +
    // 4 others).
    CHECK(b.edge_count() == 2 * old.edge_count() + 6 * old.face_count() + 14 * tri.size());
    // A centre and its four edges in each tetrahedron.
    const Subdivision coarse = subdivided_1_4(tri);
    const Skeleton c(coarse.tri);
    CHECK(coarse.tri.size() == 4 * tri.size());
    CHECK(c.vertex_count() == old.vertex_count() + tri.size());
    CHECK(c.edge_count() == old.edge_count() + 4 * tri.size());
    CHECK(c.boundary_face_count() == old.boundary_face_count());
  }
  // One tetrahedron: vertex k of piece p is the barycentre of p[0..k], whose degree depends on k only. Around
  // a vertex lie 6 pieces, around the midpoint of an edge 4, around the centre of a face 6, around the
  // centre 24.
  const Subdivision one = barycentric(Triangulation(1));
  const Skeleton s(one.tri);
  for (int piece = 0; piece < 24; ++piece) {
    CHECK(s.preimages(s.vertex({piece, 0})).size() == 6);
    CHECK(s.preimages(s.vertex({piece, 1})).size() == 4);
    CHECK(s.preimages(s.vertex({piece, 2})).size() == 6);
    CHECK(s.preimages(s.vertex({piece, 3})).size() == 24);
    // The vertex of the input that the piece touches is the first one of its permutation.
    for (int other = 0; other < 24; ++other)
      CHECK((s.vertex({piece, 0}) == s.vertex({other, 0})) ==
            (Perm4::from_rank(piece)[0] == Perm4::from_rank(other)[0]));
  }
}

TEST_CASE("the midpoint of a reversed edge is a projective plane's cone point", "[subdivide]") {
  // By hand: the small sphere around the midpoint, with antipodal points identified, is the projective plane.
  int reversed_seen = 0;
  for_each_gluing(1, [&](const Triangulation& tri) {
    const Skeleton old(tri);
    int reversed = 0;
    for (const EdgeId e : all<EdgeId>(old.edge_count())) reversed += old.is_reversed(e);
    reversed_seen += reversed;
    const Skeleton s(barycentric(tri).tri);
    int planes = 0;
    for (const VertexId v : all<VertexId>(s.vertex_count())) planes += s.link(v) == SurfaceType{1, 0, false};
    int planes_before = 0;
    for (const VertexId v : all<VertexId>(old.vertex_count()))
      planes_before += old.link(v) == SurfaceType{1, 0, false};
    if (reversed > 0 && planes < reversed) FAIL(gluing_text(tri));
    if (reversed == 0 && planes != planes_before) FAIL(gluing_text(tri));
    for (const EdgeId e : all<EdgeId>(s.edge_count())) REQUIRE_FALSE(s.is_reversed(e));
  });
  CHECK(reversed_seen > 20);
}

TEST_CASE("a list of tetrahedra must name each once", "[subdivide]") {
  const Triangulation tri = zoo("knotted Y").triangulation();
  CHECK(subdivided_1_4(tri, {}).tri == tri);
  CHECK(subdivided_1_4(tri, {1}).origin == std::vector<int>{0, 1, 1, 1, 1});
  CHECK_THROWS_AS(subdivided_1_4(tri, {2}), PreconditionError);
  CHECK_THROWS_AS(subdivided_1_4(tri, {0, 0}), PreconditionError);
}

TEST_CASE("a finite model is the same manifold with real boundary", "[subdivide]") {
  for_each_sample(53, [](const Triangulation& tri) {
    INFO(gluing_text(tri));
    const Subdivision made = finite_model(tri);
    if (const auto wrong = laws::all_hold(made.tri); !wrong.empty()) FAIL(wrong);
    if (topology_made_real(made.tri) != topology_made_real(tri))
      FAIL(topology_made_real(made.tri) + " was " + topology_made_real(tri));
    if (topology_text(made.tri).find("ideal") != std::string::npos) FAIL("an ideal vertex is left");
    if (homology_text(made.tri) != homology_text(tri))
      FAIL(homology_text(made.tri) + " was " + homology_text(tri));
    check_origins(tri, made);
    // Counted by hand: 12 + 4k pieces of a tetrahedron and k triangles on the new boundary; 3 + j triangles
    // on an old boundary face of which j corners are cut off.
    const Skeleton old(tri);
    int pieces = 0;
    int triangles = 0;
    for (int t = 0; t < tri.size(); ++t) {
      std::array<int, 4> cut{};
      for (int v = 0; v < 4; ++v) cut[v] = old.is_ideal(old.vertex({t, v})) ? 1 : 0;
      const int k = cut[0] + cut[1] + cut[2] + cut[3];
      pieces += 12 + 4 * k;
      triangles += k;
      for (int f = 0; f < 4; ++f)
        if (tri.is_boundary({t, f})) triangles += 3 + k - cut[f];
    }
    REQUIRE(made.tri.size() == pieces);
    REQUIRE(Skeleton(made.tri).boundary_face_count() == triangles);
  });
}

TEST_CASE("interior vertices can be cut out too", "[subdivide]") {
  // Each finite vertex leaves a sphere; S^3 without a ball is a ball.
  const Triangulation sphere = zoo("S^3, one tetrahedron").triangulation();
  CHECK(topology_and_homology(finite_model(sphere, Cut::interior_vertices).tri) ==
        "valid, orientable, 1 component(s), real sphere; H0 = Z; H1 = 0; H2 = 0; H3 = 0; ");
  CHECK(finite_model(sphere, Cut::interior_vertices).tri.size() == 28);
  CHECK(finite_model(sphere).tri.size() == 12);
  // Five vertices: S^3 without five balls.
  CHECK(homology_text(
            finite_model(zoo("S^3, boundary of a 4-simplex").triangulation(), Cut::interior_vertices).tri) ==
        "H0 = Z; H1 = 0; H2 = Z^4; H3 = 0; ");
}

TEST_CASE("a finite model comes back through truncation", "[subdivide]") {
  for (const ZooEntry& entry : zoo()) {
    const Triangulation tri = entry.triangulation();
    const Skeleton skeleton(tri);
    if (entry.links.size() != 1 || !skeleton.is_ideal(VertexId(0))) continue;
    INFO(entry.name);
    const Truncation back = truncate(finite_model(tri).tri);
    CHECK(back.finite_vertices == 0);
    CHECK(back.tri.size() <= tri.size());
    CHECK(topology_and_homology(back.tri) == topology_and_homology(tri));
  }
  // Of the Gieseking manifold there is one triangulation of one tetrahedron, of the others none smaller than
  // two.
  for (const char* name : {"Gieseking manifold m000", "knotted Y", "figure-eight complement m004"}) {
    INFO(name);
    const Triangulation tri = zoo(name).triangulation();
    CHECK(find_isomorphism(truncate(finite_model(tri).tri).tri, tri));
  }
}
