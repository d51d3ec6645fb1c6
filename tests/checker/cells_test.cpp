// SPDX-License-Identifier: GPL-2.0-or-later

/// Certificates with canonical cells: accepted as they are made, refused where a claim of a face is false.

#include "../verified/certified.hpp"

#include "tetrarch/canonical/decorated.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/catalogue/validate.hpp"
#include "tetrarch/checker/check.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/moves/ball.hpp"
#include "tetrarch/workshop/canonical.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <variant>

using namespace tetrarch;
using Json = nlohmann::json;

namespace {

workshop::Cells with_certificate(const std::string& signature) {
  workshop::CanonicalOptions options;
  options.certify = true;
  return workshop::cells(from_signature(signature), options);
}

checker::Report report_of(const Json& certificate) {
  return checker::check(certificate.dump(), "cells");
}

bool accepts(const Json& certificate) {
  try {
    return report_of(certificate).accepted;
  } catch (const InputError&) {
    return false;
  }
}

/// What `canonize` says and what the checker proves.
void compare_walls(const workshop::Cells& cells, const std::string& name) {
  const checker::Report report = checker::check(cells.certificate, name);
  CHECK(report.why_not.empty());
  CHECK(report.has_cells);
  const canonical::Canonical& c = *cells.canonical;
  int flat = 0;
  for (const auto& faces : c.flat)
    for (const bool here : faces) flat += here ? 1 : 0;
  CHECK(report.walls == 2 * c.triangulation.size() - flat / 2);
  int unchecked = 0;
  for (const auto& [criterion, faces] : report.unchecked) unchecked += faces;
  CHECK(unchecked == flat / 2);
}

/// By another route, in doubles: the claims of all faces, at the claimed area.
bool are_true_claims(const Json& certificate, const Triangulation& tri) {
  const Skeleton skeleton(tri);
  hyperbolic::Metric<double> lengths(skeleton.edge_count(), 0);
  for (const Json& edge : certificate["edges"])
    lengths[skeleton.edge({edge["tetrahedron"].get<int>(), edge["edge"].get<int>()})] =
        std::stod(edge["length"].get<std::string>());
  canonical::Decorated<double> m = canonical::decorate(tri, skeleton, lengths);
  const Json& cells = certificate["cells"];
  if (!cells["cusp_area"].is_null()) {
    std::vector<int> vertex;
    for (int t = 0; t < tri.size(); ++t)
      for (int v = 0; v < 4; ++v) vertex.push_back(skeleton.vertex({t, v}).value);
    canonical::set_cusp_areas(m, vertex, skeleton.vertex_count(),
                              std::stod(cells["cusp_area"].get<std::string>()));
  }
  for (const Json& face : cells["faces"]) {
    const double tilt = canonical::look_across(m, {face["tetrahedron"], face["face"]}).tilt;
    if (face["flat"].is_null() ? !(tilt > 0) : !(std::abs(tilt) < 1e-6)) return false;
  }
  return true;
}

Json with_other_cells(Json certificate, support::Random& random) {
  Json& cells = certificate["cells"];
  Json& faces = cells["faces"];
  Json& face = faces[random.below(static_cast<int>(faces.size()))];
  switch (random.below(6)) {
  case 0:
  case 1:
    face["flat"] = face["flat"].is_null() ? Json("R") : Json();
    break;
  case 2:
    faces.erase(random.below(static_cast<int>(faces.size())));
    break;
  case 3:
    faces.push_back(face);
    break;
  case 4:
    cells["cusp_area"] = cells["cusp_area"].is_null()
                             ? Json("0.05")
                             : Json(std::to_string(std::ldexp(1.0, random.below(16) - 8)));
    break;
  default:
    face["face"] = (face["face"].get<int>() + 1 + random.below(3)) % 4;
  }
  return certificate;
}

} // namespace

TEST_CASE("cells of two and three tetrahedra are proved by the checker", "[checker]") {
  for (const int tets : {2, 3})
    for (const catalogue::Manifold& m : catalogue::stored_table(tets)) {
      CAPTURE(m.name);
      compare_walls(with_certificate(m.signature), m.name);
    }
}

TEST_CASE("cells of cusped manifolds are proved by the checker", "[checker]") {
  // Every third of those in snappea_volumes.txt; Klein bottles too.
  std::ifstream lines(TETRARCH_SOURCE_DIR "/tests/oracle/snappea_volumes.txt");
  int count = 0;
  int proved = 0;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#') || ++number % 3 != 0) continue;
    CAPTURE(line);
    const workshop::Cells cells = with_certificate(line.substr(0, line.find('|')));
    REQUIRE(cells.canonical);
    ++count;
    CHECK(cells.certificate.empty() == !cells.canonical->proof.certified);
    if (cells.certificate.empty()) continue;
    ++proved;
    compare_walls(cells, line);
  }
  CHECK(count == 100);
  CHECK(proved >= 95);
}

TEST_CASE("what the checker cannot prove flat it says it has not checked", "[checker]") {
  // The criteria as in tests/canonical/certify_test.cpp. An octahedron of four tetrahedra has four faces
  // inside, and two pyramids have one each.
  const std::vector<std::tuple<const char*, const char*, int>> known{
      {"eLAkbccddemoen", "R", 4}, {"eLMkbbddddqadq", "F", 4}, {"eLAkccbdddejdj", "R", 2}};
  for (const auto& [signature, criterion, faces] : known) {
    CAPTURE(signature);
    const checker::Report report = checker::check(with_certificate(signature).certificate, signature);
    REQUIRE(report.accepted);
    CHECK(report.unchecked == std::map<std::string, int>{{criterion, faces}});
  }
}

