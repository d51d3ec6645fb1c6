// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/marked.hpp"

#include "support/zoo.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/isomorphism.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

using namespace tetrarch;
using namespace tetrarch::moves;

namespace {

/// Two tetrahedra that make S^3, whose edges are the complete graph on four vertices.
Triangulation complete_graph() {
  Triangulation tri(2);
  for (int f = 0; f < 4; ++f) tri.glue({0, f}, 1, Perm4(1, 3, 0, 2));
  return tri;
}

MarkedComplex marked(const MarkedTriangulation& m) {
  const Skeleton skeleton(m.tri);
  return {m.tri, skeleton, edge_orders(skeleton, m.marks)};
}

/// The orders of the marked ends at each vertex that is no point of an edge, all sorted.
std::vector<std::vector<double>> orders_at_vertices(const MarkedTriangulation& m) {
  const Skeleton skeleton(m.tri);
  const EdgeOrders orders = edge_orders(skeleton, m.marks);
  std::vector<std::vector<double>> all(static_cast<std::size_t>(skeleton.vertex_count()));
  for (const EdgeId e : tetrarch::all<EdgeId>(skeleton.edge_count())) {
    if (orders[e] == 1) continue;
    const auto [a, b] = skeleton.ends(e);
    for (const VertexId v : {a, b}) all[static_cast<std::size_t>(v.value)].push_back(orders[e]);
  }
  for (auto& list : all) std::sort(list.begin(), list.end());
  std::erase_if(all,
                [](const auto& list) { return list.empty() || (list.size() == 2 && list[0] == list[1]); });
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace

TEST_CASE("a marked complex gives back what it was given", "[marked]") {
  const Triangulation tri = complete_graph();
  const Marks marks{{{0, 0}, 2}, {{0, 3}, 0}, {{0, 5}, 3.5}};
  const MarkedTriangulation again = marked({tri, marks}).compact();
  CHECK(find_isomorphism(again.tri, tri));
  const Skeleton skeleton(tri);
  CHECK(edge_orders(Skeleton(again.tri), again.marks) == edge_orders(skeleton, marks));
  CHECK_THROWS_AS(MarkedComplex(tri, skeleton, EdgeOrders(1, 1.0)), PreconditionError);
}

TEST_CASE("no random move loses a mark", "[marked]") {
  const MarkedTriangulation start{
      complete_graph(), {{{0, 0}, 2}, {{0, 1}, 3}, {{0, 2}, 4}, {{0, 3}, 5}, {{0, 4}, 6}, {{0, 5}, 0}}};
  const auto before = orders_at_vertices(start);
  REQUIRE(before.size() == 4);
  SplitMix64 random(7);
  MarkedComplex complex = marked(start);
  for (int round = 0; round < 60; ++round) {
    shake(complex, 6, random);
    const MarkedTriangulation shaken = complex.compact();
    CHECK(orders_at_vertices(shaken) == before);
    reduce(complex);
    const MarkedTriangulation reduced = complex.compact();
    CHECK(orders_at_vertices(reduced) == before);
    CHECK(algebra::homology(reduced.tri, Skeleton(reduced.tri), 1) == algebra::AbelianGroup{});
    CHECK(reduced.tri.size() <= shaken.tri.size());
  }
}

TEST_CASE("an unmarked complex is made as small as an unmarked one", "[marked]") {
  // The boundary of a 4-simplex has five vertices; four of them can be merged away.
  const Triangulation tri = support::zoo("S^3, boundary of a 4-simplex").triangulation();
  MarkedComplex complex = marked({tri, {}});
  reduce(complex);
  CHECK(complex.size() < 5);
  CHECK(complex.compact().marks.empty());
}

TEST_CASE("a vertex on a marked edge is merged away along it, and no other", "[marked]") {
  // A path of two edges of order 3 and one of order 4 behind it, in the boundary of a 4-simplex: the middle
  // of the first two is a point of the edge, the next one is not.
  const Triangulation tri = support::zoo("S^3, boundary of a 4-simplex").triangulation();
  const Skeleton skeleton(tri);
  const auto edge_between = [&](int a, int b) {
    for (const EdgeId e : all<EdgeId>(skeleton.edge_count())) {
      const auto [p, q] = skeleton.ends(e);
      if ((p.value == a && q.value == b) || (p.value == b && q.value == a)) return e;
    }
    throw std::logic_error("no such edge");
  };
  EdgeOrders orders(skeleton.edge_count(), 1.0);
  orders[edge_between(0, 1)] = 3;
  orders[edge_between(1, 2)] = 3;
  orders[edge_between(2, 3)] = 4;
  const auto merge_of = [&](int from, int to) {
    const Walk w = skeleton.around(edge_between(from, to)).front();
    const bool along = skeleton.vertex({w.tet, w.from()}).value == from;
    return Move{MoveKind::merge, w.tet, along ? w.from() : w.to(), along ? w.to() : w.from()};
  };
  CHECK(MarkedComplex(tri, skeleton, orders).apply(merge_of(1, 0)));
  CHECK_FALSE(MarkedComplex(tri, skeleton, orders).apply(merge_of(2, 3)));
  CHECK_FALSE(MarkedComplex(tri, skeleton, orders).apply(merge_of(0, 2))); // two marked points, unmarked edge
  CHECK(MarkedComplex(tri, skeleton, orders).apply(merge_of(4, 0)));
}
