// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/product/tunnels.hpp"

#include "product/solids.hpp"
#include "src/product/branches.hpp"
#include "src/product/patches.hpp"
#include "support/solids.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/product/critical.hpp"
#include "tetrarch/product/field.hpp"
#include "tetrarch/product/product.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <set>

using namespace tetrarch;
using namespace tetrarch::product;

namespace {

std::vector<int> bases_of(const Tunnel& found) {
  const auto& [inner, ceiling, floor, inner_again] = found.levels;
  std::vector<int> base;
  base.reserve(found.values.size());
  for (const auto& [a, b, c] : found.values) {
    const double mean = (a + b + c) / 3;
    base.push_back(mean > floor && mean < inner_again ? 0 : mean > inner && mean < ceiling ? 1 : -1);
  }
  return base;
}

/// A square ring of cubes, a bar standing on it and another one hanging from it.
Solid ring_with_limbs(int length) {
  constexpr int ring = 9;
  support::Voxels cubes({ring, ring, 2 + 2 * length});
  for (int x = 0; x < ring; ++x)
    for (int y = 0; y < ring; ++y)
      for (int z = 0; z < 2 + 2 * length; ++z) {
        const bool in_hole = std::abs(x - ring / 2) <= 1 && std::abs(y - ring / 2) <= 1;
        const bool in_ring = z == length || z == length + 1;
        const bool in_limb = (x == 1 || x == 2) && (y == 1 || y == 2);
        cubes.set({x, y, z}, in_ring ? !in_hole : in_limb);
      }
  const support::TetMesh mesh = support::mesh_of(cubes);
  return product::solid_of({mesh.points, mesh.tets});
}

/// Of the greatest differences of w in tetrahedra the least.
double least_rise(const Solid& solid, const std::vector<double>& w) {
  double least = 1;
  for (const auto& v : solid.mesh.tetrahedra) {
    const auto [low, high] = std::minmax({w[v[0]], w[v[1]], w[v[2]], w[v[3]]});
    least = std::min(least, high - low);
  }
  return least;
}

/// The solid divided between the levels, and its field.
struct Tried {
  SplitSolid prepared;
  HarmonicField field;
  bool is_product() const { return critical_places(prepared.solid, prepared.partition, field.w).none(); }
};

std::optional<Tried> tried(const Solid& whole, const TunnelLoops& loops, int branches) {
  std::optional<Tunnel> found = tunnel(whole, loops, branches);
  if (!found) return {};
  Levelled at{whole, found->values, {}};
  for (const double level : found->levels) at = split_at_level(at.solid, std::move(at.values), level);
  found->values = at.values;
  std::vector<int> base = bases_of(*found);
  clean_up(at.solid, base);
  std::optional<Partition> patches;
  try {
    patches = partition(at.solid, base);
  } catch (const InputError&) {
    return {};
  }
  SplitSolid p = split_shortcuts(at.solid, *std::move(patches));
  FieldOptions clamped;
  clamped.clamped = true;
  HarmonicField field = harmonic_field(p.solid, p.partition, clamped);
  return Tried{std::move(p), std::move(field)};
}

} // namespace

TEST_CASE("The tunnel of a pipe is found, and the function between its banks", "[tunnels]") {
  // Low and wide, so that loops through the hole, which bound in the solid, are longer than loops around it;
  // and high and thin-walled, where they are shorter.
  for (const auto& from : {support::pipe(0.2, 1, 6), support::pipe(0.8, 0.2, 6)}) {
    const Solid whole = solid_of(from.mesh);
    const auto loops = tunnel_loops(whole, FirstHomology(whole));
    REQUIRE(loops);
    const auto found = tunnel(whole, *loops, 0);
    REQUIRE(found);
    REQUIRE(std::is_sorted(found->levels.begin(), found->levels.end()));
    double least = 1;
    double greatest = 0;
    for (const auto& v : found->values)
      for (const double x : v) {
        least = std::min(least, x);
        greatest = std::max(greatest, x);
      }
    CHECK(least == -1); // on the banks
    CHECK(greatest == 2);
    const auto divided = tried(whole, *loops, 0);
    REQUIRE(divided);
    CHECK(divided->is_product());
  }
}

TEST_CASE("Branches carry the field into limbs", "[tunnels]") {
  const Solid whole = ring_with_limbs(10);
  const auto loops = tunnel_loops(whole, FirstHomology(whole));
  REQUIRE(loops);
  const auto without = tried(whole, *loops, 0);
  const auto with = tried(whole, *loops, 8);
  REQUIRE((without && with));
  // In a bar of 2 x 2 that lies in one base the field falls by exp(-pi / sqrt 2) = 1/9.2 in each unit.
  CHECK(least_rise(without->prepared.solid, without->field.w) < 1e-7);
  CHECK(least_rise(with->prepared.solid, with->field.w) > 1e-4);
  CHECK(with->is_product());
}

