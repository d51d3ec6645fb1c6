// SPDX-License-Identifier: GPL-2.0-or-later
/// Circle bundles over every kind of surface: proved from their gluings, and of the homology that they must
/// have.
#include "bundle/bundles.hpp"
#include "support/homology.hpp"
#include "tetrarch/bundle/section.hpp"
#include "tetrarch/bundle/vector_field.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <set>

using namespace tetrarch;
using namespace tetrarch::bundle;
using namespace tetrarch::support;

namespace {

/// The bundle on a cut graph that is as long as can be: the edges that a spanning tree of the triangles does
/// not cross. So the covering disk has no vertex inside.
struct Case {
  std::string name;
  surface::Surface surface;
  std::vector<int> eulers;
};

std::vector<Case> cases() {
  return {{"sphere", tetrahedron_surface().surface(), {-3, -1, 0, 1, 2, 5}},
          {"cube", cube_surface().surface(), {2, 1}},
          {"torus", torus_grid(3, 3).surface(), {-3, -1, 0, 1, 2}},
          {"torus of one vertex", glued_polygon(canonical_word(1)), {0, 1, 4}},
          {"genus 2", genus_surface(2).surface(), {-2, 0, 3}},
          {"genus 3 of one vertex", glued_polygon(canonical_word(3)), {-4, 2}},
          {"projective plane", projective_plane().surface(), {-2, 0, 1, 3}},
          {"Klein bottle", klein_grid(4, 4).surface(), {-1, 0, 2}},
          {"three crosscaps of one vertex", glued_polygon({1, 1, 2, 2, 3, 3}), {-1, 0, 2}},
          {"four crosscaps", crosscaps(4).surface(), {-2, 1}}};
}

} // namespace

TEST_CASE("Circle bundles of every Euler number on any cut graph are proved and have their homology",
          "[bundle]") {
  for (const Case& c : cases())
    for (const int e : c.eulers)
      for (const int fiber : {1, 2, 3}) {
        INFO(c.name << ", e = " << e << ", N = " << fiber);
        const CircleBundle bundle = bundle_on_tree_cut(c.surface, e, fiber);
        CHECK(bundle.total.size() == 3 * fiber * bundle.base.triangle_count());
        const Proof proof = prove(bundle, Skeleton(bundle.total));
        REQUIRE(proof.failure.empty());
        CHECK(proof.euler_number == e);
        CHECK(first_homology(bundle.total) == expected_homology(surface::type_of(c.surface), e));
      }
}

TEST_CASE("One vertex, and 6, 18 and 30 tetrahedra, are enough for genus 1, 2 and 3", "[bundle]") {
  // A 4g-gon has 4g - 2 triangles, and over each stands one prism if fibres have one edge.
  for (const int genus : {1, 2, 3}) {
    const CircleBundle bundle = bundle_on_tree_cut(glued_polygon(canonical_word(genus)), 2 - 2 * genus, 1);
    CHECK(bundle.total.size() == 12 * genus - 6);
    CHECK(Skeleton(bundle.total).vertex_count() == 1);
  }
}

TEST_CASE("Small bundles are the manifolds that Regina recognises", "[bundle]") {
  // tests/oracle/record_bundles.py asked Regina to recognise these signatures.
  std::map<std::string, std::string> recorded;
  std::ifstream file(TETRARCH_SOURCE_DIR "/tests/oracle/regina_bundles.txt");
  for (std::string line; std::getline(file, line);)
    if (const auto tab = line.find('\t'); tab != std::string::npos)
      recorded[line.substr(0, tab)] = line.substr(tab + 1);
  // Unit tangent bundles and others as the literature names them: RP^3 = L(2,1), the 3-torus, and Seifert
  // fibred spaces without exceptional fibres but one of type (1, e), up to the orientation.
  for (const SmallBundle& b : small_bundles()) {
    INFO(b.name);
    const std::string sig = signature(bundle_on_tree_cut(b.surface, b.euler, 1).total);
    REQUIRE(recorded.contains(sig));
    CHECK(recorded[sig].starts_with(b.name + "\t"));
  }
}

