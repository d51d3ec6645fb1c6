// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/moves/truncate.hpp"

#include "support/enumeration.hpp"
#include "support/groups.hpp"
#include "support/homology.hpp"
#include "support/laws.hpp"
#include "support/links.hpp"
#include "support/zoo.hpp"
#include "tetrarch/algebra/homology.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/identify/recognise.hpp"
#include "tetrarch/moves/boundary_moves.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

using namespace tetrarch;
using namespace tetrarch::moves;
using namespace tetrarch::support;

namespace {

algebra::Presentation group_of(const Triangulation& tri) {
  return simplified(algebra::dual_presentation(tri, Skeleton(tri)).presentation);
}

/// Types of all boundary components but spheres, sorted.
std::vector<std::string> boundary_types(const Triangulation& tri) {
  const Skeleton skeleton(tri);
  std::vector<std::string> types;
  for (const BoundaryComponent& b : boundary_components(tri, skeleton))
    if (!b.type.is_sphere()) types.push_back(b.type.str());
  std::sort(types.begin(), types.end());
  return types;
}

/// What must survive of a connected solid with boundary other than spheres; empty if it did. With
/// `keep_spheres` nothing is filled in, so that H1 stays too.
std::string broken_by_truncation(const Triangulation& solid, const Truncation& made) {
  const Skeleton skeleton(made.tri);
  if (!is_valid(skeleton) || !skeleton.is_connected()) return "not a connected manifold";
  if (skeleton.has_boundary_faces()) return "faces are left on the boundary";
  if (made.finite_vertices != 0) return "finite vertices are left";
  if (first_homology(made.tri) != first_homology(solid)) return "H1 differs";
  if (boundary_types(made.tri) != boundary_types(solid)) return "the boundary differs";
  const auto components = boundary_components(solid, Skeleton(solid));
  if (components.size() != made.boundary.size()) return "the boundary map has another length";
  for (std::size_t k = 0; k < components.size(); ++k) {
    const BoundaryImage& image = made.boundary[k];
    if (!(image.type == components[k].type)) return "component " + std::to_string(k) + " has another type";
    if (image.vertex.tet >= 0 && !(skeleton.link(skeleton.vertex(image.vertex)) == components[k].type))
      return "component " + std::to_string(k) + " ends at the wrong vertex";
  }
  return "";
}

} // namespace

TEST_CASE("exteriors of knots and links become known gluings", "[moves]") {
  // Tetrahedra of the smallest ideal triangulations of the hyperbolic ones: m004, m015, m129 of the census of
  // Callahan, Hildebrand and Weeks; the Borromean rings have two regular ideal octahedra, cut in four each.
  const std::map<std::string, int> tetrahedra{
      {"figure eight", 2}, {"5_2", 3}, {"Whitehead link", 4}, {"Borromean rings", 8}};
  for (const NamedLink& link : links()) {
    const Triangulation solid = triangulation_of(exterior(link.grid));
    const Truncation made = truncate(solid);
    INFO(link.name << " " << signature(made.tri));
    CHECK(broken_by_truncation(solid, made) == "");
    CHECK(made.boundary.size() == static_cast<std::size_t>(link.components) + 1); // the box is a sphere
    CHECK(std::count_if(made.boundary.begin(), made.boundary.end(),
                        [](const BoundaryImage& b) { return b.vertex.tet < 0; }) == 1);
    const algebra::Presentation before = group_of(solid);
    const algebra::Presentation after = group_of(made.tri);
    REQUIRE(std::max(before.generators, after.generators) <= 4);
    CHECK(homomorphisms_to_s4(before) == homomorphisms_to_s4(after));
    if (const auto known = tetrahedra.find(link.name); known != tetrahedra.end())
      CHECK(made.tri.size() == known->second);
  }
  CHECK(signature(truncate(triangulation_of(exterior(named_link("figure eight").grid))).tri) ==
        zoo("figure-eight complement m004").signature);
}

