// SPDX-License-Identifier: GPL-2.0-or-later

/// Bodies of hyperbolic space and what the models make of them.

#include "scene/scenes.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/signature.hpp"
#include "tetrarch/embed/boundary.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/show/in_model.hpp"
#include "tetrarch/show/page.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace tetrarch;
using namespace tetrarch::scene;
using namespace tetrarch::show;
using embed::Model;
using embed::operator*;

namespace {

constexpr std::array<Model, 3> models{Model::half_space, Model::ball, Model::klein};

struct Manifold {
  explicit Manifold(const std::string& sig)
      : tri(from_signature(sig)), skeleton(tri),
        domain(embed::fundamental_domain(tri, skeleton, hyperbolic::hyperbolize(tri, skeleton))) {}

  Body body(std::int64_t copies) const {
    return body_of(tri, skeleton, domain, embed::universal_cover(domain, {copies, 0, 0}));
  }
  Body boundary(std::int64_t copies) const {
    const auto lift = boundary_lifts(tri, skeleton, domain).front();
    return body_of(skeleton, lift, embed::group_piece(lift.pairings, lift.size, {copies, 0, 0}));
  }

  Triangulation tri;
  Skeleton skeleton;
  embed::Domain<double> domain;
};

/// Two tetrahedra, genus 2; the same with a cusp beside the boundary (three tetrahedra); the Gieseking
/// manifold, one tetrahedron and not orientable.
const std::array<std::string, 3> manifolds{"cPcbbbihq", "dLQacccjjkg", "bkaaid"};

/// Rounded, so that points that should be the same are.
std::array<long long, 3> place_of(const Point& p) {
  return {std::llround(p[0] * 1e7), std::llround(p[1] * 1e7), std::llround(p[2] * 1e7)};
}

/// All triangles of a scene as triples of places.
std::vector<std::array<std::array<long long, 3>, 3>> triangles_of(const Scene& scene) {
  std::vector<std::array<std::array<long long, 3>, 3>> all;
  for (const Surface& s : scene.surfaces)
    for (const auto& t : s.triangles)
      all.push_back({place_of(s.points[t[0]]), place_of(s.points[t[1]]), place_of(s.points[t[2]])});
  return all;
}

} // namespace

TEST_CASE("the faces of one tetrahedron's copy close up without cracks, oriented, in every model") {
  for (const std::string& sig : manifolds)
    for (const Model model : models) {
      const Manifold m(sig);
      Body body = m.body(1);
      // One tetrahedron alone is a ball: every side of a triangle belongs to one more, in the other
      // direction.
      std::erase_if(body.patches, [](const Patch& p) { return p.tet != 0; });
      ModelOptions options;
      options.model = model;
      options.chord_error = extent(body, model) / 100;
      options.tube_radius = 0;
      const Scene scene = in_model(body, options);
      std::map<std::pair<std::array<long long, 3>, std::array<long long, 3>>, int> sides;
      for (const auto& t : triangles_of(scene))
        for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
      int open = 0;
      for (const auto& [side, count] : sides) {
        const auto back = sides.find({side.second, side.first});
        open += count != 1 || back == sides.end() || back->second != 1;
      }
      CAPTURE(sig, to_string(model), sides.size());
      CHECK(open == 0);
      double volume = 0; // positive: outside is where the triangles go round counter-clockwise
      for (const Surface& s : scene.surfaces) volume += test::enclosed_volume(s);
      CHECK(volume > 0);
    }
}

TEST_CASE("normals are perpendicular to the surfaces and point outwards, in copies too") {
  for (const std::string& sig : manifolds)
    for (const Model model : models) {
      const Manifold m(sig);
      const Body body = m.body(8);
      ModelOptions options;
      options.model = model;
      options.chord_error = extent(body, model) / 400;
      const Scene scene = in_model(body, options);
      double least = 1;
      for (const Surface& s : scene.surfaces) {
        REQUIRE(s.normals.size() == s.points.size());
        for (const auto& t : s.triangles) {
          const Point& a = s.points[t[0]];
          Point u;
          Point v;
          for (int k = 0; k < 3; ++k) {
            u[k] = s.points[t[1]][k] - a[k];
            v[k] = s.points[t[2]][k] - a[k];
          }
          const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
          const double length = std::hypot(n[0], n[1], n[2]);
          if (length < 50 * options.chord_error * options.chord_error) continue; // as small as the error
          const Point& normal = s.normals[t[0]];
          least = std::min(least, (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2]) / length);
        }
      }
      CAPTURE(sig, to_string(model));
      CHECK(least > 0.7); // a triangle's own normal leans away a little from the surface's at its corner
    }
}

