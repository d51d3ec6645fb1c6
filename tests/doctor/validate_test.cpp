// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/validate.hpp"

#include "support/random.hpp"
#include "support/soups.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/format/tetgen.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>
#include <limits>
#include <map>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::support::soups;
using support::error_of;

namespace {

using Tetrahedra = std::vector<std::array<int, 4>>;
using Points = std::vector<std::array<double, 3>>;
using Counts = std::map<std::string, int>;

/// The kinds that were found, and how often.
std::map<std::string, int> counts(const Report& report) {
  std::map<std::string, int> found;
  for (int k = 0; k < kind_count; ++k)
    if (report.counts[static_cast<std::size_t>(k)] > 0)
      found[std::string(name_of(static_cast<Kind>(k)))] =
          static_cast<int>(report.counts[static_cast<std::size_t>(k)]);
  return found;
}

Report report_of(const Points& points, const Tetrahedra& tetrahedra) {
  return validate(soup_of(points, tetrahedra));
}

/// n points in general position, on the moment curve.
Points curve(int n) {
  Points points;
  for (double t = 0; t < n; ++t) points.push_back({t, t * t, t * t * t});
  return points;
}

/// Whether `of` contains all of `vertices`.
bool contains(const std::array<int, 4>& of, const std::vector<int>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return std::find(of.begin(), of.end(), v) != of.end(); });
}

/// The tetrahedra that contain `vertices`, in pieces connected through faces that contain them too.
int pieces_around(const Tetrahedra& all, const std::vector<int>& vertices) {
  Tetrahedra open;
  std::copy_if(all.begin(), all.end(), std::back_inserter(open),
               [&](const auto& t) { return contains(t, vertices); });
  int pieces = 0;
  while (!open.empty()) {
    ++pieces;
    Tetrahedra piece{open.back()};
    open.pop_back();
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (std::size_t k = open.size(); k-- > 0;) {
        const auto common =
            std::count_if(open[k].begin(), open[k].end(), [&](int v) { return contains(piece[i], {v}); });
        if (common < 3) continue;
        piece.push_back(open[k]);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
      }
  }
  return pieces;
}

/// The second route: pairs and triples of points are gone through one by one.
Counts naive_counts(const Tetrahedra& all, int points) {
  Counts found;
  const auto times = [&](const std::vector<int>& vertices) {
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [&](const auto& t) { return contains(t, vertices); }));
  };
  for (int a = 0; a < points; ++a)
    for (int b = a + 1; b < points; ++b)
      for (int c = b + 1; c < points; ++c)
        if (times({a, b, c}) > 2) ++found["face_shared"];
  if (!found.empty()) return found;
  for (int a = 0; a < points; ++a) {
    int corners = 0;
    int sides = 0;
    int free_sides = 0;
    bool bad_edge = false;
    for (int b = 0; b < points; ++b) {
      if (b == a || times({a, b}) == 0) continue;
      ++corners;
      const bool bad = pieces_around(all, {a, b}) > 1;
      bad_edge = bad_edge || bad;
      if (bad && a < b) ++found["non_manifold_edge"];
      for (int c = b + 1; c < points; ++c) {
        if (c == a) continue;
        sides += times({a, b, c}) > 0;
        free_sides += times({a, b, c}) == 1;
      }
    }
    if (times({a}) == 0 || bad_edge) continue;
    const int euler = corners - sides + times({a});
    if (pieces_around(all, {a}) > 1 || euler != (free_sides > 0 ? 1 : 2)) ++found["non_manifold_vertex"];
  }
  return found;
}

/// The tetrahedron with its last two vertices exchanged.
std::array<int, 4> turned(std::array<int, 4> t) {
  std::swap(t[2], t[3]);
  return t;
}

} // namespace

TEST_CASE("what is no manifold is found as by going through all faces, edges and vertices", "[validate]") {
  support::Random random(11);
  std::map<std::string, int> seen;
  for (int round = 0; round < 3000; ++round) {
    const int points = 4 + random.below(4);
    std::map<std::array<int, 4>, int> different;
    for (int k = 1 + random.below(7); k > 0; --k) {
      std::vector<int> order(static_cast<std::size_t>(points));
      for (int v = 0; v < points; ++v) order[static_cast<std::size_t>(v)] = v;
      random.shuffle(order);
      std::sort(order.begin(), order.begin() + 4);
      different[{order[0], order[1], order[2], order[3]}] = 1;
    }
    Tetrahedra tetrahedra;
    for (const auto& [tetrahedron, one] : different) tetrahedra.push_back(tetrahedron);
    Counts found = counts(report_of(curve(points), tetrahedra));
    for (const char* other : {"inverted", "folded", "unused_vertex", "several_components"})
      found.erase(other);
    REQUIRE(found == naive_counts(tetrahedra, points));
    for (const auto& [kind, count] : found) seen[kind] += count;
    seen["none"] += found.empty();
  }
  for (const char* kind : {"face_shared", "non_manifold_edge", "non_manifold_vertex", "none"})
    CHECK(seen[kind] > 50);
}