TEST_CASE("false claims of cells are refused", "[checker]") {
  support::Random random(200);
  std::vector<std::pair<std::string, Json>> list;
  for (const char* signature :
       {"cPcbbbihq", "cPcbbbiht", "eLAkbccddemoen", "eLMkbbddddqadq", "dLQbcccdero", "eLPkbdcddhgggb"}) {
    const workshop::Cells cells = with_certificate(signature);
    REQUIRE_FALSE(cells.certificate.empty());
    list.emplace_back(signature, Json::parse(cells.certificate));
    REQUIRE(are_true_claims(list.back().second, cells.canonical->triangulation));
  }
  std::array<int, 2> seen{};
  for (int k = 0; k < 240; ++k) {
    const auto& [signature, whole] = list[k % list.size()];
    const Json damaged = with_other_cells(whole, random);
    CAPTURE(signature, damaged.dump());
    const bool accepted = accepts(damaged);
    ++seen[accepted ? 1 : 0];
    if (accepted) CHECK(are_true_claims(damaged, with_certificate(signature).canonical->triangulation));
  }
  CHECK(seen[0] > 150);
  CHECK(seen[1] > 0); // areas that do not matter, and a face named by its other side
}

TEST_CASE("concave faces are not walls", "[checker]") {
  // After a 2-3 move on a convex face the three new faces are concave.
  int tried = 0;
  for (const catalogue::Manifold& m : catalogue::stored_table(3)) {
    const workshop::Cells cells = with_certificate(m.signature);
    const auto ball = moves::two_three_ball(cells.canonical->triangulation, {0, 0});
    if (!std::holds_alternative<moves::Ball>(ball)) continue;
    const Triangulation other =
        moves::replace(cells.canonical->triangulation, std::get<moves::Ball>(ball)).tri;
    const support::Certified c(signature(other));
    if (!c.result.proof) continue;
    CAPTURE(m.name);
    const verified::CellClaims all_walls{"0.05", std::vector<std::array<std::string, 4>>(c.tri.size())};
    const checker::Report report =
        checker::check(verified::certificate(c.tri, c.skeleton, *c.result.proof, all_walls), m.name);
    CHECK_FALSE(report.accepted);
    CHECK(report.why_not.find("not proved to be convex") != std::string::npos);
    ++tried;
  }
  CHECK(tried > 10);
}

TEST_CASE("cells of a large cusp are others", "[checker]") {
  // With geodesic boundary a cusp's cells depend on its area. Doubles tell by another route where they
  // change.
  int changes = 0;
  for (const catalogue::Manifold& m : catalogue::stored_table(3)) {
    if (m.cusps == 0) continue;
    CAPTURE(m.name);
    const workshop::Cells cells = with_certificate(m.signature);
    const Json whole = Json::parse(cells.certificate);
    const auto at = [&whole](double area) {
      Json other = whole;
      other["cells"]["cusp_area"] = std::to_string(area);
      return other;
    };
    double low = 0.05;
    double high = 1000;
    if (are_true_claims(at(high), cells.canonical->triangulation)) continue;
    while (high - low > 1e-4 * high)
      (are_true_claims(at((low + high) / 2), cells.canonical->triangulation) ? low : high) = (low + high) / 2;
    CHECK(accepts(at(0.999 * low)));
    CHECK_FALSE(accepts(at(1.001 * high)));
    ++changes;
  }
  CHECK(changes > 0);
}

TEST_CASE("each face is named once", "[checker]") {
  const Json good = Json::parse(with_certificate("cPcbbbihq").certificate);
  Json twice = good;
  twice["cells"]["faces"].push_back(good["cells"]["faces"][1]);
  CHECK(report_of(twice).why_not.find("named twice") != std::string::npos);
  Json never = good;
  never["cells"]["faces"].erase(1);
  CHECK(report_of(never).why_not.find("nothing is claimed") != std::string::npos);
}

TEST_CASE("cells that are none are no certificate", "[checker]") {
  const Json good = Json::parse(with_certificate("cPcbbbiht").certificate);
  REQUIRE(accepts(good));
  for (const auto& [pointer, value] :
       std::vector<std::pair<std::string, Json>>{{"/cells", nullptr},
                                                 {"/cells", Json::object()},
                                                 {"/cells/more", 1},
                                                 {"/cells/cusp_area", 0.05},
                                                 {"/cells/cusp_area", "0"},
                                                 {"/cells/cusp_area", "0.0e5"},
                                                 {"/cells/cusp_area", "-1"},
                                                 {"/cells/cusp_area", "x"},
                                                 {"/cells/faces", 3},
                                                 {"/cells/faces/0", nullptr},
                                                 {"/cells/faces/0/face", 4},
                                                 {"/cells/faces/0/tetrahedron", 2},
                                                 {"/cells/faces/0/flat", "X"},
                                                 {"/cells/faces/0/flat", 1}}) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    CAPTURE(pointer, value.dump());
    CHECK_THROWS_AS(report_of(bad), InputError);
  }
  Json without = good;
  without["cells"]["cusp_area"] = nullptr; // and yet it has a cusp
  CHECK_FALSE(accepts(without));
}

TEST_CASE("cells of four tetrahedra are proved by the checker", "[checker][slow]") {
  int count = 0;
  int with_flat = 0;
  for (const catalogue::Manifold& m : catalogue::classify_manifolds(4, 2).manifolds) {
    CAPTURE(m.signature);
    const workshop::Cells cells = with_certificate(m.signature);
    REQUIRE_FALSE(cells.certificate.empty());
    compare_walls(cells, m.signature);
    ++count;
    with_flat += cells.canonical->has_flat_faces ? 1 : 0;
  }
  CHECK(count == 5033);   // Frigerio, Martelli, Petronio 2004
  CHECK(with_flat == 84); // as canonical/certify.hpp counts them
}