TEST_CASE("Where the twist is no multiple of the fibre, an exceptional fibre is found", "[bundle]") {
  // Twist 1 over the torus with fibres of three edges: a closed manifold still, of the same homology as e
  // = 1.
  surface::MarkedSurface cut(torus_grid(3, 3).surface());
  mark_tree_cut(cut);
  const std::vector<int> twist = spread_twist(cut, 1);
  const CircleBundle bundle =
      assemble({cut.surface, 3, shifts_of(cut, twist, 0), values_of(cut, twist).value});
  const Skeleton skeleton(bundle.total);
  CHECK(is_valid(skeleton));
  CHECK(!skeleton.has_boundary_faces());
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) CHECK(skeleton.link(v).is_sphere());
  CHECK(first_homology(bundle.total) == "Z^2");
  CHECK(prove(bundle, skeleton).failure == "the fiber over vertex 0 has length 1, expected 3");
}

TEST_CASE("A bundle with two gluings exchanged is not proved", "[bundle]") {
  Random random(7);
  const CircleBundle good = bundle_on_tree_cut(torus_grid(3, 3).surface(), 1, 3);
  for (int trial = 0; trial < 200; ++trial) {
    CircleBundle bad = good;
    const TetFace f{random.below(bad.total.size()), random.below(4)};
    const TetFace g{random.below(bad.total.size()), random.below(4)};
    const TetFace f_partner = bad.total.partner(f);
    const TetFace g_partner = bad.total.partner(g);
    if (f == g || f == g_partner) continue;
    for (const TetFace face : {f, g}) bad.total.unglue(face);
    const auto any = [&](TetFace a, TetFace b) {
      std::array<int, 4> image{};
      for (int v = 0, w = 0; v < 4; ++v) {
        if (v == a.face) continue;
        if (w == b.face) ++w;
        image[v] = w++;
      }
      image[a.face] = b.face;
      bad.total.glue(a, b.tet, Perm4(image[0], image[1], image[2], image[3]));
    };
    any(f, g);
    any(f_partner, g_partner);
    CHECK(!prove(bad, Skeleton(bad.total)).failure.empty());
  }
}

TEST_CASE("The bundle of a disk is regular in the sense of Definition 5.1.1", "[bundle]") {
  Random random(3);
  for (const int fiber : {1, 2, 5}) {
    const Disk disk = random_disk({4, 3, 5, 6, false}, random);
    const CircleBundle bundle = trivial_bundle(disk, cut_free(disk), fiber);
    const Skeleton skeleton(bundle.total);
    const Proof proof = prove(bundle, skeleton);
    REQUIRE(proof.failure.empty()); // [2] and [3]: disjoint fibres of N edges
    CHECK(!proof.has_euler_number);
    CHECK(first_homology(bundle.total) == "Z");
    // [1]: N copies of the base, disjoint, each with all its vertices. Copy j is the bottoms of level j.
    std::set<int> all;
    for (int j = 0; j < fiber; ++j) {
      std::set<int> copy;
      for (int t = 0; t < disk.triangle_count(); ++t)
        for (int v = 0; v < 3; ++v) copy.insert(skeleton.vertex({3 * (fiber * t + j), v}).value);
      CHECK(static_cast<int>(copy.size()) == disk.vertex_count());
      all.insert(copy.begin(), copy.end());
    }
    CHECK(static_cast<int>(all.size()) == fiber * disk.vertex_count());
    CHECK(skeleton.vertex_count() == fiber * disk.vertex_count());
  }
}

