// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/doctor/validate_surface.hpp"

#include "support/surface_soups.hpp"
#include "tetrarch/doctor/repair.hpp"
#include "tetrarch/format/surface_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

using namespace tetrarch;
using namespace tetrarch::doctor;
using namespace tetrarch::support::soups;

namespace {

Report report_of(const Points& points, const Triangles& triangles) {
  return validate_surface(surface_soup(points, triangles));
}

bool names(const Triangle& t, int v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}
/// +1 or -1 if the triangle runs from a to b or from b to a, else 0.
int direction(const Triangle& t, int a, int b) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (t[c] == a && t[(c + 1) % 3] == b) return 1;
    if (t[c] == b && t[(c + 1) % 3] == a) return -1;
  }
  return 0;
}

/// Numbers of triangles, in groups connected by what `adjacent(i, k)` says.
template <class Adjacent>
std::vector<std::vector<int>> groups(std::vector<int> open, Adjacent adjacent) {
  std::vector<std::vector<int>> found;
  while (!open.empty()) {
    std::vector<int> group{open.back()};
    open.pop_back();
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t k = open.size(); k-- > 0;) {
        if (!adjacent(group[i], open[k])) continue;
        group.push_back(open[k]);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
      }
    found.push_back(group);
  }
  return found;
}

/// The second route: pairs of points and choices of orientation are gone through one by one.
class Naive {
public:
  Naive(const Triangles& all, int points) : all_(all), points_(points) {
    for (int t = 0; t < static_cast<int>(all.size()); ++t) everything_.push_back(t);
  }

  Counts counts() const {
    Counts found;
    for (int a = 0; a < points_; ++a) {
      bool bad = false;
      for (int b = 0; b < points_; ++b) {
        bad = bad || times(a, b) > 2;
        if (a < b && times(a, b) > 2) ++found["non_manifold_edge"];
      }
      std::vector<int> star;
      for (const int t : everything_)
        if (names(all_[t], a)) star.push_back(t);
      const auto around = [&](int i, int k) {
        return shares(i, k, [&](int b, int c) { return b == a || c == a; });
      };
      if (!bad && groups(star, around).size() > 1) ++found["non_manifold_vertex"];
      if (star.empty()) ++found["unused_vertex"];
    }
    const auto any = [](int, int) { return true; };
    if (groups(everything_, [&](int i, int k) { return shares(i, k, any); }).size() > 1)
      ++found["several_components"];
    const auto of_two = [&](int a, int b) { return times(a, b) == 2; };
    for (const auto& part : groups(everything_, [&](int i, int k) { return shares(i, k, of_two); })) {
      const int flips = fewest_flips(part);
      if (flips < 0) ++found["not_orientable"];
      if (flips > 0) found["turned"] += flips;
    }
    return found;
  }

private:
  int times(int a, int b) const {
    return static_cast<int>(
        std::count_if(all_.begin(), all_.end(), [&](const auto& t) { return direction(t, a, b) != 0; }));
  }
  template <class Which>
  bool shares(int i, int k, Which which) const {
    for (int a = 0; a < points_; ++a)
      for (int b = a + 1; b < points_; ++b)
        if (which(a, b) && direction(all_[i], a, b) != 0 && direction(all_[k], a, b) != 0) return true;
    return false;
  }
  /// -1: no choice makes the part oriented.
  int fewest_flips(const std::vector<int>& part) const {
    int fewest = -1;
    for (unsigned choice = 0; choice < 1U << part.size(); ++choice) {
      bool good = true;
      for (int a = 0; a < points_; ++a)
        for (int b = a + 1; b < points_; ++b) {
          int sum = 0;
          int sides = 0;
          for (std::size_t k = 0; k < part.size(); ++k) {
            const int way = direction(all_[part[k]], a, b);
            sides += way != 0;
            sum += (choice >> k & 1U) != 0 ? -way : way;
          }
          good = good && (times(a, b) != 2 || sides != 2 || sum == 0);
        }
      const int flips = __builtin_popcount(choice);
      if (good && (fewest < 0 || flips < fewest)) fewest = flips;
    }
    return fewest;
  }