TEST_CASE("Plates are divided around loops that are a basis and do not meet", "[tunnels]") {
  for (int holes = 1; holes <= 5; ++holes) {
    const Solid whole = solid_of(support::plate(holes, 6, 3, support::Hole::round, 0.8).mesh);
    const FirstHomology homology(whole);
    const auto loops = tunnel_loops(whole, homology);
    REQUIRE(loops);
    REQUIRE(static_cast<int>(loops->loops.size()) == holes);
    std::vector<FirstHomology::Element> elements;
    std::set<int> seen;
    std::size_t length = 0;
    for (const surface::Loop& loop : loops->loops) {
      elements.push_back(homology.of(loop));
      length += loop.size();
      for (const surface::SideEnd e : loop) seen.insert(whole.boundary.vertex(e));
    }
    CHECK(homology.generated_by(elements));
    CHECK(seen.size() == length);
    elements.pop_back();
    CHECK(homology.is_part_of_basis(elements));
    CHECK_FALSE(homology.generated_by(elements));
    elements.push_back(homology.of(loops->loops.front()));
    CHECK(homology.is_part_of_basis(elements) == (holes == 1)); // twice the first loop
    const auto found = tried(whole, *loops, 0);
    REQUIRE(found);
    CHECK(found->prepared.partition.holes() == holes);
    CHECK(found->is_product());
  }
}

TEST_CASE("Thickened graphs are products, though nobody can see how", "[tunnels]") {
  for (const int genus : {1, 2, 3}) {
    support::Random random(1);
    const support::TetMesh mesh =
        support::mesh_of(support::bars(support::random_graph({3, 3, 3}, genus, random), {5, 2}));
    const Solid whole = product::solid_of({mesh.points, mesh.tets});
    const auto loops = tunnel_loops(whole, FirstHomology(whole));
    REQUIRE(loops);
    bool is_product = false;
    for (const int branches : {4, 8, 12}) {
      const auto found = tried(whole, *loops, branches);
      if (!found) continue;
      CHECK(found->prepared.partition.holes() == genus);
      is_product = is_product || found->is_product();
    }
    CHECK(is_product);
  }
}

TEST_CASE("Trees grow from their banks, hang together and never meet", "[tunnels]") {
  // A flat ring: the inner bank is the first, the outer one the second.
  const support::PlanarMesh plan = support::planar_ring(0.3, 12, 48);
  format::Soup soup;
  for (const auto& p : plan.points) soup.points.push_back({p[0], p[1], 0});
  soup.triangles = plan.triangles;
  const surface::TriangleMesh ring = doctor::build_surface(soup);
  std::array<std::vector<int>, 2> banks;
  for (int v = 0; v < static_cast<int>(ring.points.size()); ++v) {
    const double r = std::hypot(ring.points[v][0], ring.points[v][1]);
    if (r < 0.3 + 1e-9) banks[0].push_back(v);
    if (r > 1 - 1e-9) banks[1].push_back(v);
  }
  CHECK(opposite_trees(ring, {banks}, 0)->trees == banks);
  std::size_t before = banks[0].size() + banks[1].size();
  for (const int branches : {1, 5, 20, 1000}) {
    const auto trees = opposite_trees(ring, {banks}, branches)->trees;
    CHECK(trees[0].size() + trees[1].size() >= before);
    before = trees[0].size() + trees[1].size();
    std::vector<int> owner(ring.points.size(), -1);
    for (const int k : {0, 1})
      for (const int v : trees[k]) {
        CHECK(owner[v] == -1);
        owner[v] = k;
      }
    // Each vertex is reached from its bank through its tree.
    for (const int k : {0, 1}) {
      std::vector<int> reached = banks[k];
      std::vector<char> seen(ring.points.size(), 0);
      for (const int v : reached) seen[v] = 1;
      for (std::size_t next = 0; next < reached.size(); ++next)
        for (const auto& corners : ring.surface.triangles())
          if (std::find(corners.begin(), corners.end(), reached[next]) != corners.end())
            for (const int u : corners)
              if (owner[u] == k && seen[u] == 0) {
                seen[u] = 1;
                reached.push_back(u);
              }
      CHECK(reached.size() == trees[k].size());
    }
  }
}