TEST_CASE("Surfaces with boundary have trivial bundles, also with handles and crosscaps", "[bundle]") {
  for (const auto& [list, homology] :
       {std::pair{with_holes(icosphere(2), 3), std::string("Z^3")},
        {with_holes(torus_grid(6, 6), 1), std::string("Z^3")},
        // Moebius band: its group is that of the Klein bottle, as the fibre turns round.
        {with_holes(crosscaps(1), 1), std::string("Z + Z/2")}}) {
    const CircleBundle bundle = bundle_on_tree_cut(list.surface(), 0, 4);
    CHECK(prove(bundle, Skeleton(bundle.total)).failure.empty());
    CHECK(first_homology(bundle.total) == homology);
  }
}

TEST_CASE("The indices of a section add up to the Euler number, those of a field to chi", "[bundle]") {
  Random random(11);
  const auto number = [&] { return random.below(1'000'000) * 1e-6; };
  for (const Case& c : cases())
    for (const int e : c.eulers) {
      INFO(c.name << ", e = " << e);
      const CircleBundle bundle = bundle_on_tree_cut(c.surface, e, 3);
      const Proof proof = prove(bundle, Skeleton(bundle.total));
      for (int trial = 0; trial < 5; ++trial) {
        std::vector<double> place(static_cast<std::size_t>(bundle.base.vertex_count()));
        for (double& p : place) p = 3 * number();
        const auto index = indices(bundle, proof.fibers, short_section(bundle, proof.fibers, place));
        CHECK(std::accumulate(index.begin(), index.end(), 0) == e);
        // The shorter way: a triangle cannot turn by more than its three edges, half a turn each, and its
        // twist.
        for (const int i : index) CHECK(std::abs(i) <= 2);
        std::vector<std::array<double, 3>> points(place.size());
        for (auto& p : points) p = {number(), number(), number()};
        for (double& p : place) p *= 2;
        const auto turned = field_indices(bundle.base, points, place);
        CHECK(std::accumulate(turned.begin(), turned.end(), 0) == surface::type_of(bundle.base).euler);
      }
    }
}

TEST_CASE("Whatever adds up to the Euler number is the indices of a section, a field's among them",
          "[bundle]") {
  Random random(12);
  for (const Case& c : cases()) {
    const int chi = surface::type_of(c.surface).euler;
    const CircleBundle bundle = bundle_on_tree_cut(c.surface, chi, 3);
    const Fibers fibers = prove(bundle, Skeleton(bundle.total)).fibers;
    std::vector<double> place(static_cast<std::size_t>(bundle.base.vertex_count()));
    for (double& p : place) p = random.below(3000) * 1e-3;
    std::vector<std::array<double, 3>> points(place.size());
    for (auto& p : points)
      p = {place[random.below(static_cast<int>(place.size()))], random.below(100) * 0.1, 1};
    std::vector<int> wanted = field_indices(bundle.base, points, place);
    for (int trial = 0; trial < 3; ++trial) {
      const Section section = section_with_indices(bundle, fibers, place, wanted);
      CHECK(indices(bundle, fibers, section) == wanted);
      for (int k = 0; k < bundle.base.side_count(); ++k)
        CHECK(section.turns[bundle.base.mate(Side(k)).value] == -section.turns[k]);
      ++wanted[random.below(static_cast<int>(wanted.size()))];
      --wanted[random.below(static_cast<int>(wanted.size()))];
    }
    ++wanted[0];
    CHECK_THROWS_AS(section_with_indices(bundle, fibers, place, wanted), PreconditionError);
  }
  // With boundary anything goes.
  const CircleBundle ring = bundle_on_tree_cut(with_holes(icosphere(1), 2).surface(), 0, 2);
  const Fibers fibers = prove(ring, Skeleton(ring.total)).fibers;
  std::vector<int> wanted(static_cast<std::size_t>(ring.base.triangle_count()), 0);
  wanted[5] = 7;
  const std::vector<double> place(static_cast<std::size_t>(ring.base.vertex_count()), 0);
  CHECK(indices(ring, fibers, section_with_indices(ring, fibers, place, wanted)) == wanted);
}

