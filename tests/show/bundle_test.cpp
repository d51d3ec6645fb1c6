// SPDX-License-Identifier: GPL-2.0-or-later
/// Pictures of circle bundles: the solid tori are solid, the bands have their colours.
#include "tetrarch/show/bundle.hpp"

#include "support/surfaces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/files.hpp"

#include "tetrarch/numeric/predicates.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::show;
using namespace tetrarch::support;

namespace {

bundle::Plan plan_of(const TriangleList& list, int fiber) {
  return std::get<bundle::Plan>(bundle::plan(list.marked(), {fiber, {}, {}, {}}));
}

double volume(const Cells& cells) {
  double sum = 0;
  for (const auto& t : cells.tetrahedra) {
    std::array<Point, 3> edge{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        edge[k][axis] = cells.points[t[k + 1]][axis] - cells.points[t[0]][axis];
    const auto& [a, b, c] = edge;
    sum += std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                    a[2] * (b[0] * c[1] - b[1] * c[0])) /
           6;
  }
  return sum;
}

} // namespace

TEST_CASE("The solid tori of a sphere's bundle have the volume of two rings and a boundary of two tori",
          "[scene]") {
  const bundle::Plan plan = plan_of(icosphere(2), 24);
  const Scene scene = solid_tori(plan, bundle::assemble(plan.recipe));
  const Cells& cells = scene.cells.at(0);
  // Pappus: the area of a disk times the way of its centre, 2.2 from the axis; polygons have a little less.
  const double turn = 2 * std::acos(-1.0);
  CHECK(volume(cells) == Approx(2 * turn / 2 * 2.2 * turn).epsilon(0.03));
  const Surface skin = outer_faces(cells);
  const surface::Surface surface(static_cast<int>(skin.points.size()), skin.triangles);
  const surface::Parts parts = surface::parts(surface);
  CHECK(parts.count == 2);
  for (const auto& part : surface::split(surface, parts))
    CHECK(surface::type_of(part.surface).str() == "torus");
  for (const Data& d : cells.data) CHECK(d.values.size() == cells.tetrahedra.size());
  CHECK_NOTHROW(write_scene(scene, SceneFormat::vtu));
}

TEST_CASE("No tetrahedron of the solid tori is inverted, however few levels there are", "[scene]") {
  for (const int fiber : {1, 2, 3, 4, 9})
    for (const auto& list : {icosphere(1), torus_grid(4, 5), klein_grid(4, 4)}) {
      INFO(fiber);
      const bundle::Plan plan = plan_of(list, fiber);
      const bundle::CircleBundle bundle = bundle::assemble(plan.recipe);
      const Cells cells = solid_tori(plan, bundle).cells.at(0);
      REQUIRE(cells.tetrahedra.size() == static_cast<std::size_t>(bundle.total.size()));
      for (const auto& t : cells.tetrahedra) {
        const auto p = [&](std::size_t k) { return cells.points.at(static_cast<std::size_t>(t[k])); };
        CHECK(numeric::volume_sign(p(0), p(1), p(2), p(3)) == numeric::Sign::positive);
      }
    }
}

TEST_CASE("Bands show each triangle of the boundary and each edge once", "[scene]") {
  const int fiber = 5;
  const bundle::Plan plan = plan_of(torus_grid(5, 4), fiber);
  const Scene scene = gluable_tori(plan);
  std::size_t triangles = 0;
  std::size_t edges = 0;
  for (const Surface& s : scene.surfaces) {
    triangles += s.triangles.size();
    edges += 3 * s.triangles.size() / 2;
  }
  const surface::Surface open = surface::cut_open(plan.cut);
  const std::size_t boundary = surface::boundary_curves(open).at(0).size();
  CHECK(triangles == 2 * boundary * fiber);
  // Fibres where two bands meet are drawn by both.
  CHECK(scene.tubes.at(0).colors.size() == edges + scene.surfaces.size() * fiber);
  CHECK_NOTHROW(write_scene(scene, SceneFormat::glb));
}

TEST_CASE("Under the gluing map the thick paths of both banks have the same length and colour", "[scene]") {
  const bundle::Plan plan = plan_of(icosphere(1), 4);
  const Drawing drawing = gluable_bands(plan);
  std::map<std::tuple<int, int, int>, int> thick;
  for (const Outline& o : drawing.outlines)
    if (o.ink.stroke && o.ink.width > 2)
      ++thick[{o.ink.stroke->red, o.ink.stroke->green, o.ink.stroke->blue}];
  // A base path and a diagonal path of 2 * 4 edges, and their images.
  REQUIRE(thick.size() == 2);
  for (const auto& [color, count] : thick) CHECK(count == 16);
  CHECK(write_svg(drawing).find("<svg") != std::string::npos);
}

TEST_CASE("The surface is shown with its cut and its singular triangles", "[scene]") {
  const bundle::Plan plan = plan_of(torus_grid(5, 4), 2);
  std::vector<int> index(static_cast<std::size_t>(plan.cut.surface.triangle_count()), 0);
  index[3] = 1;
  index[5] = -1;
  const Scene scene = cut_surface(plan, index);
  CHECK(scene.surfaces.at(0).data.at(1).values == index);
  CHECK(std::set<int>(scene.tubes.at(0).data.at(0).values.begin(),
                      scene.tubes.at(0).data.at(0).values.end()) == std::set<int>{1, 2});
  CHECK_NOTHROW(write_scene(scene, SceneFormat::ply));
  bundle::Plan without = plan;
  without.cut.points.clear();
  CHECK_THROWS_AS(cut_surface(without), PreconditionError);
}
