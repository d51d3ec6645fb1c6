// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/complex.hpp"

#include "support/audit.hpp"
#include "support/enumeration.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/random.hpp"
#include "support/zoo.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/log.hpp"
#include "tetrarch/moves/merge.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <tuple>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

namespace {

Move random_move(const Complex& complex, Random& random) {
  int t = random.below(complex.slot_count());
  while (!complex.is_alive(t)) t = (t + 1) % complex.slot_count();
  // Everything but `cone`, which changes the boundary, and `pack`.
  const auto kind = static_cast<MoveKind>(random.below(static_cast<int>(MoveKind::cone)));
  const auto [a, b] = edge_vertex[random.below(6)];
  Move move{kind, t, a, b, random.below(2)};
  if (random.below(2) == 0) std::swap(move.a, move.b);
  if (kind == MoveKind::zero_two_edge) move.n = 1 + random.below(4);
  return move;
}

} // namespace

TEST_CASE("a Complex knows the classes that a Skeleton finds", "[moves]") {
  int seen = 0;
  for_each_small_gluing([&](const Triangulation& tri) {
    if (seen++ % 20 != 0) return; // all of them: the slow test
    if (const auto wrong = disagreement(Complex(tri)); !wrong.empty()) FAIL(wrong + ": " + gluing_text(tri));
  });
  for (const ZooEntry& entry : zoo()) CHECK(disagreement(Complex(entry.triangulation())) == "");
  CHECK(disagreement(Complex(cubical_torus(3, 4, 5))) == "");
  CHECK(disagreement(Complex(cubical_ball(3, 4, 5))) == "");
  CHECK(seen == 234'674); // the number of gluings of one and two tetrahedra
}

TEST_CASE("a Complex knows the classes of every gluing of one and two tetrahedra", "[moves][slow]") {
  for_each_small_gluing([&](const Triangulation& tri) {
    if (const auto wrong = disagreement(Complex(tri)); !wrong.empty()) FAIL(wrong + ": " + gluing_text(tri));
  });
}

TEST_CASE("random walks of all moves keep the manifold, and the classes true", "[moves]") {
  Random random(20261122);
  std::map<MoveKind, int> made;
  std::vector<Triangulation> starts;
  for (const ZooEntry& entry : zoo()) starts.push_back(entry.triangulation());
  starts.push_back(cubical_ball(1, 1, 2));
  for (int k = 0; k < 40; ++k) starts.push_back(random_gluing({3, k % 5, k % 3 == 0}, random));
  for (const Triangulation& start : starts) {
    Complex complex(start);
    const std::string before = topology_and_homology(start);
    for (int k = 0; k < 800; ++k) {
      const Move move = random_move(complex, random);
      const bool grows = move.kind == MoveKind::one_four || move.kind == MoveKind::zero_two_face ||
                         move.kind == MoveKind::zero_two_edge || move.kind == MoveKind::two_three;
      if (grows && complex.size() > 12) continue;
      const Complex old = complex;
      const MaybeObstacle asked = why_not_apply(complex, move);
      const MaybeObstacle told = apply(complex, move);
      INFO(gluing_text(old.triangulation()) << move.str());
      REQUIRE(asked == told);
      if (told) {
        REQUIRE(complex.triangulation() == old.triangulation());
        continue;
      }
      ++made[move.kind];
      REQUIRE(disagreement(complex) == "");
      if (k % 3 == 0) REQUIRE(topology_and_homology(complex.triangulation()) == before);
    }
    REQUIRE(topology_and_homology(complex.triangulation()) == before);
    complex.pack();
    CHECK(disagreement(complex) == "");
    CHECK(complex.slot_count() == complex.size());
  }
  for (int kind = 0; kind < static_cast<int>(MoveKind::cone); ++kind) {
    INFO(Move{static_cast<MoveKind>(kind)}.str());
    CHECK(made[static_cast<MoveKind>(kind)] >= 10);
  }
}

TEST_CASE("packing renames every id as it says", "[moves]") {
  Random random(7);
  Complex complex(cubical_torus(2, 2, 2));
  for (int k = 0; k < 300; ++k)
    if (const Move move = random_move(complex, random); !apply(complex, move)) continue;
  const Complex old = complex;
  const Complex::Renaming names = complex.pack();
  for (int t = 0; t < old.slot_count(); ++t) {
    REQUIRE((names.tet[static_cast<std::size_t>(t)] >= 0) == old.is_alive(t));
    if (!old.is_alive(t)) continue;
    const int now = names.tet[static_cast<std::size_t>(t)];
    for (int v = 0; v < 4; ++v) REQUIRE(names.vertex[old.vertex({t, v})] == complex.vertex({now, v}));
    for (int e = 0; e < 6; ++e) REQUIRE(names.edge[old.edge(TetEdge{t, e})] == complex.edge(TetEdge{now, e}));
  }
}

TEST_CASE("a change tells how classes were renamed", "[moves]") {
  // Follow every class of edges and vertices by hand, from the lists alone.
  Random random(99);
  Complex complex(cubical_ball(2, 1, 1));
  for (int k = 0; k < 2000; ++k) {
    const Complex old = complex;
    const Move move = random_move(complex, random);
    if (complex.size() > 30 && move.kind != MoveKind::merge && move.kind != MoveKind::three_two) continue;
    if (apply(complex, move)) continue;
    const Change& change = complex.last_change();
    REQUIRE(complex.size() - old.size() ==
            static_cast<int>(change.new_tets.size()) - static_cast<int>(change.removed_tets.size()));
    REQUIRE(complex.vertex_count() - old.vertex_count() ==
            static_cast<int>(change.new_vertices.size()) - static_cast<int>(change.merged_vertices.size()) -
                static_cast<int>(change.removed_vertices.size()));
    REQUIRE(complex.edge_count() - old.edge_count() == static_cast<int>(change.new_edges.size()) -
                                                           static_cast<int>(change.merged_edges.size()) -
                                                           static_cast<int>(change.removed_edges.size()));
    std::map<EdgeId, EdgeId> renamed;
    for (const auto& [gone, kept] : change.merged_edges) renamed[gone] = kept;
    for (int t = 0; t < old.slot_count(); ++t) {
      const bool removed = std::count(change.removed_tets.begin(), change.removed_tets.end(), t) > 0;
      if (!old.is_alive(t) || removed) continue;
      for (int e = 0; e < 6; ++e) {
        EdgeId id = old.edge(TetEdge{t, e});
        while (renamed.count(id) != 0) id = renamed[id];
        const EdgeId now = complex.edge(TetEdge{t, e});
        const bool split = std::any_of(change.split_edges.begin(), change.split_edges.end(),
                                       [&](const auto& s) { return s.first == id && s.second == now; });
        REQUIRE((id == now || split));
      }
    }
  }
}

TEST_CASE("glue refuses what is no free pair of faces", "[moves]") {
  Complex complex(zoo("knotted Y").triangulation());
  CHECK_THROWS_AS(complex.glue({0, 0}, 1, Perm4()), PreconditionError);
  CHECK_THROWS_AS(complex.merge_vertices(VertexId(0), VertexId(0), LinkKind::sphere), PreconditionError);
  CHECK_THROWS_AS(apply(complex, Move{MoveKind::shell, 2}), PreconditionError);
  CHECK_THROWS_AS(apply(complex, Move{MoveKind::merge, 0, 1, 1}), PreconditionError);
}

TEST_CASE("a change lists every survivor that is glued otherwise than before", "[moves]") {
  SplitMix64 random(17);
  Random gluings(17);
  std::vector<Triangulation> starts{cubical_ball(2, 1, 1), cubical_torus(2, 2, 2)};
  for (int k = 0; k < 40; ++k) starts.push_back(random_gluing({3, k % 5, k % 3 == 0}, gluings));
  for (const Triangulation& start : starts) {
    Complex complex(start);
    for (int k = 0; k < 1000 && complex.size() > 0; ++k) {
      const Complex old = complex;
      Move move{static_cast<MoveKind>(random.below(static_cast<int>(MoveKind::cone))),
                random.below(complex.slot_count())};
      std::tie(move.a, move.b) = std::pair{edge_vertex[random.below(6)][0], edge_vertex[random.below(6)][1]};
      move.n = random.below(2);
      if (move.a == move.b || !complex.is_alive(move.tet)) continue;
      if (complex.size() > 30 && move.kind != MoveKind::merge && move.kind != MoveKind::three_two) continue;
      if (apply(complex, move)) continue;
      const Change& change = complex.last_change();
      const auto lists = [](const std::vector<int>& tets, int t) {
        return std::find(tets.begin(), tets.end(), t) != tets.end();
      };
      for (int t = 0; t < old.slot_count(); ++t) {
        if (!old.is_alive(t) || lists(change.removed_tets, t)) continue;
        bool same = true;
        for (int f = 0; f < 4; ++f)
          same = same && old.gluing({t, f}) == complex.gluing({t, f}) &&
                 !lists(change.new_tets, old.gluing({t, f}).tet);
        INFO(move.str() << ", tetrahedron " << t);
        REQUIRE((same || lists(change.touched_tets, t)));
      }
    }
  }
}

TEST_CASE("every move of small gluings keeps the classes true, manifold or not", "[moves]") {
  // Also around reversed edges and at links that are no surfaces of a manifold.
  int seen = 0;
  int made = 0;
  for_each_small_gluing([&](const Triangulation& tri) {
    if (seen++ % 7 != 0) return;
    const Complex start(tri);
    for (const MoveKind kind : {MoveKind::merge, MoveKind::two_one, MoveKind::two_zero_edge,
                                MoveKind::two_zero_vertex, MoveKind::four_one, MoveKind::close_book})
      for (int t = 0; t < tri.size(); ++t)
        for (int a = 0; a < 4; ++a)
          for (int b = 0; b < 4; ++b) {
            if (a == b) continue;
            Complex complex = start;
            const Move move{kind, t, a, b};
            if (apply(complex, move)) continue;
            ++made;
            if (const auto wrong = disagreement(complex); !wrong.empty())
              FAIL(move.str() + ": " + wrong + ": " + gluing_text(tri));
          }
  });
  CHECK(made > 1000);
}

TEST_CASE("what is gone has no name, and a dead tetrahedron moves no more", "[moves]") {
  Complex complex(zoo("S^3, boundary of a 4-simplex").triangulation());
  REQUIRE_FALSE(merge(complex, {0, 0, 1}));
  CHECK_THROWS_AS(apply(complex, {MoveKind::two_three, complex.last_change().removed_tets.front(), 0}),
                  PreconditionError);
  // 1-4 makes a vertex, 4-1 takes it away again.
  int alive = 0;
  while (!complex.is_alive(alive)) ++alive;
  REQUIRE_FALSE(apply(complex, {MoveKind::one_four, alive}));
  const VertexId centre = complex.last_change().new_vertices.front();
  const int piece = complex.last_change().new_tets.front();
  CHECK(complex.all_vertices()[centre] == centre);
  int corner = 0;
  while (complex.vertex({piece, corner}) != centre) ++corner;
  REQUIRE_FALSE(apply(complex, {MoveKind::four_one, piece, corner}));
  CHECK(complex.all_vertices()[centre] == VertexId());
  complex.pack();
  CHECK(complex.last_change().new_tets.empty());
}
