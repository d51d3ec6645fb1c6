// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/marked_isomorphism.hpp"

#include "tetrarch/core/random.hpp"
#include "tetrarch/core/signature.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace tetrarch;

namespace {

/// The complete graph on four vertices in the 3-sphere: two tetrahedra, every face glued to one of the other.
Triangulation complete_graph() {
  Triangulation tri(2);
  for (int f = 0; f < 4; ++f) tri.glue({0, f}, 1, Perm4());
  return tri;
}

/// Digit e of the number in base `orders.size()` chooses the order of edge e of tetrahedron 0.
Marks coloring(int number, const std::vector<double>& orders) {
  Marks marks;
  const int base = static_cast<int>(orders.size());
  for (int e = 0; e < 6; ++e, number /= base)
    if (orders[number % base] != 1) marks.push_back({{0, e}, orders[number % base]});
  return marks;
}

Isomorphism random_labelling(int tets, SplitMix64& random) {
  Isomorphism iso{std::vector<int>(static_cast<std::size_t>(tets)), {}};
  for (int t = 0; t < tets; ++t) {
    const int other = random.below(t + 1);
    iso.tet[t] = t;
    std::swap(iso.tet[t], iso.tet[other]);
    iso.perm.push_back(Perm4::from_rank(random.below(Perm4::count)));
  }
  return iso;
}

Marks moved(const Marks& marks, const Isomorphism& iso) {
  Marks out;
  for (const EdgeMark& m : marks) {
    const auto [a, b] = edge_vertex[m.edge.edge];
    const Perm4 p = iso.perm[m.edge.tet];
    out.push_back({{iso.tet[m.edge.tet], edge_number[p[a]][p[b]]}, m.order});
  }
  return out;
}

} // namespace

TEST_CASE("colorings of the complete graph are counted", "[marked-isomorphism]") {
  // Graphs on four vertices: 11. With edges of two kinds, signed graphs: 66 (OEIS A000088, A004102).
  const Triangulation tri = complete_graph();
  REQUIRE(automorphisms(tri).size() == 48);
  std::set<std::string> two;
  for (int k = 0; k < 64; ++k) two.insert(marked_signature({tri, coloring(k, {1, 3})}));
  CHECK(two.size() == 11);
  CHECK(two.count(signature(tri)) == 1);
  std::set<std::string> three;
  for (int k = 0; k < 729; ++k) three.insert(marked_signature({tri, coloring(k, {1, 0, 2.5})}));
  CHECK(three.size() == 66);
}

TEST_CASE("marked signatures agree exactly where isomorphisms respect marks", "[marked-isomorphism]") {
  SplitMix64 random(2);
  for (const char* text :
       {"cPcbbbiht", "cMcabbgig", "dLQacccbcbv", "eLMkbbdddaqhqu", "gLLQPacdedffnsxanxr"}) {
    const Triangulation tri = from_signature(text);
    const Skeleton skeleton(tri);
    std::vector<Marks> all;
    for (int k = 0; k < 12; ++k) {
      EdgeOrders orders(skeleton.edge_count(), 1.0);
      for (double& order : orders) order = random.below(3) == 0 ? 0 : 1 + random.below(2);
      all.push_back(marks_of(skeleton, orders));
    }
    for (const Marks& a : all) {
      const Isomorphism iso = random_labelling(tri.size(), random);
      const Triangulation other = relabelled(tri, iso);
      const Marks there = moved(a, iso);
      CHECK(respects_marks(iso, {tri, a}, {other, there}));
      CHECK(marked_signature({tri, a}) == marked_signature({other, there}));
      CHECK(find_marked_isomorphism({tri, a}, {other, there}));
      for (const Marks& b : all) {
        const bool same = find_marked_isomorphism({tri, a}, {tri, b}).has_value();
        CHECK(same == (marked_signature({tri, a}) == marked_signature({tri, b})));
        CHECK(same == !marked_isomorphisms({tri, a}, {tri, b}).empty());
      }
    }
  }
}