TEST_CASE("no chord is further than the error from the curve") {
  const Manifold m("cPcbbbihq");
  for (const Model model : models) {
    Body body = m.body(1);
    ModelOptions options;
    options.model = model;
    options.inner = false;
    std::size_t before = 0;
    for (const double error : {0.1, 0.01, 0.001}) {
      options.chord_error = error * extent(body, model);
      const Scene scene = in_model(body, options);
      // Points in the middle of triangles' sides, back on the hyperboloid, against the plane of the patch:
      // the surface of the largest boundary circle is a sphere, so a chord of error e misses it by at most
      // about e.
      std::size_t count = 0;
      for (const Surface& s : scene.surfaces) count += s.triangles.size();
      if (model != Model::klein) CHECK(count > before);
      before = count;
    }
    if (model == Model::klein) CHECK(before < 400); // flat: nothing but the fans
  }
  // Tubes: the middle of each piece of an edge, against the geodesic through its ends.
  const Body body = m.body(1);
  ModelOptions options;
  options.chord_error = 0.003;
  const Scene scene = in_model(body, options);
  const Tubes& tubes = scene.tubes.front();
  double worst = 0;
  for (std::size_t k = 0; k + 1 < tubes.starts.size(); ++k)
    for (int i = tubes.starts[k]; i + 1 < tubes.starts[k + 1]; ++i) {
      const auto x = embed::from_model(Model::half_space, tubes.points[i]);
      const auto y = embed::from_model(Model::half_space, tubes.points[i + 1]);
      const auto middle = to_model(Model::half_space, embed::normalized(embed::combination(1.0, x, 1.0, y)));
      // The distance of the middle from the chord, by the area of the triangle.
      const Point chord = test::minus(tubes.points[i + 1], tubes.points[i]);
      const Point up = test::minus(middle, tubes.points[i]);
      const Point area{chord[1] * up[2] - chord[2] * up[1], chord[2] * up[0] - chord[0] * up[2],
                       chord[0] * up[1] - chord[1] * up[0]};
      worst = std::max(worst, test::norm(area) / test::norm(chord));
    }
  CHECK(worst <= 0.003);
  CHECK(worst > 0.0003);
}

TEST_CASE("data name the tetrahedron, the copy, the word length and the class of every triangle") {
  const Manifold m("dLQacccjjkg");
  const Body body = m.body(20);
  const Scene scene = in_model(body, {});
  std::set<int> copies;
  std::set<int> tets;
  std::set<int> faces;
  for (const Surface& s : scene.surfaces) {
    REQUIRE(s.data.size() == 5);
    for (const Data& d : s.data) REQUIRE(d.values.size() == s.triangles.size());
    tets.insert(s.data[0].values.begin(), s.data[0].values.end());
    copies.insert(s.data[1].values.begin(), s.data[1].values.end());
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
      REQUIRE(s.data[2].values[t] == body.length[s.data[1].values[t]]);
      REQUIRE((s.data[3].values[t] < 0) != (s.data[4].values[t] < 0));
    }
    faces.insert(s.data[3].values.begin(), s.data[3].values.end());
  }
  CHECK(copies.size() == 20);
  CHECK(tets.size() == 3);
  CHECK(static_cast<int>(faces.size()) == m.skeleton.face_count() + 1); // and -1, on truncations
  // One surface for the faces, one for the boundary, one for the cusp.
  CHECK(scene.surfaces.size() == 3);
  for (const auto format : {SceneFormat::glb, SceneFormat::ply, SceneFormat::obj, SceneFormat::vtu})
    CHECK_FALSE(write_scene(scene, format).empty());
}

TEST_CASE("faces inside a copy and doubled edges can be left out") {
  const Manifold m("cPcbbbihq");
  const Body body = m.body(1);
  ModelOptions options;
  options.model = Model::klein;
  const auto count = [&] {
    std::size_t faces = 0;
    for (const Surface& s : in_model(body, options).surfaces)
      for (std::size_t t = 0; t < s.triangles.size(); ++t) faces += s.data[3].values[t] >= 0;
    return faces;
  };
  const std::size_t all = count();
  options.inner = false;
  CHECK(all * 6 == count() * 8); // hexagons: 8 t-faces, 6 of them open
  // By hand: the two tetrahedra share three edges, 12 - 3 are drawn; they share three sides of triangles too.
  int edges = 0;
  int sides = 0;
  for (const Arc& arc : body.arcs) (arc.edge ? edges : sides) += !arc.inner;
  CHECK(edges == 9);
  CHECK(sides == 24 - 3);
}

