// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/page.hpp"

#include "tessellate.hpp"
#include "tetrarch/scene/page_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace tetrarch::show {

using namespace scene;

namespace {

using Json = nlohmann::ordered_json;

void append(std::vector<float>& list, const Vector4& v) {
  for (const double x : v) list.push_back(static_cast<float>(x));
}

/// By columns, as WebGL wants it.
void append(std::vector<float>& list, const Matrix4& m) {
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) list.push_back(static_cast<float>(m[i][j]));
}

/// Curves are cut by their hyperbolic length: whatever copy a piece ends up in and however large it looks
/// there, it is then an arc of a circle of at most so many radians.
TooCoarse longer_than(double length) {
  return
      [length](const Vector4& a, const Vector4&, const Vector4& b) { return embed::distance(a, b) > length; };
}

const char* name_of(Patch::Kind kind) {
  return kind == Patch::Kind::face ? "face" : kind == Patch::Kind::cusp ? "cusp" : "boundary";
}

/// All patches of one kind as one surface.
Json surface(const Body& body, Patch::Kind kind, const TooCoarse& too_coarse) {
  std::vector<float> points;
  std::vector<float> normals;
  std::vector<std::uint32_t> triangles;
  std::vector<std::int32_t> tets;
  std::vector<std::int32_t> numbers;
  for (const Patch& patch : body.patches) {
    if (patch.kind != kind) continue;
    const auto first = static_cast<std::uint32_t>(tets.size());
    const Tessellation mesh = tessellated(patch, too_coarse);
    for (const Vector4& x : mesh.points) {
      append(points, x);
      append(normals, patch.normal);
      tets.push_back(patch.tet);
      numbers.push_back(patch.number);
    }
    for (const auto& t : mesh.triangles)
      for (const int corner : t) triangles.push_back(first + static_cast<std::uint32_t>(corner));
  }
  return {{"kind", name_of(kind)},          {"points", base64(points)},    {"normals", base64(normals)},
          {"triangles", base64(triangles)}, {"tetrahedron", base64(tets)}, {"class", base64(numbers)}};
}

Json tubes(const Body& body, const TooCoarse& too_coarse) {
  std::vector<float> points;
  Json starts = Json::array({0});
  Json tets = Json::array();
  Json numbers = Json::array();
  Json kinds = Json::array();
  for (const Arc& arc : body.arcs) {
    for (const Vector4& x : subdivided(arc, too_coarse)) append(points, x);
    starts.push_back(points.size() / 4);
    tets.push_back(arc.tet);
    numbers.push_back(arc.number);
    kinds.push_back(arc.edge ? "edge" : "side");
  }
  return {{"points", base64(points)},
          {"starts", starts},
          {"tetrahedron", tets},
          {"class", numbers},
          {"kind", kinds}};
}

/// The surfaces and the tubes, cut into pieces of at most this length.
Json shape(const Body& body, double length) {
  const TooCoarse too_coarse = longer_than(length);
  Json surfaces = Json::array();
  for (const auto kind : {Patch::Kind::face, Patch::Kind::boundary, Patch::Kind::cusp})
    if (std::any_of(body.patches.begin(), body.patches.end(),
                    [kind](const Patch& p) { return p.kind == kind; }))
      surfaces.push_back(surface(body, kind, too_coarse));
  return {{"surfaces", surfaces}, {"tubes", tubes(body, too_coarse)}};
}

Json body_json(const Body& body) {
  constexpr std::array<const char*, 3> views{"space", "vertical", "horizontal"};
  // A chord of 0.16 radians is 1/310 of the radius off. Large bodies are drawn more coarsely, so that the
  // page stays below about 5 MB up to a hundred tetrahedra.
  const double fine = 0.16 * std::clamp(std::sqrt(static_cast<double>(body.patches.size()) / 32), 1.0, 5.0);
  const double coarse = 3 * fine; // what copies that look small are drawn with
  Json tets = Json::array();
  for (std::size_t t = 0; t < body.parent.size(); ++t)
    tets.push_back({{"parent", body.parent[t]}, {"centre", body.middle[t]}});
  std::vector<float> matrices;
  for (const Matrix4& m : body.copies) append(matrices, m);
  std::vector<float> frame;
  append(frame, body.half_space);
  Json json{{"name", body.name}, {"view", views[static_cast<std::size_t>(body.view)]}, {"tetrahedra", tets}};
  json["shown"] = body.view == View::space ? 1 : body.copies.size();
  json.update(shape(body, fine));
  json["coarse"] = shape(body, coarse);
  json["half_space_frame"] = base64(frame);
  json["copies"] = {{"matrices", base64(matrices)}, {"length", base64(body.length)}};
  return json;
}

} // namespace

std::string page_data(const Page& page) {
  Json bodies = Json::array();
  for (const Body& body : page.bodies) bodies.push_back(body_json(body));
  return as_script({{"format", "tetrarch view"},
                    {"version", 1},
                    {"title", page.title},
                    {"tables", as_json(page.tables)},
                    {"bodies", bodies}});
}

std::string write_page(const Page& page) {
  return filled(viewer_page(), page_data(page));
}

} // namespace tetrarch::show
