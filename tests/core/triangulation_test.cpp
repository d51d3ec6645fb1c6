// SPDX-License-Identifier: GPL-2.0-or-later
// What the caller may not do, what single types say of themselves, and the smallest cases.
#include "tetrarch/core/triangulation.hpp"

#include "support/zoo.hpp"
#include "tetrarch/core/boundary.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/truncated.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::support;

TEST_CASE("glue refuses what is no gluing and then changes nothing", "[triangulation]") {
  Triangulation tri(2);
  tri.glue({0, 0}, 1, Perm4(1, 0, 2, 3));
  const Triangulation before = tri;
  const auto revision = tri.revision();
  CHECK_THROWS_AS(tri.glue({0, 0}, 1, Perm4(2, 0, 1, 3)), PreconditionError); // glued already
  CHECK_THROWS_AS(tri.glue({1, 1}, 0, Perm4(0, 3, 2, 1)), PreconditionError); // the same from the other side
  CHECK_THROWS_AS(tri.glue({0, 2}, 0, Perm4(0, 1, 2, 3)), PreconditionError); // to itself
  CHECK_THROWS_AS(tri.glue({0, 2}, 0, Perm4(1, 0, 2, 3)), PreconditionError);
  CHECK_THROWS_AS(tri.glue({2, 0}, 1, Perm4()), PreconditionError);
  CHECK_THROWS_AS(tri.glue({-1, 0}, 1, Perm4()), PreconditionError);
  CHECK_THROWS_AS(tri.glue({0, 1}, 2, Perm4()), PreconditionError);
  CHECK_THROWS_AS(tri.glue({0, 1}, -1, Perm4()), PreconditionError);
  // These once asked the permutation about face 4 before refusing it; the sanitizers saw it.
  CHECK_THROWS_AS(tri.glue({0, 4}, 1, Perm4()), PreconditionError);
  CHECK_THROWS_AS(tri.glue({0, -1}, 1, Perm4()), PreconditionError);
  CHECK_THROWS_AS(tri.unglue({0, 4}), PreconditionError);
  CHECK_THROWS_AS(tri.unglue({2, 0}), PreconditionError);
  CHECK(tri == before);
  CHECK(tri.revision() == revision);
  tri.unglue({0, 1}); // a boundary face: nothing happens
  CHECK(tri.revision() == revision);
}

TEST_CASE("a stale skeleton is an error at once", "[skeleton]") {
  Triangulation tri = knotted_y();
  const Skeleton s(tri);
  const Triangulation copy = tri;
  CHECK_NOTHROW(s.require_current(tri));
  CHECK_NOTHROW(s.require_current(copy)); // a copy has the same gluings
  tri.unglue({0, 0});
  CHECK_THROWS_AS(s.require_current(tri), PreconditionError);
  CHECK_THROWS_AS(vertex_link(tri, s, VertexId(0)), PreconditionError);
  CHECK_THROWS_AS(boundary_surface(tri, s), PreconditionError);
  CHECK_THROWS_AS(boundary_components(tri, s), PreconditionError);
  tri.glue({0, 0}, 1, Perm4(1, 2, 3, 0));
  CHECK_THROWS_AS(s.require_current(tri), PreconditionError); // equal gluings, but nobody knows that cheaply
  CHECK_NOTHROW(s.require_current(copy));
  tri.add_tetrahedra();
  CHECK(tri.size() == 3);
  CHECK_THROWS_AS(s.require_current(tri), PreconditionError);
}

TEST_CASE("nothing is a triangulation too", "[triangulation]") {
  const Triangulation tri;
  const Skeleton s(tri);
  CHECK(s.face_count() == 0);
  CHECK(s.edge_count() == 0);
  CHECK(s.vertex_count() == 0);
  CHECK(s.component_count() == 0);
  CHECK(s.is_connected());
  CHECK(s.is_orientable());
  CHECK(is_valid(s));
  CHECK(boundary_components(tri, s).empty());
  CHECK(boundary_surface(tri, s).surface.size() == 0);
  CHECK(components(tri).count == 0);
  CHECK(orientation(tri)->empty());
  CHECK(TruncatedTriangulation(tri).boundary_euler() == 0);
}

TEST_CASE("components come apart in their old order", "[triangulation]") {
  Triangulation tri(4);
  tri.glue({0, 0}, 2, Perm4(1, 0, 2, 3));
  tri.glue({3, 1}, 3, Perm4(0, 2, 1, 3));
  const Components parts = components(tri);
  CHECK(parts.count == 3);
  CHECK(parts.of == std::vector<int>{0, 1, 0, 2});
  const Triangulation pair = component(tri, parts, 0);
  CHECK(pair.size() == 2);
  CHECK(pair.gluing({0, 0}) == Gluing{1, Perm4(1, 0, 2, 3)});
  CHECK(component(tri, parts, 1) == Triangulation(1));
  CHECK(component(tri, parts, 2).gluing({0, 2}) == Gluing{0, Perm4(0, 2, 1, 3)});
  CHECK(Skeleton(tri).component_count() == 3);
}