TEST_CASE("the knotted Y comes out of its mesh", "[moves]") {
  // The headline of section 4.2.3: the gluing that the dissertation prints is the zoo's.
  const Triangulation solid = solid::triangulation_of(
      doctor::build(format::read_soup_file(TETRARCH_SOURCE_DIR "/tests/data/knotted_y_8k.mesh")));
  REQUIRE(solid.size() == 7709);
  const Truncation made = truncate(solid);
  CHECK(broken_by_truncation(solid, made) == "");
  CHECK(signature(made.tri) == signature(knotted_y()));
  const algebra::Presentation before = group_of(solid);
  const algebra::Presentation after = group_of(made.tri);
  REQUIRE(std::max(before.generators, after.generators) <= 3);
  CHECK(homomorphisms_to_s4(before) == homomorphisms_to_s4(after));
}

TEST_CASE("spheres are kept on request", "[moves]") {
  TruncateOptions options;
  options.keep_spheres = true;
  const Triangulation solid = triangulation_of(exterior(named_link("trefoil").grid));
  const Truncation made = truncate(solid, options);
  const Skeleton skeleton(made.tri);
  REQUIRE(skeleton.vertex_count() == 2);
  REQUIRE(made.boundary.size() == 2);
  for (const BoundaryImage& b : made.boundary) REQUIRE(b.vertex.tet >= 0);
  CHECK(made.boundary[0].type.is_sphere());
  CHECK(made.boundary[1].type.str() == "torus");
  CHECK(made.finite_vertices == 0);
}

TEST_CASE("a ball is filled in and leaves one finite vertex", "[moves]") {
  const Truncation made = truncate(cubical_ball(4, 4, 4));
  CHECK(made.finite_vertices >= 1);
  CHECK(made.boundary.size() == 1);
  CHECK(made.boundary[0].vertex.tet == -1);
  CHECK(first_homology(made.tri) == "0");
  CHECK(made.tri.size() <= 2);
}

TEST_CASE("ideal vertices and real boundary go together", "[moves]") {
  // A cusped manifold with one tetrahedron taken out: a sphere of four triangles, filled in again.
  const Triangulation cusped = zoo("figure-eight complement m004").triangulation();
  Complex complex(cusped);
  REQUIRE_FALSE(apply(complex, {MoveKind::one_four, 0}));
  const int middle = complex.last_change().new_tets[0];
  REQUIRE_FALSE(apply(complex, {MoveKind::one_four, middle}));
  complex.begin_change();
  Triangulation with_hole = complex.triangulation();
  const Truncation made = truncate(with_hole);
  CHECK(signature(made.tri) == signature(cusped));
  REQUIRE(made.boundary.size() == 1);
  CHECK(made.boundary[0].type.str() == "torus");
}

TEST_CASE("the conversion refuses what is no manifold, and names the place", "[moves]") {
  Triangulation folded(1); // edge 01 is glued to itself backwards
  folded.glue({0, 2}, 0, Perm4(1, 0, 3, 2));
  CHECK_THROWS_AS(truncate(folded), PreconditionError);
}

TEST_CASE("a move log of the whole conversion replays", "[moves]") {
  const Triangulation solid = triangulation_of(exterior(named_link("Hopf link").grid));
  MoveLog log;
  TruncateOptions options;
  options.simplify.log = &log;
  const Truncation made = truncate(solid, options);
  Complex complex(solid);
  REQUIRE_FALSE(replay(complex, log));
  CHECK(complex.triangulation() == made.tri);
}