TEST_CASE("the circles at infinity: each lift of the boundary once, and they do not cross") {
  const Manifold m("cPcbbbihq");
  const Drawing drawing = circles_at_infinity(m.body(200));
  CHECK(drawing.circles.size() > 100);
  // Geodesic boundary components are disjoint: their planes, hence their circles, do not meet.
  int crossing = 0;
  for (std::size_t i = 0; i < drawing.circles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Circle& a = drawing.circles[i];
      const Circle& b = drawing.circles[j];
      const double apart = std::hypot(a.center[0] - b.center[0], a.center[1] - b.center[1]);
      const double slack = 1e-9 * (a.radius + b.radius);
      crossing += apart < a.radius + b.radius - slack && apart > std::abs(a.radius - b.radius) + slack;
      REQUIRE(apart + std::abs(a.radius - b.radius) > 1e-7); // no circle twice
    }
  CHECK(crossing == 0);
  // The truncation at vertex 0 of tetrahedron 0 is the unit circle (section 4.4.2).
  CHECK(std::any_of(drawing.circles.begin(), drawing.circles.end(), [](const Circle& c) {
    return std::hypot(c.center[0], c.center[1]) < 1e-9 && std::abs(c.radius - 1) < 1e-9;
  }));
  // Of the domain alone (figure 4.12): the unit circle and the one of radius e^l around it, which tetrahedron
  // 0's vertices 0 and 1 have, and two lines through 0 for its faces on the axis.
  const Drawing one = circles_at_infinity(m.body(1));
  CHECK(std::count_if(one.circles.begin(), one.circles.end(),
                      [](const Circle& c) { return std::hypot(c.center[0], c.center[1]) < 1e-9; }) >= 2);
  CHECK(std::count_if(one.outlines.begin(), one.outlines.end(), [](const Outline& o) {
          const auto& [p, q] = std::pair{o.points[0], o.points[1]};
          return std::abs(p[0] * q[1] - p[1] * q[0]) < 1e-3;
        }) >= 2);
  CHECK(write_svg(drawing).find("<circle") != std::string::npos);
}

TEST_CASE("a boundary's tiling is drawn in the half plane, the disk, and for a cusp in the plane") {
  const Manifold m("cPcbbbihq");
  const Body tiling = m.boundary(50);
  CHECK(tiling.view == View::vertical);
  CHECK(tiling.name == "boundary 0 (genus 2)");
  ModelOptions options;
  const Drawing half_plane = drawing_of(tiling, options);
  CHECK(half_plane.outlines.size() == 50 * 8 + 1); // eight triangles a copy, and the real axis
  for (const Outline& o : half_plane.outlines)
    for (const auto& p : o.points) REQUIRE(p[1] >= 0);
  options.model = Model::ball;
  const Drawing disk = drawing_of(tiling, options);
  for (const Outline& o : disk.outlines)
    for (const auto& p : o.points) REQUIRE(std::hypot(p[0], p[1]) < 1);
  const Manifold cusped("cPcbbbiht");
  const Body torus = cusped.boundary(9);
  CHECK(torus.view == View::horizontal);
  double area = 0; // of one copy: eight Euclidean triangles at height 1, altogether the cusp's area 1/2
  for (const Patch& patch : torus.patches) {
    std::array<Point, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = to_model(Model::half_space, patch.corners[k]);
    for (const Point& q : p) REQUIRE(q[2] == Approx(1));
    area += ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])) / 2;
  }
  CHECK(area == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("the nearest copies are kept, nearest first") {
  const Manifold m("cPcbbbihq");
  Body body = m.body(200);
  std::vector<double> far;
  for (const auto& copy : body.copies) far.push_back(copy[3][3]);
  std::sort(far.begin(), far.end());
  keep_nearest(body, 50);
  REQUIRE(body.copies.size() == 50);
  REQUIRE(body.length.size() == 50);
  CHECK(body.length[0] == 0);
  for (std::size_t c = 0; c < 50; ++c) REQUIRE(body.copies[c][3][3] == Approx(far[c]).epsilon(1e-5));
}

TEST_CASE("bad options are refused") {
  const Manifold m("bkaaid");
  ModelOptions options;
  options.chord_error = 0;
  CHECK_THROWS_AS(in_model(m.body(1), options), PreconditionError);
  options = {};
  options.tube_radius = -1;
  CHECK_THROWS_AS(in_model(m.body(1), options), PreconditionError);
}

TEST_CASE("a page's data hold the bodies in R^{3,1}, and nothing that ends a script") {
  const Manifold m("cPcbbbihq");
  Page page{"</script><b>", {{"Manifold", {}, {{"volume", "6.45"}}}}, {m.body(5), m.boundary(7)}};
  const std::string text = page_data(page);
  CHECK(text.find('<') == std::string::npos);
  const auto data = nlohmann::json::parse(text);
  CHECK(data["title"] == "</script><b>");
  CHECK(data["format"] == "tetrarch view");
  REQUIRE(data["bodies"].size() == 2);
  // Base 64: four digits for every three bytes, padded. 5 copies of 16 floats; 5 lengths.
  CHECK(data["bodies"][0]["copies"]["matrices"].get<std::string>().size() == (5 * 64 + 2) / 3 * 4);
  CHECK(data["bodies"][0]["copies"]["length"].get<std::string>().size() == (5 * 4 + 2) / 3 * 4);
  // The first copy is the identity: 1.0f is 00 00 80 3f, which with 16 zero bytes after it begins so.
  CHECK(data["bodies"][0]["copies"]["matrices"].get<std::string>().starts_with("AACAPwAAAAA"));
  CHECK(data["bodies"][0]["tetrahedra"].size() == 2);
  CHECK(data["bodies"][0]["tetrahedra"][1]["parent"] == 0);
  CHECK(data["bodies"][1]["view"] == "vertical");
}