// All counts from here on are by hand.

TEST_CASE("a good mesh has no findings", "[validate]") {
  Tetrahedra cube = cube_tetrahedra();
  for (std::size_t t = 3; t < 6; ++t) cube[t] = turned(cube[t]);
  CHECK(counts(report_of(cube_points(), cube)).empty());
  CHECK(counts(report_of(curve(4), {{0, 1, 2, 3}})).empty());
}

TEST_CASE("faults of single tetrahedra and points", "[validate]") {
  const Report report =
      report_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}, {1, 1, 0}},
                {{0, 1, 2, 3}, {0, 1, 2, 7}, {-1, 1, 2, 9}, {0, 1, 1, 3}, {0, 2, 1, 3}, {0, 1, 2, 5}});
  CHECK(counts(report) == Counts{{"index_out_of_range", 2},
                                 {"repeated_vertex", 1},
                                 {"duplicate", 1},
                                 {"flat", 1},
                                 {"inverted", 1},
                                 {"unused_vertex", 1}});
  REQUIRE(report.findings.size() == 7);
  CHECK(report.findings[0].text == "tetrahedron 2 names vertex 8, which is none of the 6 there are");
  CHECK(report.findings[0].line == 14); // 3 lines, 1 + 6 of vertices, "Tetrahedra", their number, the second
  CHECK(report.findings[1].text == "tetrahedron 3 names vertex 0, which is none of the 6 there are");
  CHECK(report.findings[2].text == "tetrahedron 4 names vertex 2 twice");
  CHECK(report.findings[3].text == "tetrahedron 5 has the same vertices as tetrahedron 1");
  CHECK(report.findings[4].text == "tetrahedron 5 has negative volume");
  CHECK(report.findings[5].text == "tetrahedron 6 is flat");
  CHECK(report.findings[6].text == "vertex 5 is in no tetrahedron");
  CHECK(report.findings[6].number == 5);
  CHECK(report.count(Severity::fatal) == 3);
  CHECK(report.count(Severity::repairable) == 3);
}

TEST_CASE("coordinates that are no numbers", "[validate]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Report report = report_of({{0, 0, 0}, {1, -infinity, 0}, {0, 1, nan}, {0, 0, 1}}, {{0, 1, 2, 3}});
  CHECK(counts(report) == Counts{{"not_finite", 2}});
  CHECK(report.findings[0].text == "coordinate y of vertex 2 is -inf, expected a finite number");
  CHECK(report.findings[1].text == "coordinate z of vertex 3 is nan, expected a finite number");
}

TEST_CASE("no tetrahedra", "[validate]") {
  CHECK(counts(report_of({}, {})) == Counts{{"no_tetrahedra", 1}});
  const format::Soup surface = soup_of(cube_points(), {}, cube_surface());
  CHECK(counts(validate(surface)) == Counts{{"no_tetrahedra", 1}});
  CHECK(validate(surface).findings[0].text == "the mesh has no tetrahedra");
  CHECK(validate(soup_of(cube_points(), {}, {})).findings[0].text ==
        "there are points only: no triangles and no tetrahedra");
  CHECK(repair(surface).soup.triangles == surface.triangles);
}

TEST_CASE("a face of three tetrahedra", "[validate]") {
  const Report report = report_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}},
                                  {{0, 1, 2, 5}, {0, 1, 2, 3}, {0, 1, 2, 4}});
  CHECK(counts(report) == Counts{{"face_shared", 1}});
  CHECK(report.findings[0].text ==
        "the face on vertices 1, 2, 3 is shared by 3 tetrahedra, among them 1, 2, 3");
  CHECK(report.findings[0].number == 3);
}

TEST_CASE("a face of two tetrahedra and a copy of one is no face of three", "[validate]") {
  CHECK(counts(report_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                         {{0, 1, 2, 3}, {1, 0, 2, 4}, {1, 2, 0, 3}})) == Counts{{"duplicate", 1}});
}

TEST_CASE("two tetrahedra that meet in an edge", "[validate]") {
  const Report report = report_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                  {{0, 2, 3, 1}, {0, 4, 5, 1}});
  CHECK(counts(report) == Counts{{"non_manifold_edge", 1}, {"several_components", 1}});
  CHECK(report.findings[0].text == "the tetrahedra around the edge on vertices 1, 2 fall apart into 2 fans, "
                                   "among them those of tetrahedron 1 and 2");
}

TEST_CASE("two tetrahedra that meet in a vertex", "[validate]") {
  const Report report =
      report_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                {{0, 1, 2, 3}, {0, 5, 4, 6}});
  CHECK(counts(report) == Counts{{"non_manifold_vertex", 1}, {"several_components", 1}});
  CHECK(report.findings[0].text == "the tetrahedra around vertex 1 fall apart into 2 pieces");
  CHECK(report.findings[0].line == 5);
}