namespace {

/// A grid of 16 x 16 squares around a point near its middle, triangulated.
TriangleList plane_grid() {
  const int n = 16;
  TriangleList plane;
  plane.vertices = (n + 1) * (n + 1);
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) plane.points.push_back({x - 8.3, y - 7.8, 0});
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      plane.triangles.insert(plane.triangles.end(), {{a, a + 1, a + n + 2}, {a, a + n + 2, a + n + 1}});
    }
  return plane;
}

/// The index of each triangle of a field in the plane, given by its angles against the x axis.
template <class Angle>
std::vector<int> plane_indices(const TriangleList& plane, Angle angle) {
  const surface::Surface surface = plane.surface();
  std::vector<double> direction(plane.points.size(), 0);
  std::vector<char> done(plane.points.size(), 0);
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int v = surface.corners(t)[c];
      if (done[v]) continue;
      done[v] = 1;
      const surface::SideEnd first = surface::fan(surface, {surface::Side(t, (c + 2) % 3), true}).front();
      const auto& p = plane.points[v];
      const auto& q = plane.points[surface.vertex({first.side, !first.at_start})];
      direction[v] = (first.at_start ? 1 : -1) * (angle(p) - std::atan2(q[1] - p[1], q[0] - p[0]));
    }
  return field_indices(surface, plane.points, direction);
}

} // namespace

TEST_CASE("A field in the plane that turns k times has index k at its zero", "[bundle]") {
  // z^k: along a circle about 0 it turns by k, so that is the sum of the indices inside, all of them near 0.
  const TriangleList plane = plane_grid();
  for (int k = -2; k <= 3; ++k) {
    const auto index = plane_indices(plane, [k](const auto& p) { return k * std::atan2(p[1], p[0]); });
    CHECK(std::accumulate(index.begin(), index.end(), 0) == k);
    for (std::size_t t = 0; t < index.size(); ++t)
      if (index[t] != 0)
        for (const int v : plane.triangles[t]) CHECK(std::hypot(plane.points[v][0], plane.points[v][1]) < 3);
  }
}

TEST_CASE("A constant vector projected to a globe has its zeros at two poles", "[bundle]") {
  // By hand: index 1 where the vector is normal to the sphere, 0 elsewhere.
  const TriangleList globe = icosphere(4);
  const std::array<double, 3> axis{0.3, -0.5, 0.81};
  const auto index =
      field_indices(globe.surface(), globe.points, projected_field(globe.surface(), globe.points, axis));
  int poles = 0;
  for (std::size_t t = 0; t < index.size(); ++t) {
    poles += index[t];
    const auto& p = globe.points[globe.triangles[t][0]];
    const double height =
        (p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2]) / std::hypot(axis[0], axis[1], axis[2]);
    if (index[t] != 0) CHECK(std::abs(height) > 0.99);
  }
  CHECK(poles == 2);
}

TEST_CASE("A field without zero has no index, even if it turns nearly half round along an edge", "[bundle]") {
  // By hand: from column to column it turns by 3.1 < pi; beyond pi the shorter way would be the other one.
  const TriangleList plane = plane_grid();
  for (const int axis : {0, 1})
    for (const int i : plane_indices(plane, [axis](const auto& p) { return 3.1 * p[axis]; })) CHECK(i == 0);
}

TEST_CASE("Recipes that do not fit are the caller's mistake", "[bundle]") {
  const surface::Surface sphere = tetrahedron_surface().surface();
  const std::vector<Shift> shift(12);
  CHECK_THROWS_AS(assemble({sphere, 0, shift, std::vector<std::int8_t>(12, 1)}), PreconditionError);
  CHECK_THROWS_AS(assemble({sphere, 1, shift, std::vector<std::int8_t>(12, 1)}), PreconditionError);
  CHECK_THROWS_AS(assemble({sphere, 1, {}, {}}), PreconditionError);
}
