// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/text.hpp"
#include "tetrarch/scene/drawing.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <pugixml.hpp>

using namespace tetrarch;
using namespace tetrarch::scene;

namespace {

const Ink black{{}, Color{0, 0, 0, 255}, 1};
const Ink pale{Color{255, 128, 7, 51}, {}, 1};

/// The root of the document, which must be XML.
struct Svg {
  explicit Svg(const Drawing& drawing, int width = 800) : text(write_svg(drawing, width)) {
    REQUIRE(document.load_string(text.c_str()));
    root = document.child("svg");
  }
  /// All elements of a name, in order.
  std::vector<pugi::xml_node> all(const char* name) const {
    std::vector<pugi::xml_node> out;
    for (const pugi::xml_node& group : root.children("g"))
      for (const pugi::xml_node& node : group.children(name)) out.push_back(node);
    return out;
  }
  std::string text;
  pugi::xml_document document;
  pugi::xml_node root;
};

std::vector<std::array<double, 2>> points_of(const pugi::xml_node& node) {
  std::vector<std::array<double, 2>> out;
  std::string text = node.attribute("points").value();
  for (char& c : text)
    if (c == ',') c = ' ';
  format::TextCursor in(text, "points");
  while (!in.at_end()) {
    const double x = in.number("x");
    out.push_back({x, in.number("y")});
  }
  return out;
}

/// From (-2, -1) to (2, 1), 200 pixels a unit.
Drawing window() {
  Drawing drawing;
  drawing.title = "a drawing";
  drawing.lower = {-2, -1};
  drawing.upper = {2, 1};
  return drawing;
}

/// Whether the polygon winds around the point: it crosses the ray to the right an odd number of times.
bool contains(const std::vector<std::array<double, 2>>& polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& [ax, ay] = polygon[i];
    const auto& [bx, by] = polygon[(i + 1) % polygon.size()];
    if ((ay > y) != (by > y) && ax + (y - ay) / (by - ay) * (bx - ax) > x) inside = !inside;
  }
  return inside;
}

} // namespace

TEST_CASE("a drawing is in pixels with y upwards", "[scene]") {
  Drawing drawing = window();
  drawing.circles = {{{0, 0}, 0.5, black}, {{1, 0.5}, 1.0 / 3, black}};
  drawing.outlines = {{{{-2, 1}, {2, -1}}, false, black}, {{{0, 0}, {1, 0}, {0, 1}}, true, pale}};
  const Svg svg(drawing);
  CHECK(svg.root.attribute("viewBox").value() == std::string("0 0 800 400"));
  CHECK(svg.root.attribute("height").as_int() == 400);
  CHECK(svg.root.child_value("title") == drawing.title);
  REQUIRE(svg.all("circle").size() == 2);
  const pugi::xml_node circle = svg.all("circle")[1];
  CHECK(circle.attribute("cx").value() == std::string("600"));
  CHECK(circle.attribute("cy").value() == std::string("100"));
  CHECK(circle.attribute("r").value() == std::string("66.67"));
  REQUIRE(svg.all("polyline").size() == 1);
  CHECK(svg.all("polyline")[0].attribute("points").value() == std::string("0,0 800,400"));
  REQUIRE(svg.all("polygon").size() == 1);
  CHECK(svg.all("polygon")[0].attribute("points").value() == std::string("400,200 600,200 400,0"));
  const pugi::xml_node group = svg.all("polygon")[0].parent();
  CHECK(group.attribute("fill").value() == std::string("#ff8007"));
  CHECK(group.attribute("fill-opacity").value() == std::string("0.2"));
  CHECK(group.attribute("stroke").value() == std::string("none"));
}

TEST_CASE("elements of one ink share a group, and keep their order", "[scene]") {
  Drawing drawing = window();
  for (const Ink& ink : {black, black, pale, black}) drawing.circles.push_back({{0, 0}, 0.5, ink});
  drawing.outlines = {{{{0, 0}, {1, 1}}, false, black}};
  const Svg svg(drawing);
  std::vector<long> sizes;
  for (const pugi::xml_node& group : svg.root.children("g"))
    sizes.push_back(std::distance(group.begin(), group.end()));
  CHECK(sizes == std::vector<long>{2, 1, 2});
}