TEST_CASE("the cone over a ring is no manifold at its tip", "[validate]") {
  // Six points, two each on three rays, make a ring of six triangles around the hole in the middle; the
  // cone's tip has that ring as its link, and nothing else is wrong.
  Points points{{0, 0, 5}};
  for (const double r : {1.0, 2.0})
    for (const std::array<double, 2> ray : {std::array{0.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}})
      points.push_back({r * ray[0], r * ray[1], 0});
  Tetrahedra cone;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    cone.push_back({0, 1 + k, 1 + next, 4 + k});
    cone.push_back({0, 1 + next, 4 + next, 4 + k});
  }
  const Report report = validate(repair(soup_of(points, cone)).soup);
  CHECK(counts(report) == Counts{{"non_manifold_vertex", 1}});
  CHECK(report.findings[0].text.find("the link of vertex 1 is a surface of type ") == 0);
}

TEST_CASE("inverted tetrahedra of a cube", "[validate]") {
  // The odd orders of the axes; a mesh is made all the same.
  const Report report = report_of(cube_points(), cube_tetrahedra());
  CHECK(counts(report) == Counts{{"inverted", 3}});
  CHECK(build(soup_of(cube_points(), cube_tetrahedra())).tetrahedra.size() == 6);
}

TEST_CASE("of each kind only so many are listed", "[validate]") {
  const Report report = validate(soup_of(cube_points(), cube_tetrahedra()), 2);
  CHECK(report.findings.size() == 2);
  CHECK(report.count(Kind::inverted) == 3);
}

TEST_CASE("a soup that was made and not read is counted from zero", "[validate]") {
  format::Soup soup;
  soup.points = curve(5);
  soup.points.push_back(soup.points[0]);
  soup.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 6}, {0, 1, 2, 3}};
  const Report report = validate(soup);
  CHECK(report.findings.at(0).text == "tetrahedron 1 names vertex 6, which is none of the 6 there are");
  CHECK(report.findings.at(0).line == 0);
  CHECK(report.findings.at(1).text == "tetrahedron 2 has the same vertices as tetrahedron 0");
  soup.tetrahedra.erase(soup.tetrahedra.begin() + 1);
  const format::Soup repaired = repair(soup).soup;
  CHECK(repaired.tetrahedra.size() == 1);
  CHECK(repaired.points.size() == 4);
  CHECK(repaired.point_labels.numbers[3] == 3);
}

TEST_CASE("build names the first fatal finding and counts the others", "[validate]") {
  CHECK(error_of([] {
          build(soup_of(curve(4), {{0, 1, 2, 3}, {0, 1, 1, 3}, {0, 1, 2, 9}, {0, 1, 2, 8}}));
        }) == "f:13: tetrahedron 3 names vertex 10, which is none of the 4 there are (and 2 more)");
  CHECK(error_of([] {
          build(soup_of(curve(4), {{0, 1, 2, 3}, {1, 0, 2, 3}}));
        }) == "f:12: tetrahedron 2 has the same vertices as tetrahedron 1");
  // Of TetGen's two files, that of the points.
  const std::string message = error_of([] {
    build(format::read_tetgen(
        {"4 3 0 0\n0 0 0 0\n1 nan 0 0\n2 0 1 0\n3 0 0 1\n", "1 4 0\n0 0 1 2 3\n", "n", "e"}));
  });
  CHECK(message == "n:3: coordinate x of vertex 1 is nan, expected a finite number");
}

TEST_CASE("repair mends what it can, and says so", "[repair]") {
  Points points = cube_points();
  points.insert(points.begin() + 3, {5, 5, 5}); // unused: the indices after it grow by one
  Tetrahedra cube = cube_tetrahedra();
  for (auto& t : cube)
    for (int& v : t) v += v >= 3;
  cube.insert(cube.begin() + 2, cube[0]);
  const Repaired result = repair(soup_of(points, cube, {{0, 1, 4}}));
  CHECK(result.done ==
        std::vector<std::string>{"removed 1 duplicate tetrahedra",
                                 "turned round 3 tetrahedra, as the larger volume of their component says",
                                 "removed 1 unused vertices"});
  CHECK(counts(validate(result.soup)).empty());
  CHECK(result.soup.points == cube_points());
  CHECK(result.soup.triangles == std::vector<std::array<int, 3>>{{0, 1, 3}});
  CHECK(result.soup.point_labels.numbers[3] == 5); // as in the file
  CHECK(result.soup.tetrahedron_labels.numbers[2] == 4);
  CHECK(repair(result.soup).done.empty());
  // An index out of range stays out of range.
  const Repaired unmended = repair(soup_of(points, {{0, 1, 2, 9}}));
  CHECK(unmended.done.empty());
  CHECK(validate(unmended.soup).count(Kind::index_out_of_range) == 1);
}