TEST_CASE("random handlebodies and link exteriors survive the conversion", "[moves]") {
  Random random(41);
  for (int k = 0; k < 60; ++k) {
    const Scale scale{2, 1};
    const Voxels solid = k % 2 == 0 ? bars(random_graph({3, 3, 2}, k % 5, random), scale)
                                    : exterior(random_link(4 + k % 3, 1 + k % 2, random), scale);
    const Triangulation tri = triangulation_of(solid);
    TruncateOptions options;
    options.simplify.seed = static_cast<std::uint64_t>(k);
    options.keep_spheres = k % 2 == 0 && k % 5 == 0; // a ball alone has nothing else to keep
    const Truncation made = truncate(tri, options);
    INFO(k);
    REQUIRE(broken_by_truncation(tri, made) == "");
  }
}

TEST_CASE("a thousand random handlebodies and link exteriors survive the conversion", "[moves][slow]") {
  Random random(1000);
  int handlebodies = 0;
  for (int k = 0; k < 1000; ++k) {
    const bool handlebody = k % 2 == 0;
    const int genus = 1 + random.below(5);
    const int components = 1 + random.below(2);
    const Scale scale{2 + random.below(2), 1};
    const Voxels solid = handlebody ? bars(random_graph({3, 3, 3}, genus, random), scale)
                                    : exterior(random_link(5 + random.below(4), components, random), scale);
    const Triangulation tri = triangulation_of(solid);
    TruncateOptions options;
    options.simplify.seed = static_cast<std::uint64_t>(k);
    const Truncation made = truncate(tri, options);
    INFO(k);
    REQUIRE(broken_by_truncation(tri, made) == "");
    // By construction: H1 is free, of the genus or of the number of components.
    const int rank = handlebody ? genus : components;
    REQUIRE(first_homology(made.tri) == (rank == 1 ? std::string("Z") : "Z^" + std::to_string(rank)));
    if (handlebody) {
      ++handlebodies;
      CHECK(identify::recognise(made.tri).name ==
            (genus == 1 ? std::string("solid torus") : "genus " + std::to_string(genus) + " handlebody"));
    }
  }
  CHECK(handlebodies == 500);
}

TEST_CASE("a cone is refused where a link is no disk, and for a part of a component", "[moves]") {
  // Every gluing of one tetrahedron whose boundary has a vertex with another link than a disk.
  int bad = 0;
  for_each_gluing(1, [&](const Triangulation& tri) {
    const Complex start(tri);
    for (const auto& component : boundary_faces(start)) {
      bool disks = true;
      for (const TetFace f : component)
        for (const int v : face_vertex[f.face])
          disks = disks && start.link(start.vertex({f.tet, v})) == LinkKind::disk;
      if (disks) continue;
      Complex complex = start;
      REQUIRE(cone(complex, component) == Obstacle::bad_vertex);
      REQUIRE(complex.triangulation() == tri);
      if (is_valid(Skeleton(tri))) continue;
      CHECK_THROWS_WITH(truncate(tri), Catch::Contains("backwards") || Catch::Contains("is no disk"));
      ++bad;
    }
  });
  CHECK(bad > 0);
  Complex ball(cubical_ball(1, 1, 1));
  auto part = boundary_faces(ball).front();
  part.pop_back();
  CHECK_THROWS_AS(cone(ball, part), PreconditionError);
}

TEST_CASE("a sphere and a torus keep their names whatever excursions are taken", "[moves]") {
  for (const char* name : {"trefoil", "figure eight", "Hopf link"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      TruncateOptions options;
      options.keep_spheres = true;
      options.simplify.seed = seed;
      const Truncation made = truncate(triangulation_of(exterior(named_link(name).grid)), options);
      const Skeleton skeleton(made.tri);
      INFO(name << ", seed " << seed);
      for (std::size_t k = 0; k < made.boundary.size(); ++k) {
        // The box's sphere is met first, then one torus a component.
        REQUIRE(made.boundary[k].type.is_sphere() == (k == 0));
        for (std::size_t l = 0; l < k; ++l)
          REQUIRE(skeleton.vertex(made.boundary[k].vertex) != skeleton.vertex(made.boundary[l].vertex));
      }
    }
}
