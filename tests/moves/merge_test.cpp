// SPDX-License-Identifier: GPL-2.0-or-later
/// Every condition of a vertex merge: a merge that breaks it is refused by name, and what would come out if
/// it were made all the same is shown to be another space.
#include "tetrarch/moves/merge.hpp"

#include "support/enumeration.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/random.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/check.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <set>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

namespace {

/// The merge without any question: each tetrahedron at the edge goes, and what lay behind its two other faces
/// is glued together, across as many of them as lie in a row. Nothing if nothing is left.
std::optional<Triangulation> merged_blindly(const Triangulation& tri, DirectedTetEdge e) {
  const Complex complex(tri);
  std::map<int, Perm4> flat; // tetrahedron at the edge -> the exchange of the edge's ends in it
  for (const Walk& w : complex.around(e)) flat.emplace(w.tet, Perm4::swap(w.hold[0], w.hold[1]));
  std::vector<int> number(static_cast<std::size_t>(tri.size()), -1);
  int left = 0;
  for (int t = 0; t < tri.size(); ++t)
    if (flat.count(t) == 0) number[static_cast<std::size_t>(t)] = left++;
  if (left == 0) return std::nullopt;
  Triangulation out(left);
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      if (flat.count(t) != 0) continue;
      Gluing g = tri.gluing({t, f});
      while (g.tet >= 0 && flat.count(g.tet) != 0) {
        const Perm4 through = flat.at(g.tet) * g.perm;
        const Gluing next = tri.gluing({g.tet, through[f]});
        g = {next.tet, next.perm * through};
      }
      const TetFace here{number[static_cast<std::size_t>(t)], f};
      if (g.tet < 0 || !out.is_boundary(here)) continue;
      const int there = number[static_cast<std::size_t>(g.tet)];
      if (there == here.tet && g.perm[f] == f) continue; // a face folded onto itself: leave it open
      out.glue(here, there, g.perm);
    }
  return out;
}

/// Topology and homology as text; "nothing left" for no triangulation.
std::string what_is(const std::optional<Triangulation>& tri) {
  return tri ? topology_and_homology(*tri) : "nothing left";
}

struct Found {
  Triangulation tri;
  DirectedTetEdge edge;
};

/// The first merge of small gluings, and then of random larger ones, that is refused for this reason, while
/// the blind merge changes the space.
std::optional<Found> counterexample(Obstacle wanted) {
  std::optional<Found> found;
  const auto look = [&](const Triangulation& tri) {
    if (found || !is_valid(Skeleton(tri))) return;
    const Complex complex(tri);
    for (int t = 0; t < tri.size() && !found; ++t)
      for (int e = 0; e < 6 && !found; ++e) {
        const DirectedTetEdge edge{t, edge_vertex[e][0], edge_vertex[e][1]};
        if (why_not_merge(complex, edge) == wanted && what_is(merged_blindly(tri, edge)) != what_is(tri))
          found = Found{tri, edge};
      }
  };
  for_each_small_gluing(look);
  return found;
}

} // namespace

TEST_CASE("a merge that breaks a condition is refused by name, and would change the manifold", "[moves]") {
  // One counterexample a condition, found among all gluings of one and two tetrahedra.
  for (const Obstacle obstacle :
       {Obstacle::same_ends, Obstacle::both_ends_on_boundary, Obstacle::repeated_tetrahedron,
        Obstacle::edges_form_cycle, Obstacle::faces_form_cycle, Obstacle::small_boundary_component}) {
    const auto found = counterexample(obstacle);
    INFO(to_string(obstacle));
    REQUIRE(found);
    Complex complex(found->tri);
    CHECK(merge(complex, found->edge) == obstacle);
    CHECK(complex.triangulation() == found->tri);
    CHECK(what_is(merged_blindly(found->tri, found->edge)) != what_is(found->tri));
  }
}

TEST_CASE("merges by hand", "[moves]") {
  SECTION("an interior edge between two boundary vertices pinches the ball") {
    // Two tetrahedra on a common triangle, and the 2-3 move that joins their apices through the middle.
    Triangulation ball(3);
    for (int k = 0; k < 3; ++k) ball.glue({k, 2}, (k + 1) % 3, Perm4(0, 1, 3, 2));
    const Complex complex(ball); // three tetrahedra around the edge 01, with six boundary faces
    REQUIRE(complex.valence(complex.edge(DirectedTetEdge{0, 0, 1})) == 3);
    CHECK(why_not_merge(complex, {0, 0, 1}) == Obstacle::both_ends_on_boundary);
  }
  SECTION("two ideal vertices never meet") {
    const ZooEntry& whitehead = zoo("Whitehead link complement m129");
    const Complex complex(whitehead.triangulation());
    int refused = 0;
    for (int t = 0; t < 4; ++t)
      for (int e = 0; e < 6; ++e) {
        const DirectedTetEdge edge{t, edge_vertex[e][0], edge_vertex[e][1]};
        if (complex.vertex({t, edge.from}) == complex.vertex({t, edge.to})) continue;
        CHECK(why_not_merge(complex, edge) == Obstacle::both_ends_on_boundary);
        ++refused;
      }
    CHECK(refused > 0);
  }
  SECTION("a tetrahedron with nothing glued: all its edges lie on a boundary of four triangles") {
    Complex complex(from_signature("baa"));
    // Both faces beside the edge vanish, the two others would be glued, and both are free.
    CHECK(why_not_merge(complex, {0, 0, 1}) == Obstacle::faces_form_cycle);
  }
  SECTION("the boundary of the 4-simplex loses one vertex and keeps two tetrahedra") {
    // Every edge of the 4-simplex has valence 3: 5 - 3 tetrahedra, 5 - 1 vertices.
    Complex complex(zoo("S^3, boundary of a 4-simplex").triangulation());
    REQUIRE_FALSE(merge(complex, {0, 0, 1}));
    CHECK(complex.size() == 2);
    CHECK(complex.vertex_count() == 4);
    CHECK(complex.last_change().removed_tets.size() == 3);
    CHECK(complex.last_change().merged_vertices.size() == 1);
    CHECK(complex.last_change().merged_edges.size() == 3);
    CHECK(what_is(complex.triangulation()) == what_is(zoo("S^3, boundary of a 4-simplex").triangulation()));
  }
}

