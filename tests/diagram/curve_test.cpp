// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/diagram/curve.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/diagram/exterior.hpp"
#include "tetrarch/diagram/moves.hpp"
#include "tetrarch/diagram/read.hpp"
#include "tetrarch/diagram/write.hpp"
#include "tetrarch/identify/identify.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::diagram;
using namespace tetrarch::numeric;

namespace {

Curve closed_curve(int count, const std::function<Point(double)>& at) {
  Curve curve;
  for (int k = 0; k < count; ++k) {
    curve.points.push_back(at(2 * std::numbers::pi * k / count));
    curve.segments.push_back({k, (k + 1) % count});
  }
  return curve;
}

Curve both(const Curve& a, const Curve& b) {
  Curve out = a;
  const int shift = static_cast<int>(a.points.size());
  out.points.insert(out.points.end(), b.points.begin(), b.points.end());
  for (const auto& [p, q] : b.segments) out.segments.push_back({p + shift, q + shift});
  return out;
}

Curve random_polygon(int points, SplitMix64& random) {
  return closed_curve(points, [&](double) {
    return Point{random.uniform(), random.uniform(), random.uniform()};
  });
}

/// Gauss's integral for two polygons: a sum over pairs of segments of the solid angle of their differences,
/// over 4 pi. Source: Banchoff, "Self linking numbers of space polygons" (1976).
int linking_number(const Curve& a, const Curve& b) {
  double sum = 0;
  for (const auto& [i, j] : a.segments)
    for (const auto& [k, l] : b.segments) {
      const Vector p = b.points[k] - a.points[i];
      const Vector q = b.points[l] - a.points[i];
      const Vector r = b.points[l] - a.points[j];
      const Vector s = b.points[k] - a.points[j];
      const auto angle = [](const Vector& x, const Vector& y, const Vector& z) {
        return 2 * std::atan2(dot(x, cross(y, z)), norm(x) * norm(y) * norm(z) + dot(x, y) * norm(z) +
                                                       dot(y, z) * norm(x) + dot(z, x) * norm(y));
      };
      sum += angle(p, q, r) + angle(p, r, s);
    }
  return static_cast<int>(std::lround(-sum / (4 * std::numbers::pi)));
}

/// Half the sum of the signs of the crossings of two components, each walked from its first node (a point of
/// valence 2) by that node's second dart if `reverse` is false.
int linking_number(const Diagram& d) {
  const Classes component = components(d);
  REQUIRE(component.count == 2);
  std::vector<bool> leaves(static_cast<std::size_t>(d.dart_count()), false);
  std::vector<bool> done(static_cast<std::size_t>(d.dart_count()), false);
  for (int n = 0; n < d.node_count(); ++n) {
    if (d.node(n).crossing) continue;
    // The reader of curves puts a circle's point at the start of its first segment, whose dart comes first.
    for (int at = d.node(n).darts[0]; !done[at];) {
      leaves[at] = done[at] = true;
      const int end = d.opposite(at);
      done[end] = true;
      at = d.turned(end, d.at_crossing(end) ? 2 : 1);
    }
  }
  int sum = 0;
  for (const Node& node : d.nodes()) {
    if (!node.crossing || component.of[node.darts[0]] == component.of[node.darts[1]]) continue;
    const int over = leaves[node.darts[node.over]] ? node.over : node.over + 2;
    // A crossing is positive if the lower strand passes from the right to the left of the upper one.
    sum += leaves[node.darts[(over + 1) % 4]] ? 1 : -1;
  }
  return sum / 2;
}

std::string curve_refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& e) {
    return e.what();
  }
  return "done";
}

std::string refusal_of(const std::string& text) {
  return curve_refusal([&] { (void)project(read_curve(text, "test"), "test"); });
}

} // namespace

TEST_CASE("linking numbers of random polygons are those of Gauss's integral", "[curve]") {
  // Over, under, left and right are all in this number: a mirror image would change its sign.
  SplitMix64 random(5);
  int linked = 0;
  for (int round = 0; round < 60; ++round) {
    const Curve a = random_polygon(12, random);
    const Curve b = random_polygon(9, random);
    const int expected = linking_number(a, b);
    linked += expected != 0 ? 1 : 0;
    const Curve link = both(a, b);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      CHECK(linking_number(project(link, "test", {seed, 1})) == expected);
  }
  CHECK(linked > 20);
}

TEST_CASE("the view does not matter, nor does reduction", "[curve]") {
  const Curve figure_eight = closed_curve(80, [](double t) {
    return Point{(2 + std::cos(2 * t)) * std::cos(3 * t), (2 + std::cos(2 * t)) * std::sin(3 * t),
                 std::sin(4 * t)};
  });
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CHECK(identify::identify(exterior(project(figure_eight, "test", {seed, 1}))).name ==
          "figure-eight knot complement (m004)");
    const Curve shorter = reduced(figure_eight);
    CHECK(shorter.points.size() < 12);
    CHECK(identify::identify(exterior(project(shorter, "test", {seed, 1}))).name ==
          "figure-eight knot complement (m004)");
  }
}

