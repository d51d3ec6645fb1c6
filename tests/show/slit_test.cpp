// SPDX-License-Identifier: GPL-2.0-or-later
/// Pictures of slit maps: all of the domain is there, in its place, and the surface keeps its vertices.
#include "tetrarch/show/slit.hpp"

#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/mesh_files.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::show;

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr std::array<SlitDomain, 3> all_domains{SlitDomain::cylindric, SlitDomain::parallel,
                                                SlitDomain::concentric};

const slit::OneForms& ring_two_holes() {
  static const slit::OneForms forms(doctor::build_surface(
      format::read_soup_file(TETRARCH_SOURCE_DIR "/tests/data/mesh/ring_two_holes.off")));
  return forms;
}

double area(const Surface& s) {
  double sum = 0;
  for (const auto& corners : s.triangles) {
    const auto edge = [&](int c, int axis) {
      return s.points[corners[c]][axis] - s.points[corners[0]][axis];
    };
    std::array<double, 3> normal{};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      normal[i] = edge(1, j) * edge(2, k) - edge(1, k) * edge(2, j);
    }
    sum += std::hypot(normal[0], normal[1], normal[2]) / 2;
  }
  return sum;
}

} // namespace

TEST_CASE("The pictured domains have the areas of a rectangle and of a ring", "[scene]") {
  const slit::OneForms& forms = ring_two_holes();
  const slit::SlitMap map = slit::slit_map(forms, 0, 1);
  const double inner = std::exp(-map.modulus);
  const std::map<SlitDomain, double> expected{
      {SlitDomain::parallel, full_turn * map.modulus},
      {SlitDomain::cylindric, full_turn * map.modulus}, // a polygon of some forty sides has a little less
      {SlitDomain::concentric, full_turn / 2 * (1 - inner * inner)}};
  for (const SlitDomain domain : all_domains) {
    const Scene scene = slit_domain(forms.mesh(), layout(forms, map, domain));
    const double slack = domain == SlitDomain::parallel ? 1e-9 : 0.04;
    CHECK(area(scene.surfaces.at(0)) == Approx(expected.at(domain)).epsilon(slack));
    CHECK_NOTHROW(write_scene(scene, SceneFormat::glb));
    CHECK_NOTHROW(write_scene(scene, SceneFormat::ply));
  }
}

TEST_CASE("Vertices keep their numbers, and only the rectangle has more", "[scene]") {
  const slit::OneForms& forms = ring_two_holes();
  const slit::SlitMap map = slit::slit_map(forms, 0, 1);
  const auto vertices = static_cast<std::size_t>(forms.mesh().surface.vertex_count());
  for (const SlitDomain domain : all_domains) {
    const Scene scene = textured_surface(forms.mesh(), layout(forms, map, domain));
    const Surface& s = scene.surfaces.at(0);
    CHECK(std::equal(forms.mesh().points.begin(), forms.mesh().points.end(), s.points.begin()));
    CHECK((s.points.size() > vertices) == (domain != SlitDomain::concentric));
    CHECK(s.textures.size() == s.points.size());
    CHECK(area(s) ==
          Approx(area({"", forms.mesh().points, {}, {}, forms.mesh().surface.triangles(), {}, {}})));
    CHECK_NOTHROW(write_scene(scene, SceneFormat::vtu));
    CHECK(slit_domain(forms.mesh(), layout(forms, map, domain)).surfaces.at(0).textures == s.textures);
  }
}

TEST_CASE("Textures across the seam are no wider than triangles are", "[scene]") {
  const slit::OneForms& forms = ring_two_holes();
  const slit::SlitMap map = slit::slit_map(forms, 0, 1);
  const Scene scene = textured_surface(forms.mesh(), layout(forms, map, SlitDomain::cylindric));
  const Surface& s = scene.surfaces.at(0);
  double sum = 0;
  for (const auto& [a, b, c] : s.triangles) {
    const auto& [p, q, r] = std::array{s.textures[a], s.textures[b], s.textures[c]};
    sum += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
    CHECK(std::max({p[0], q[0], r[0]}) - std::min({p[0], q[0], r[0]}) < 0.3);
  }
  // A rectangle of width 1, counter-clockwise: both axes have one scale.
  CHECK(sum == Approx(map.modulus / (2 * std::numbers::pi)));
}

TEST_CASE("The OBJ has the vertices and triangles of the surface in their order", "[scene]") {
  const slit::OneForms& forms = ring_two_holes();
  const slit::SlitMap map = slit::slit_map(forms, 0, 1);
  for (const SlitDomain domain : all_domains) {
    const format::Soup soup =
        format::read_soup(textured_obj(forms.mesh(), layout(forms, map, domain)), "picture.obj");
    CHECK(soup.points == forms.mesh().points);
    CHECK(soup.triangles == forms.mesh().surface.triangles());
  }
}

TEST_CASE("The drawing shows each edge and, thick, each loop", "[scene]") {
  const slit::OneForms& forms = ring_two_holes();
  const slit::SlitMap map = slit::slit_map(forms, 0, 1);
  const surface::Surface& surface = forms.mesh().surface;
  const auto seam = slit::parallel_domain(surface, map).seam.size() / 2;
  for (const SlitDomain domain : all_domains) {
    const Drawing drawing = slit_drawing(forms.mesh(), layout(forms, map, domain));
    std::size_t thin = 0;
    std::size_t thick = 0;
    double longest = 0;
    for (const Outline& outline : drawing.outlines) {
      const auto& p = outline.points;
      (outline.ink.width < 1 ? thin : thick) += p.size() - 1;
      for (std::size_t k = 1; k < p.size(); ++k)
        longest = std::max(longest, std::hypot(p[k][0] - p[k - 1][0], p[k][1] - p[k - 1][1]));
    }
    CHECK(longest < 1); // nothing runs back across the domain
    // Edges of the seam are drawn twice.
    CHECK(thin == surface.edge_count() + (domain == SlitDomain::concentric ? 0 : seam));
    CHECK(thick ==
          forms.loops()[0].sides.size() + forms.loops()[1].sides.size() + forms.loops()[2].sides.size());
  }
}