TEST_CASE("the four sets of a merge", "[moves]") {
  // In a 3-torus of 4*4*4 cubes everything around an edge is embedded. Vertices of a Kuhn subdivision lie in
  // 24 tetrahedra, axis and space diagonal edges in 6, face diagonals in 4. Each T_II has one neighbour
  // across the face without v2 (T_I) and one across the face without v1 (T_III); the rest of v2's star is
  // T_IV.
  const Complex complex(cubical_torus(4, 4, 4));
  for (const auto& [e, valence] : {std::pair{DirectedTetEdge{0, 0, 3}, 6},
                                   {DirectedTetEdge{0, 0, 1}, 6},
                                   {DirectedTetEdge{0, 0, 2}, 4}}) {
    REQUIRE(complex.valence(complex.edge(e)) == valence);
    const MergeSets sets = merge_sets(complex, e);
    CHECK(static_cast<int>(sets.deleted.size()) == valence);
    CHECK(static_cast<int>(sets.hosting.size()) == valence);
    CHECK(static_cast<int>(sets.deformed_at_faces.size()) == valence);
    CHECK(static_cast<int>(sets.deformed_at_vertices.size()) == 24 - 2 * valence);

    Complex after = complex;
    REQUIRE_FALSE(merge(after, e));
    // T_II is gone, T_I and T_III are glued to each other, T_III and T_IV have the vertex of T_I now.
    for (const int t : sets.deleted) CHECK_FALSE(after.is_alive(t));
    const VertexId v1 = after.current(complex.vertex({e.tet, e.to}));
    CHECK(after.current(complex.vertex({e.tet, e.from})) == v1);
    for (const int t : sets.hosting) {
      bool meets_deformed = false;
      for (int f = 0; f < 4; ++f) {
        const auto& third = sets.deformed_at_faces;
        meets_deformed =
            meets_deformed || std::count(third.begin(), third.end(), after.gluing({t, f}).tet) > 0;
      }
      CHECK(meets_deformed);
    }
  }
}

TEST_CASE("every legal merge of small gluings keeps the manifold", "[moves][slow]") {
  int merged = 0;
  for_each_small_gluing([&](const Triangulation& tri) {
    if (!is_valid(Skeleton(tri))) return;
    std::string before;
    for (int t = 0; t < tri.size(); ++t)
      for (int e = 0; e < 6; ++e) {
        Complex complex(tri);
        if (merge(complex, {t, edge_vertex[e][0], edge_vertex[e][1]})) continue;
        if (before.empty()) before = what_is(tri);
        ++merged;
        if (what_is(complex.triangulation()) != before) FAIL(gluing_text(tri));
      }
  });
  CHECK(merged > 1000);
}

TEST_CASE("a tetrahedron that meets both ends of a merge is deleted, or in none of its sets", "[moves]") {
  // In a 3-torus two cubes long an edge from a vertex to the next one has a twin the other way round; what
  // lies around the twin meets both v1 and v2 and is neither a host nor deformed.
  int twins = 0;
  for (const Triangulation& tri : {cubical_torus(2, 4, 4), cubical_torus(2, 1, 1)}) {
    const Complex complex(tri);
    for (const auto& [from, to] : edge_vertex) {
      const MergeSets sets = merge_sets(complex, {0, from, to});
      const auto has = [](const std::vector<int>& set, int t) {
        return std::count(set.begin(), set.end(), t) > 0;
      };
      for (int t = 0; t < complex.slot_count(); ++t) {
        std::set<VertexId> corners;
        for (int v = 0; v < 4; ++v) corners.insert(complex.vertex({t, v}));
        const bool both =
            corners.count(complex.vertex({0, from})) + corners.count(complex.vertex({0, to})) == 2;
        if (!both || has(sets.deleted, t)) continue;
        ++twins;
        for (const auto* set : {&sets.hosting, &sets.deformed_at_faces, &sets.deformed_at_vertices})
          REQUIRE_FALSE(has(*set, t));
      }
    }
  }
  CHECK(twins > 0);
}