TEST_CASE("random polygons keep their manifold under other views and reduction", "[curve]") {
  SplitMix64 random(11);
  int hyperbolic = 0;
  for (int round = 0; round < 25; ++round) {
    const Curve knot = random_polygon(24, random);
    identify::IdentifyOptions how;
    how.attempts = 50;
    const auto first = identify::identify(exterior(project(knot, "test", {1, 1})), how);
    const auto second = identify::identify(exterior(project(knot, "test", {2, 1})), how);
    const auto third = identify::identify(exterior(project(reduced(knot), "test", {3, 1})), how);
    hyperbolic += first.isometry_signature.empty() ? 0 : 1;
    CHECK(first.isometry_signature == second.isometry_signature);
    CHECK(first.isometry_signature == third.isometry_signature);
  }
  CHECK(hyperbolic > 3);
}

TEST_CASE("a graph in space", "[curve]") {
  // A tetrahedron's edges, each divided once: K4 without knots.
  const std::string k4 =
      "v 0 0 0\nv 1 0 0.1\nv 0 1 0.2\nv 0.3 0.3 1\nl 1 2\nl 1 3\nl 1 4\nl 2 3\nl 3 4 \nl 4 2\n";
  const Diagram d = project(read_curve(k4, "test"), "test");
  CHECK(vertex_count(d) == 4);
  CHECK(edges(d).count == 6);
  CHECK(components(d).count == 1);
  CHECK(crossing_count(simplified(d)) == 0);
  CHECK(looks_like_curve(k4));
}

TEST_CASE("lattice curves have straight pieces", "[curve]") {
  // A square with two points on each side, and another one through it.
  const std::string hopf = "0 0 0\n1 0 0\n2 0 0\n2 2 0\n0 2 0\n0 1 0\n\n1 1 -1\n1 1 1\n5 1 1\n5 1 -1\n";
  const Diagram d = simplified(project(read_curve(hopf, "test"), "test"));
  CHECK(components(d).count == 2);
  CHECK(crossing_count(d) == 2);
}

TEST_CASE("bad curves are refused with the place", "[curve]") {
  CHECK(refusal_of("0 0 0\n1 0 0\n") == "test:2: a closed curve has 2 points (expected three or more)");
  CHECK(refusal_of("0 0 0\n1 0 0\n0 1 nan\n") == "test:3: found 'nan', expected a finite number");
  CHECK(refusal_of("0 0 0\n1 0 0\n0 1 0\n1 2\n") == "test:4: found 2 words (expected three numbers)");
  CHECK(refusal_of("0 0 0\n1 0 0\n0 1 0\n0 0 5\n1 0 0\n") ==
        "test: points 1 and 4 coincide: the curve meets itself");
  // A bow: the segments 0-1 and 2-3 cross in a plane.
  CHECK(refusal_of("0 0 0\n1 1 0\n1 0 0\n0 1 0\n").find("meet") != std::string::npos);
  // Point 4 lies on the segment of points 0 and 1.
  CHECK(refusal_of("0 0 0\n2 0 0\n2 2 0\n1 1 1\n1 0 0\n1 1 -1\n0 2 0\n").find("meet") != std::string::npos);
  // There and back.
  CHECK(refusal_of("0 0 0\n2 0 0\n1 0 0\n1 1 1\n").find("meet") != std::string::npos);
  CHECK(refusal_of("v 0 0 0\nv 1 0 0\nl 1 3\n") ==
        "test:3: found '3', expected the number of a vertex above");
  CHECK(refusal_of("v 0 0 0\nv 1 0 0\nl 1 2\nl 2 1\n") ==
        "test: the segment of points 1 and 0 is given twice");
  CHECK(refusal_of("1e308 0 0\n-1e308 1 0\n0 0 1e308\n") != "done");
}

TEST_CASE("kinds of files of curves", "[curve]") {
  CHECK(looks_like_curve("0 0 0\n1 0 0\n0 1 0\n"));
  CHECK(looks_like_curve("3\nwater\nO 0 0 0\nH 1 0 0\nH 0 1 0\n"));
  CHECK(read_curve("3\nwater\nO 0 0 0\nH 1 0 0\nH 0 1 0\n", "test").points.size() == 3);
  CHECK(read_curve("0 0 0\n1 0 0\n0 1 0\n0 0 0\n", "test").points.size() == 3);
  CHECK_FALSE(looks_like_curve("cPcbbbiht"));
  CHECK_FALSE(looks_like_curve("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  CHECK_FALSE(looks_like_curve("1 2\n3 4\n"));
}