TEST_CASE("defects are named and described", "[check]") {
  Triangulation folded(1); // edge 01 is glued to itself backwards: faces 2 and 3 swap its ends
  folded.glue({0, 2}, 0, Perm4(1, 0, 3, 2));
  const Skeleton s(folded);
  REQUIRE(check(s).size() == 1);
  CHECK(check(s)[0].name() == "edge_reversed");
  CHECK(check(s)[0].edge == s.edge({0, 0}));
  CHECK(describe(check(s)[0], s) == "edge 0 (edge 01 of tetrahedron 0) is identified with itself reversed");

  int found = 0;
  for_each_gluing(1, [&](const Triangulation& tri) {
    const Skeleton skeleton(tri);
    for (const Defect& d : check(skeleton))
      if (d.kind == Defect::Kind::bad_vertex_link) {
        ++found;
        CHECK(d.name() == "bad_vertex_link");
        CHECK(describe(d, skeleton).find("has the link '" + skeleton.link(d.vertex).str() + "'") !=
              std::string::npos);
      }
  });
  CHECK(found > 0);
}

TEST_CASE("surface types have their usual names", "[surface]") {
  // Classification of surfaces: euler = 2 - 2g - holes, or 2 - crosscaps - holes.
  const auto name = [](int euler, int curves, bool orientable) {
    return SurfaceType{euler, curves, orientable}.str();
  };
  CHECK(name(2, 0, true) == "sphere");
  CHECK(name(0, 0, true) == "torus");
  CHECK(name(-2, 0, true) == "genus 2");
  CHECK(name(-8, 0, true) == "genus 5");
  CHECK(name(1, 0, false) == "projective plane");
  CHECK(name(0, 0, false) == "Klein bottle");
  CHECK(name(-1, 0, false) == "3 crosscaps");
  CHECK(name(1, 1, true) == "disk");
  CHECK(name(0, 2, true) == "sphere, 2 holes");
  CHECK(name(-1, 1, true) == "torus, 1 hole");
  CHECK(name(0, 1, false) == "projective plane, 1 hole");
  CHECK(name(-2, 1, false) == "3 crosscaps, 1 hole");
  CHECK(SurfaceType{-1, 1, true}.genus() == 1);
  CHECK(SurfaceType{0, 1, false}.genus() == 1);
}

TEST_CASE("small surfaces are classified", "[surface]") {
  // One triangle with two sides glued: a disk (cone) one way, a Moebius band the other way.
  TriangulatedSurface cone(1);
  cone.glue(0, 0, 0, {1, 0, 2});
  CHECK(classify(cone).type == std::vector<SurfaceType>{{1, 1, true}});
  TriangulatedSurface band(1);
  band.glue(0, 0, 0, {1, 2, 0});
  CHECK(classify(band).type == std::vector<SurfaceType>{{0, 1, false}});
  // Two triangles back to back are a sphere, shifted by a third a sphere too; a third one lies apart.
  TriangulatedSurface pillow(3);
  for (int s = 0; s < 3; ++s) pillow.glue(0, s, 2, {0, 1, 2});
  const SurfaceComponents parts = classify(pillow);
  CHECK(parts.of == std::vector<int>{0, 1, 0});
  CHECK(parts.type == std::vector<SurfaceType>{{2, 0, true}, {1, 1, true}});
  CHECK(classify(TriangulatedSurface()).type.empty());
}

TEST_CASE("the truncated view counts hexagons, edges and triangles", "[truncated]") {
  for (const ZooEntry& animal : zoo()) {
    const Triangulation tri = animal.triangulation();
    INFO(animal.name);
    if (Skeleton(tri).has_boundary_faces()) {
      CHECK_THROWS_AS(TruncatedTriangulation(tri), PreconditionError);
      continue;
    }
    const TruncatedTriangulation truncated(tri);
    CHECK(truncated.tetrahedron_count() == tri.size());
    CHECK(truncated.triangle_count() == 4 * tri.size());
    CHECK(truncated.hexagon_count() == 2 * tri.size());
    CHECK(truncated.boundary_euler() == 2 * (truncated.edge_count() - tri.size()));
    std::size_t edges = 0;
    std::size_t triangles = 0;
    for (const FaceId f : all<FaceId>(truncated.hexagon_count())) CHECK(truncated.preimages(f).size() == 2);
    for (const EdgeId e : all<EdgeId>(truncated.edge_count())) edges += truncated.preimages(e).size();
    for (const VertexId v : all<VertexId>(truncated.boundary_component_count())) {
      triangles += truncated.triangles(v).size();
      for (const TetVertex at : truncated.triangles(v)) CHECK(truncated.boundary_component(at) == v);
    }
    CHECK(edges == 6 * static_cast<std::size_t>(tri.size()));
    CHECK(triangles == 4 * static_cast<std::size_t>(tri.size()));
  }
}

TEST_CASE("error messages name the place and stay short", "[error]") {
  CHECK(std::string(InputError({"a.tri", 3}, "no vertex").what()) == "a.tri:3: no vertex");
  CHECK(std::string(InputError({"a.tri", 0}, "no vertex").what()) == "a.tri: no vertex");
  CHECK(std::string(InputError({"", 0}, "no vertex").what()) == "no vertex");
  CHECK(in_quotes("a\nb") == "'a?b'");
  CHECK(in_quotes(std::string(50, 'x')) == "'" + std::string(40, 'x') + "...'");
}

TEST_CASE("progress reports, and throws once a stop was requested", "[progress]") {
  std::stop_source stop;
  int reports = 0;
  const Progress progress([&](std::string_view, double) { ++reports; }, stop.get_token());
  progress.step("stage", 0.5);
  progress.silent().step("inner", 0.1);
  CHECK(reports == 1);
  stop.request_stop();
  CHECK_THROWS_AS(progress.step("stage", 0.6), Stopped);
  CHECK_THROWS_AS(progress.silent().step("inner"), Stopped);
  CHECK(reports == 1);
  CHECK_NOTHROW(Progress().step("stage"));
}