  const Triangles& all_;
  int points_;
  std::vector<int> everything_;
};

} // namespace

TEST_CASE("faults of surfaces are found as by going through all edges and orientations",
          "[validate_surface]") {
  support::Random random(7);
  Counts seen;
  for (int round = 0; round < 3000; ++round) {
    const int points = 4 + random.below(4);
    std::set<Triangle> different;
    for (int k = 1 + random.below(8); k > 0; --k) {
      std::vector<int> order(static_cast<std::size_t>(points));
      for (int v = 0; v < points; ++v) order[v] = v;
      random.shuffle(order);
      std::sort(order.begin(), order.begin() + 3);
      different.insert({order[0], order[1], order[2]});
    }
    // Some of them whole bands without orientation, which chance alone seldom makes.
    if (points == 7 && random.below(2) == 0)
      for (Triangle t : support::with_holes(support::projective_plane(), 1).triangles) {
        std::sort(t.begin(), t.end());
        different.insert(t);
      }
    Triangles triangles(different.begin(), different.end());
    for (Triangle& t : triangles)
      if (random.below(2) == 0) t = turned(t);
    const Counts found = counts_in(report_of(curve(points), triangles));
    REQUIRE(found == Naive(triangles, points).counts());
    for (const auto& [kind, count] : found) seen[kind] += count;
    seen["none"] += found.empty();
  }
  for (const char* kind : {"non_manifold_edge", "non_manifold_vertex", "turned", "not_orientable",
                           "several_components", "unused_vertex", "none"}) {
    INFO(kind);
    CHECK(seen[kind] > 50);
  }
}

TEST_CASE("good surfaces have no findings", "[validate_surface]") {
  for (const auto& list : {support::cube_surface(), support::icosphere(2), support::torus_grid(5, 4),
                           support::with_holes(support::torus_grid(9, 9), 3)})
    CHECK(counts_in(validate_surface(surface_soup(list))).empty());
  // That it is not orientable is no fault.
  for (const auto& list : {support::projective_plane(), support::klein_grid(5, 4),
                           support::with_holes(support::projective_plane(), 1)}) {
    const Report report = validate_surface(surface_soup(list));
    CHECK(counts_in(report) == Counts{{"not_orientable", 1}});
    CHECK(report.findings[0].text == "the component of triangle 1 is not orientable");
    CHECK(report.count(Severity::remark) == 1);
  }
}

// All counts from here on are by hand.

TEST_CASE("faults of single triangles and points", "[validate_surface]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Report report = report_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, nan}, {2, 0, 0}, {9, 9, 9}},
                                  {{0, 1, 2}, {0, 1, 6}, {2, 2, 1}, {2, 0, 1}, {1, 0, 4}});
  CHECK(counts_in(report) == Counts{{"not_finite", 1},
                                    {"index_out_of_range", 1},
                                    {"degenerate", 1},
                                    {"duplicate", 1},
                                    {"flat", 1},
                                    {"unused_vertex", 2}});
  const auto& findings = report.findings;
  REQUIRE(findings.size() == 7);
  CHECK(findings[0].text == "coordinate z of vertex 4 is nan, expected a finite number");
  CHECK(findings[0].line == 8);
  CHECK(findings[1].text == "triangle 2 names vertex 7, which is none of the 6 there are");
  CHECK(findings[1].line == 14);
  CHECK(findings[2].text == "triangle 3 names vertex 3 twice");
  CHECK(findings[3].text == "triangle 4 has the same vertices as triangle 1");
  CHECK(findings[4].text == "triangle 5 has no area");
  CHECK(findings[5].text == "vertex 4 is in no triangle");
  CHECK(report.count(Severity::fatal) == 2);
  CHECK(report.count(Severity::repairable) == 4);
}