TEST_CASE("what is not seen is left out", "[scene]") {
  Drawing drawing = window();
  drawing.circles = {
      {{3, 0}, 0.9, black},       // beside the window
      {{0, 0}, 0.0002, black},    // 0.08 pixels across
      {{0, 0}, 5, black},         // around the window
      {{0, 0}, 1e9, black},       // far around it
      {{1e9, 0}, 1e9 - 3, black}, // beside it, large
      {{0, 0}, 0.5, Ink{}},       // without ink
  };
  drawing.outlines = {
      {{{5, 5}, {6, 6}}, false, black}, {{}, true, black}, {{{0, 0}, {1e-4, 1e-4}}, true, black}};
  const Svg svg(drawing);
  CHECK(svg.root.child("g").empty());
  CHECK(svg.root.child("title"));
  // Filled, the same circles around the window are seen, and so is a stroke that reaches into it.
  drawing.circles = {{{0, 0}, 5, pale}, {{0, 0}, 1e9, pale}, {{2.51, 0}, 0.5, Ink{{}, Color{}, 6}}};
  drawing.outlines = {{{{-2, 0}, {2, 0}}, false, black}};
  const Svg more(drawing);
  CHECK(more.all("circle").size() == 2);
  REQUIRE(more.all("polygon").size() == 1);
  const auto corners = points_of(more.all("polygon")[0]);
  for (const double x : {0, 800})
    for (const double y : {0, 400}) CHECK(contains(corners, x, y));
  CHECK(more.all("polyline").size() == 1); // flat, but long
}

TEST_CASE("a large circle is a polygon on it that covers the same part of the window", "[scene]") {
  for (const double radius : {100.0, 1e4, 1e6, 1e9})
    for (const double direction : {0.0, 1.0, 2.5, 4.0})
      for (const double depth : {-0.9, 0.0, 0.3}) {
        Drawing drawing = window();
        const std::array<double, 2> center{(radius - depth) * std::cos(direction),
                                           (radius - depth) * std::sin(direction)};
        drawing.circles = {{center, radius, Ink{Color{}, Color{}, 2}}};
        const Svg svg(drawing);
        REQUIRE(svg.all("polygon").size() == 1);
        const auto polygon = points_of(svg.all("polygon")[0]);
        CHECK(polygon.size() < 200);
        // The signed distance from the circle in pixels, positive inside; rounding at 1e9 is 1e-7 of a unit.
        const auto depth_of = [&](double x, double y) {
          return 200 * (radius - std::hypot(x / 200 - 2 - center[0], 1 - y / 200 - center[1]));
        };
        for (std::size_t i = 0; i + 3 < polygon.size(); ++i) {
          const auto& [ax, ay] = polygon[i];
          const auto& [bx, by] = polygon[i + 1];
          CHECK(std::abs(depth_of(ax, ay)) < 0.01);
          CHECK(std::abs(depth_of((ax + bx) / 2, (ay + by) / 2)) < 0.03);
        }
        for (double x = 1; x < 800; x += 57)
          for (double y = 1; y < 400; y += 57)
            if (std::abs(depth_of(x, y)) > 0.05) CHECK(contains(polygon, x, y) == (depth_of(x, y) > 0));
      }
}

TEST_CASE("titles are escaped, and far coordinates stay short", "[scene]") {
  Drawing drawing = window();
  drawing.title = "a < b & \"c\" > d\x01";
  drawing.outlines = {{{{0, 0}, {1e300, -1e-300}}, false, black}};
  const Svg svg(drawing);
  CHECK(svg.root.child_value("title") == std::string("a < b & \"c\" > d "));
  CHECK(svg.text.size() < 400);
  CHECK(svg.all("polyline")[0].attribute("points").value() == std::string("400,200 2.000000e+302,200"));
}

TEST_CASE("drawings that break their rules are refused", "[scene]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::function<void(Drawing&)>> spoils{
      [](Drawing& d) { d.upper[0] = d.lower[0]; },
      [](Drawing& d) { d.upper[1] = -5; },
      [](Drawing& d) { d.lower[1] = -inf; },
      [](Drawing& d) { d.lower[1] = nan; },
      [](Drawing& d) { d.circles[0].center[0] = nan; },
      [](Drawing& d) { d.circles[0].radius = inf; },
      [](Drawing& d) { d.circles[0].radius = -1; },
      [](Drawing& d) { d.circles[0].ink.width = nan; },
      [](Drawing& d) { d.circles[0].ink.width = -1; },
      [](Drawing& d) { d.outlines[0].points[1][1] = inf; },
      [](Drawing& d) { d.outlines[0].points[1][1] = 1e308; }, // not finite in pixels
  };
  Drawing good = window();
  good.circles = {{{0, 0}, 1, black}};
  good.outlines = {{{{0, 0}, {1, 1}}, false, black}};
  CHECK_NOTHROW(write_svg(good));
  CHECK_THROWS_AS(write_svg(good, 0), PreconditionError);
  CHECK_THROWS_AS(write_svg(good, -3), PreconditionError);
  for (std::size_t i = 0; i < spoils.size(); ++i) {
    INFO(i);
    Drawing bad = good;
    spoils[i](bad);
    CHECK_THROWS_AS(write_svg(bad), PreconditionError);
  }
}
