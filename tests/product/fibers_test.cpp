// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/fibers.hpp"

#include "product/solids.hpp"
#include "tetrarch/core/random.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/field.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tetrarch;
using namespace tetrarch::product;

namespace {

struct Case : support::Divided {
  std::vector<double> w;
};

Case make(const support::Extrusion& from) {
  Case c{support::divided(from), {}};
  c.w = harmonic_field(c.solid, c.partition).w;
  return c;
}

Location random_point(const Solid& solid, SplitMix64& random) {
  Location at{random.below(solid.size()), {}};
  double sum = 0;
  for (double& x : at.weight) sum += x = random.uniform();
  for (double& x : at.weight) x /= sum;
  return at;
}

/// The angle about the z axis.
double angle(const Point& p) {
  return std::atan2(p[1], p[0]);
}

/// In (-pi, pi].
double turn(double from, double to) {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

struct FloorRoundTrip {
  int stuck = 0;
  double inside_mean = 0; ///< distance between a vertex and where the way down and up again leads
  double wall_mean = 0;
};

FloorRoundTrip round_trip(const Case& c) {
  const FiberField field(c.solid, c.partition, c.w);
  FloorRoundTrip trip;
  std::array<int, 2> count{};
  for (int v = 0; v < static_cast<int>(c.w.size()); ++v) {
    const Fiber down = field.trace(field.at_vertex(v), Way::down);
    const Fiber up = field.trace_to(down.at, Way::up, c.w[v]);
    trip.stuck += down.end == FiberEnd::base && !down.by_gradient ? 0 : 1;
    const bool on_wall = c.solid.on_boundary[v] >= 0;
    (on_wall ? trip.wall_mean : trip.inside_mean) +=
        numeric::distance(c.solid.point(v), point_at(c.solid, up.at));
    ++count[on_wall ? 1 : 0];
  }
  trip.inside_mean /= count[0];
  trip.wall_mean /= count[1];
  return trip;
}

constexpr std::array both{Direction::gradient, Direction::smoothed};

} // namespace

TEST_CASE("The gradient of a linear function is itself", "[fibers]") {
  const Case c = make(support::bent(1, 4, 2));
  std::vector<double> f;
  for (const Point& p : c.solid.mesh.points) f.push_back(2 * p[0] - 3 * p[1] + 5 * p[2] + 7);
  for (int t = 0; t < c.solid.size(); ++t) {
    const Point g = gradient_in(c.solid, t, f);
    CHECK(g[0] == Approx(2));
    CHECK(g[1] == Approx(-3));
    CHECK(g[2] == Approx(5));
  }
}

TEST_CASE("In a plate fibres are vertical, at vertices, edges and faces, too", "[fibers]") {
  for (const double unrest : {0.0, 0.15}) {
    const support::Extrusion from = support::plate(2, 4, 3, support::Hole::round, 0.5, unrest);
    const Case c = make(from);
    for (const Direction direction : both) {
      const FiberField field(c.solid, c.partition, c.w, direction);
      for (int v = 0; v < static_cast<int>(c.w.size()); ++v)
        for (const Way way : {Way::down, Way::up}) {
          const Fiber fiber = field.trace(field.at_vertex(v), way);
          REQUIRE(fiber.end == FiberEnd::base);
          const Point p = point_at(c.solid, fiber.at);
          const Point& start = c.solid.point(v);
          REQUIRE(numeric::distance(p, {start[0], start[1], way == Way::up ? 0.5 : 0.0}) < 1e-12);
          REQUIRE(fiber.length == Approx(std::abs(p[2] - start[2])).margin(1e-12));
        }
    }
  }
}

TEST_CASE("Fibres stop at the level that was asked for", "[fibers]") {
  const Case c = make(support::cylinder(4, 5));
  const FiberField field(c.solid, c.partition, c.w);
  SplitMix64 random(1);
  for (int round = 0; round < 100; ++round) {
    const Location from = random_point(c.solid, random);
    const double w = value_at(c.solid, c.w, from);
    for (const double level : {0.25, 0.5, 0.9}) {
      const Fiber up = field.trace_to(from, Way::up, level);
      REQUIRE(up.end == FiberEnd::level);
      CHECK(value_at(c.solid, c.w, up.at) == Approx(std::max(w, level)));
      const Fiber down = field.trace_to(from, Way::down, level);
      CHECK(value_at(c.solid, c.w, down.at) == Approx(std::min(w, level)));
    }
  }
}

TEST_CASE("A path goes from start to end and is as long as the fibre", "[fibers]") {
  const Case c = make(support::bent(1, 4, 4));
  const FiberField field(c.solid, c.partition, c.w);
  SplitMix64 random(2);
  for (int round = 0; round < 50; ++round) {
    const Location from = random_point(c.solid, random);
    std::vector<Point> path{{9, 9, 9}};
    const Fiber fiber = field.trace(from, Way::up, path);
    REQUIRE(path.size() == static_cast<std::size_t>(fiber.steps) + 2);
    CHECK(path[0] == Point{9, 9, 9});
    CHECK(numeric::distance(path[1], point_at(c.solid, from)) < 1e-12);
    CHECK(numeric::distance(path.back(), point_at(c.solid, fiber.at)) < 1e-12);
    double length = 0;
    for (std::size_t k = 2; k < path.size(); ++k) length += numeric::distance(path[k - 1], path[k]);
    CHECK(fiber.length == Approx(length));
  }
}

TEST_CASE("Between cylinders smoothed fibres are radial, of better than first order", "[fibers]") {
  const auto error = [](int fine, Direction direction) {
    const Case c = make(support::radial_pipe(0.5, fine));
    const FiberField field(c.solid, c.partition, c.w, direction);
    double sum = 0;
    for (int v = 0; v < static_cast<int>(c.w.size()); ++v) {
      const Fiber fiber = field.trace(field.at_vertex(v), Way::down);
      REQUIRE(fiber.end == FiberEnd::base);
      REQUIRE_FALSE(fiber.by_gradient);
      sum += std::abs(turn(angle(c.solid.point(v)), angle(point_at(c.solid, fiber.at))));
    }
    return sum / static_cast<double>(c.w.size());
  };
  const double coarse = error(4, Direction::smoothed);
  const double fine = error(16, Direction::smoothed);
  INFO(coarse << " " << fine);
  CHECK(fine < coarse / 6);
  CHECK(error(16, Direction::gradient) > fine);
}

TEST_CASE("Fibres of different floor points do not meet", "[fibers]") {
  const Case c = make(support::radial_pipe(0.5, 6));
  const FiberField field(c.solid, c.partition, c.w);
  // Along a circle of the floor, within triangles, angles keep their order up to the ceiling.
  for (const double level : {0.3, 0.7, 1.0}) {
    std::vector<std::pair<double, double>> angles; // below, above
    for (int t = 0; t < c.solid.boundary.triangle_count(); ++t) {
      if (c.partition.patch[t] != floor_patch) continue;
      double low = 9;
      double high = -9;
      for (int k = 0; k < 3; ++k) {
        low = std::min(low, c.solid.point(c.solid.corner(t, k))[2]);
        high = std::max(high, c.solid.point(c.solid.corner(t, k))[2]);
      }
      if (low > 0.74 || high < 0.76) continue;
      for (int step = 1; step < 4; ++step) {
        const Location from = field.on_triangle(t, {0.25 * step, 0.5 - 0.125 * step, 0.5 - 0.125 * step});
        const Fiber fiber = field.trace_to(from, Way::up, level);
        REQUIRE((fiber.end == FiberEnd::level || fiber.end == FiberEnd::base));
        // Back down: the same point of the floor.
        const Fiber back = field.trace(fiber.at, Way::down);
        CHECK(numeric::distance(point_at(c.solid, from), point_at(c.solid, back.at)) < 0.002);
      }
    }
  }
}

TEST_CASE("On a wall fibres stay on the wall", "[fibers]") {
  const Case c = make(support::bent(1, 6, 5));
  for (const Direction direction : both) {
    const FiberField field(c.solid, c.partition, c.w, direction);
    SplitMix64 random(6);
    for (int t = 0; t < c.solid.boundary.triangle_count(); ++t) {
      if (c.partition.patch[t] < first_wall) continue;
      std::array<double, 3> weight{random.uniform(), random.uniform(), random.uniform()};
      const double sum = weight[0] + weight[1] + weight[2];
      for (double& x : weight) x /= sum;
      const Fiber fiber = field.trace_to(field.on_triangle(t, weight), Way::up, 0.8);
      REQUIRE((fiber.end == FiberEnd::level || fiber.end == FiberEnd::base));
      for (int k = 0; k < 4; ++k)
        if (fiber.at.weight[k] > 0) CHECK(c.solid.on_boundary[c.solid.corners(fiber.at.tet)[k]] >= 0);
    }
  }
}

TEST_CASE("Where faces have the field pointing in from both sides, fibres slide on", "[fibers]") {
  // A roof: w is the lesser of two planes' heights, so that the gradient points into the ridge from below.
  const support::Extrusion from = support::box({2, 1, 1}, {4, 2, 2}, 0);
  const Case c = make(from);
  std::vector<double> w;
  for (const Point& p : c.solid.mesh.points) w.push_back(p[2] - std::abs(p[0] - 1));
  const FiberField field(c.solid, c.partition, w, Direction::gradient);
  // Off the ridge by 0.2: up at 45 degrees, and then along the face x = 1.
  for (int t = 0; t < c.solid.size(); ++t) {
    const Location at{t, {0.25, 0.25, 0.25, 0.25}};
    const Point p = point_at(c.solid, at);
    if (p[2] > 0.5 || std::abs(p[0] - 1) > 0.3) continue;
    const Fiber fiber = field.trace_to(at, Way::up, 0.75);
    REQUIRE(fiber.end == FiberEnd::level);
    const Point q = point_at(c.solid, fiber.at);
    CHECK(q[0] == Approx(1).margin(1e-9));
    CHECK(q[2] == Approx(0.75));
    CHECK(fiber.length == Approx(std::abs(p[0] - 1) * std::sqrt(2) + 0.75 - p[2] - std::abs(p[0] - 1)));
  }
}

TEST_CASE("Smoothed vectors at walls are tangent, along ridges that point outward, free at others",
          "[fibers]") {
  // A block with a square hole through it, sheared along x the more, the higher: fibres lean, on walls x = 0
  // and y = 0 alike. Followed up and down again they come back; nothing is stuck.
  support::Extrusion from = support::plate(1, 8, 8, support::Hole::square, 1, 0);
  for (Point& p : from.mesh.points) p[0] += 0.25 * p[2] * p[2];
  const Case c = make(from);
  const FloorRoundTrip trip = round_trip(c);
  CHECK(trip.stuck == 0);
  CHECK(trip.inside_mean < 0.005);
  CHECK(trip.wall_mean < 0.035);
}

TEST_CASE("A fibre that cannot go on says where", "[fibers]") {
  // A peak at the middle of a box.
  const support::Extrusion from = support::box({2, 2, 2}, {4, 4, 4}, 0);
  const Case c = make(from);
  std::vector<double> w;
  for (const Point& p : c.solid.mesh.points) w.push_back(2 - numeric::distance(p, {1, 1, 1}));
  for (const Direction direction : both) {
    const FiberField field(c.solid, c.partition, w, direction);
    SplitMix64 random(8);
    int stuck = 0;
    for (int round = 0; round < 20; ++round) {
      Location at = random_point(c.solid, random);
      const Point p = point_at(c.solid, at);
      if (std::max({std::abs(p[0] - 1), std::abs(p[1] - 1), std::abs(p[2] - 1)}) > 0.9) continue;
      const Fiber fiber = field.trace(at, Way::up);
      if (fiber.end == FiberEnd::base) continue;
      ++stuck;
      CHECK(fiber.end == FiberEnd::stuck);
      CHECK(numeric::distance(point_at(c.solid, fiber.at), {1, 1, 1}) < 1e-9);
      CHECK(fiber.by_gradient == (direction == Direction::smoothed));
    }
    CHECK(stuck > 5);
  }
}