TEST_CASE("places are those of the file", "[validate_surface]") {
  const format::Soup soup = format::read_obj(
      "v 0 0 0\nv 1 0 0\n# two of four\nv 0 1 0\n\nv 1 1 0\nf 1 2 3\n\nf 2 3 4\nf 4 4 1\n", "f");
  const Report report = validate_surface(soup);
  CHECK(counts_in(report) == Counts{{"degenerate", 1}, {"turned", 1}});
  CHECK(place_of(report.findings[0], soup).line == 10);
  CHECK(place_of(report.findings[1], soup).line == 9);
  CHECK(report.findings[1].text ==
        "triangle 2 is turned against its neighbor 1 at the edge on vertices 2, 3");
}

TEST_CASE("no triangles", "[validate_surface]") {
  CHECK(counts_in(report_of({}, {})) == Counts{{"no_triangles", 1}});
  CHECK(counts_in(report_of(curve(4), {})) == Counts{{"no_triangles", 1}});
  CHECK(counts_in(report_of(curve(4), {{0, 1, 1}})) == Counts{{"no_triangles", 1}, {"degenerate", 1}});
  // Where an index is wrong, that is what is to be said.
  CHECK(counts_in(report_of(curve(3), {{0, 1, 2}, {0, 1, 7}})) == Counts{{"index_out_of_range", 1}});
  CHECK(counts_in(report_of(curve(3), {{0, 1, 7}})) ==
        Counts{{"index_out_of_range", 1}, {"unused_vertex", 1}});
}

TEST_CASE("an edge of three triangles", "[validate_surface]") {
  const Report report = report_of(curve(5), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  CHECK(counts_in(report) == Counts{{"non_manifold_edge", 1}});
  CHECK(report.findings[0].text == "the edge on vertices 1, 2 is shared by 3 triangles, among them 1, 2, 3");
  CHECK(report.findings[0].number == 3);
}

TEST_CASE("an edge of two triangles and a copy of one is no edge of three", "[validate_surface]") {
  CHECK(counts_in(report_of(curve(4), {{0, 1, 2}, {1, 0, 3}, {2, 1, 0}})) == Counts{{"duplicate", 1}});
}

TEST_CASE("two triangles that run along their edge together are turned, and the edge is good",
          "[validate_surface]") {
  CHECK(counts_in(report_of(curve(4), {{0, 1, 2}, {0, 1, 3}})) == Counts{{"turned", 1}});
}

TEST_CASE("fans that meet in a vertex", "[validate_surface]") {
  const Report report = report_of(curve(5), {{0, 1, 2}, {0, 3, 4}});
  CHECK(counts_in(report) == Counts{{"non_manifold_vertex", 1}, {"several_components", 1}});
  CHECK(report.findings[0].text ==
        "the triangles around vertex 1 fall apart into 2 fans, among them those of triangle 1 and 2");
  CHECK(report.findings[0].line == 5);
  CHECK(report.findings[1].text ==
        "the surface falls apart into 2 components: triangle 2 is not connected with triangle 1");
  CHECK(report.findings[1].number == 2);
}

TEST_CASE("the fewest triangles are called turned, those at the edge of their patch first",
          "[validate_surface]") {
  // On a torus of 128 triangles of degree six, turned are the star of a vertex and all that touch it.
  support::TriangleList torus = support::torus_grid(8, 8);
  const int centre = 3 * 8 + 3;
  std::set<int> patch;
  for (const Triangle& t : torus.triangles)
    if (names(t, centre)) patch.insert(t.begin(), t.end());
  int inside = 0;
  int total = 0;
  for (Triangle& t : torus.triangles) {
    if (std::none_of(t.begin(), t.end(), [&](int v) { return patch.count(v) > 0; })) continue;
    inside += names(t, centre);
    ++total;
    t = turned(t);
  }
  CHECK(inside == 6);
  CHECK(total == 24); // of a hexagon: 6 in it, 6 at its sides, 2 more at each corner
  const Report report = validate_surface(surface_soup(torus), 1000);
  CHECK(counts_in(report) == Counts{{"turned", total}});
  const auto first_inside =
      std::find_if(report.findings.begin(), report.findings.end(), [](const Finding& f) {
        return f.text == "triangle " + std::to_string(f.number) + " is turned, and its neighbors with it";
      });
  CHECK(first_inside - report.findings.begin() == 12); // those at the corners
  for (auto f = report.findings.begin(); f != report.findings.end(); ++f)
    CHECK((f->text.find(" is turned against its neighbor ") != std::string::npos) == (f < first_inside));
  // Of two halves, the one with the first triangle is right.
  const Report halves = report_of(curve(4), {{0, 1, 2}, {0, 1, 3}});
  CHECK(halves.findings.at(0).number == 2);
}

TEST_CASE("each component has its own orientation", "[validate_surface]") {
  Triangles two = support::tetrahedron_surface().triangles;
  for (const Triangle& t : support::tetrahedron_surface().triangles)
    two.push_back(turned({t[0] + 4, t[1] + 4, t[2] + 4}));
  CHECK(counts_in(report_of(curve(8), two)) == Counts{{"several_components", 1}});
  two.front() = turned(two.front());
  two.back() = turned(two.back());
  CHECK(counts_in(report_of(curve(8), two)) == Counts{{"several_components", 1}, {"turned", 2}});
}

TEST_CASE("whether a triangle is flat is decided exactly", "[validate_surface]") {
  const auto is_flat = [](const std::array<double, 3>& c) {
    return report_of({{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, c}, {{0, 1, 2}}).count(Kind::flat) == 1;
  };
  for (const double x : {0.1, 0.3, 1e-300, -1e300}) {
    CHECK(is_flat({x, x, x})); // on the diagonal
    const double next = std::nextafter(x, 1.0);
    CHECK_FALSE(is_flat({next, x, x}));
    CHECK_FALSE(is_flat({x, next, x}));
    CHECK_FALSE(is_flat({x, x, next}));
  }
  // In the planes of two axes.
  for (int axis = 0; axis < 3; ++axis) {
    Points points{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}};
    for (auto& p : points) std::rotate(p.begin(), p.begin() + axis, p.end());
    CHECK(counts_in(report_of(points, {{0, 1, 2}})).empty());
  }
}

TEST_CASE("what is found does not depend on names", "[validate_surface]") {
  support::Random random(21);
  for (int round = 0; round < 60; ++round) {
    support::TriangleList list = round % 2 == 0 ? support::torus_grid(4, 4) : support::klein_grid(4, 5);
    if (list.points.empty()) list.points = curve(list.vertices);
    for (int k = random.below(6); k > 0; --k)
      list.triangles[random.below(static_cast<int>(list.triangles.size()))] = {
          random.below(list.vertices), random.below(list.vertices), random.below(list.vertices)};
    for (Triangle& t : list.triangles)
      if (random.below(8) == 0) t = turned(t);
    Counts before = counts_in(validate_surface(surface_soup(list)));
    Counts after = counts_in(validate_surface(surface_soup(support::relabelled(list, random))));
    // Of duplicates the first is kept, and with it the way that it is turned.
    if (before.count("duplicate") > 0) before["turned"] = after["turned"] = 0;
    CHECK(after == before);
  }
}

TEST_CASE("of each kind only so many surface findings are listed", "[validate_surface]") {
  format::Soup soup = surface_soup(curve(9), {{0, 1, 2}});
  const Report report = validate_surface(soup, 2);
  CHECK(report.findings.size() == 2);
  CHECK(report.count(Kind::unused_vertex) == 6);
}
