// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/unfold/unfold.hpp"

#include "support/boxes.hpp"
#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::unfold;
using support::Box;
using support::Random;

namespace {

int folded(const Box& box, const std::vector<Point>& points) {
  const std::vector<double> d = determinants(box.problem.elements, points);
  return static_cast<int>(std::count_if(d.begin(), d.end(), [](double x) { return !(x > 0); }));
}

} // namespace

TEST_CASE("The energy of what is as wanted is known, and its gradient is 0 inside", "[unfold]") {
  const Box box(3);
  std::vector<Vector> gradient;
  // By hand: J is 1, so each element has 3 + theta 2, but for epsilon.
  CHECK(energy(box.problem.elements, box.points, 0.5, 1e-9, &gradient) == Approx(6 * 27 * 4.0));
  for (std::size_t v = 0; v < box.points.size(); ++v)
    if (box.problem.freedom[v].kind == Freedom::Kind::free) CHECK(numeric::norm(gradient[v]) < 1e-9);
  for (const double d : determinants(box.problem.elements, box.points)) CHECK(d == Approx(1));
  // Twice as large: tr(J'J) / D^(2/3) is 3 still, and (D^2 + 1) / D is 8 + 1/8.
  std::vector<Point> twice = box.points;
  for (Point& p : twice)
    for (double& x : p) x *= 2;
  CHECK(energy(box.problem.elements, twice, 0.5, 1e-9) == Approx(6 * 27 * (3 + 0.5 * 8.125)));
}

TEST_CASE("The gradient is that of the energy, by differences, folded or not", "[unfold]") {
  for (const double epsilon : {1.0, 0.1, 1e-3})
    for (int seed = 0; seed < 3; ++seed) {
      Box box(2);
      for (Freedom& f : box.problem.freedom) f.kind = Freedom::Kind::free;
      box.shake(epsilon < 0.01 ? 0.1 : 0.7,
                seed); // where folded and epsilon small, differences see only a cliff
      REQUIRE((folded(box, box.points) > 0) == (epsilon >= 0.01));
      std::vector<Vector> gradient;
      energy(box.problem.elements, box.points, 0.5, epsilon, &gradient);
      const double h = 1e-6;
      for (std::size_t v = 0; v < box.points.size(); ++v)
        for (std::size_t a = 0; a < 3; ++a) {
          std::vector<Point> more = box.points;
          std::vector<Point> less = box.points;
          more[v][a] += h;
          less[v][a] -= h;
          const double difference = (energy(box.problem.elements, more, 0.5, epsilon) -
                                     energy(box.problem.elements, less, 0.5, epsilon)) /
                                    (2 * h);
          CHECK(gradient[v][a] == Approx(difference).epsilon(1e-4).margin(1e-3));
        }
    }
}

TEST_CASE("Random foldings of a box with fixed boundary are all unfolded", "[unfold]") {
  int most = 0;
  for (int seed = 0; seed < 100; ++seed) {
    Box box(3 + seed % 3);
    const std::vector<Point> flat = box.points;
    box.shake(0.5 + 0.03 * seed, seed); // up to 3.5 edges, farther than the box is wide
    const int before = folded(box, box.points);
    most = std::max(most, before);
    const Unfolded done = unfold::unfold(box.problem, box.points);
    CAPTURE(seed, done.rounds, done.iterations);
    CHECK(done.folded_before == before);
    CHECK(done.folded_after == 0);
    CHECK(folded(box, done.points) == 0);
    for (std::size_t v = 0; v < flat.size(); ++v)
      if (box.problem.freedom[v].kind == Freedom::Kind::fixed) REQUIRE(done.points[v] == flat[v]);
  }
  CHECK(most > 200);
}

TEST_CASE("Points on planes and lines stay there, and the minimum is what was wanted", "[unfold]") {
  Box box(3);
  const std::vector<Point> flat = box.points;
  for (std::size_t v = 0; v < flat.size(); ++v) {
    std::array<bool, 3> held{};
    for (std::size_t a = 0; a < 3; ++a) held[a] = flat[v][a] == 0 || flat[v][a] == box.n;
    const auto count = std::count(held.begin(), held.end(), true);
    Freedom& f = box.problem.freedom[v];
    f = {count == 3   ? Freedom::Kind::fixed
         : count == 2 ? Freedom::Kind::line
         : count == 1 ? Freedom::Kind::plane
                      : Freedom::Kind::free,
         {}};
    for (std::size_t a = 0; a < 3; ++a)
      if ((count == 1 && held[a]) || (count == 2 && !held[a])) f.direction[a] = 1;
  }
  Random random(7);
  for (std::size_t v = 0; v < flat.size(); ++v) {
    const Vector by{2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
    const Vector allowed = box.problem.freedom[v].allowed(by);
    for (std::size_t a = 0; a < 3; ++a) box.points[v][a] += allowed[a];
  }
  REQUIRE(folded(box, box.points) > 10);
  Options exact;
  exact.least_gain = 1e-12;
  const Unfolded done = unfold::unfold(box.problem, box.points, exact);
  CHECK(done.folded_after == 0);
  // The box as it was has the least energy of all: each element is as wanted.
  for (std::size_t v = 0; v < flat.size(); ++v) {
    CHECK(numeric::distance(done.points[v], flat[v]) < 0.01);
    for (std::size_t a = 0; a < 3; ++a)
      if (flat[v][a] == 0 || flat[v][a] == box.n) REQUIRE(done.points[v][a] == flat[v][a]);
  }
  CHECK(unfold::unfold(box.problem, box.points, exact).points == done.points);
}

TEST_CASE("What cannot be unfolded comes back no worse, and wrong calls are refused", "[unfold]") {
  Box box(2);
  // A corner fixed at (t, t, t). The hexagon around it is a unit square seen along each axis, so the boundary
  // encloses 8 - t: at 20 less than nothing, and no map without folds has it.
  box.points[box.at(0, 0, 0)] = {20, 20, 20};
  const int before = folded(box, box.points);
  REQUIRE(before > 0);
  const Unfolded done = unfold::unfold(box.problem, box.points);
  CHECK(done.folded_after > 0);
  CHECK(done.folded_after <= before);
  CHECK(folded(box, done.points) == done.folded_after);
  CHECK(unfold::unfold({}, {}).points.empty());
  CHECK_THROWS_AS(unfold::unfold(box.problem, {}), PreconditionError);
  Problem wrong = box.problem;
  wrong.elements[0].corner[0] = 27;
  CHECK_THROWS_AS(unfold::unfold(wrong, box.points), PreconditionError);
  CHECK_THROWS_AS(element({0, 1, 2, 3}, {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}), PreconditionError);
}

TEST_CASE("springs draw points to planes, lines and places", "[unfold]") {
  // Two points of a box of cubes are drawn: its corner to a place, the middle of a side to a plane beyond it.
  Box box(2);
  for (Freedom& f : box.problem.freedom) f.kind = Freedom::Kind::free;
  const int corner = box.at(0, 0, 0);
  const int middle = box.at(2, 1, 1);
  const Freedom fixed{Freedom::Kind::fixed, {}};
  const Freedom plane{Freedom::Kind::plane, {1, 0, 0}};
  constexpr double strong = 1e5;
  box.problem.pulls = {{corner, fixed, {-0.1, -0.2, -0.1}, strong}, {middle, plane, {2.2, 0, 0}, strong}};
  const Unfolded found = unfold::unfold(box.problem, box.points);
  CHECK(found.folded_after == 0);
  CHECK(numeric::distance(found.points[corner], {-0.1, -0.2, -0.1}) < 1e-3);
  CHECK(found.points[middle][0] == Approx(2.2).margin(1e-3));
  CHECK(found.last == found.points);
  const Pull line{0, {Freedom::Kind::line, {0, 0, 1}}, {1, 1, 1}, 1};
  CHECK(line.away({2, 3, 4}) == numeric::Vector{1, 2, 0});
  CHECK_THROWS_AS(
      unfold::unfold({box.problem.elements, {}, box.problem.freedom, {{999, fixed, {}, 1}}}, box.points),
      PreconditionError);
}

TEST_CASE("A brick is its eight corners", "[unfold]") {
  Random random(7);
  constexpr std::array<Point, 8> cube{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  constexpr std::array<std::array<int, 3>, 8> beside{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  const std::array<double, 3> lengths{0.5, 1, 2};
  std::vector<Element> corners;
  for (int c = 0; c < 8; ++c) {
    std::array<int, 4> at{c};
    std::array<Vector, 3> edges{};
    for (std::size_t k = 0; k < 3; ++k) {
      at[k + 1] = beside[c][k];
      edges[k] = cube[beside[c][k]] - cube[c];
      for (std::size_t a = 0; a < 3; ++a) edges[k][a] *= lengths[a];
    }
    corners.push_back(element(at, edges, 0.7));
  }
  const std::vector<Brick> bricks{brick({0, 1, 2, 3, 4, 5, 6, 7}, lengths, 0.7)};
  for (const double epsilon : {1.0, 1e-3})
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Point> points(cube.begin(), cube.end());
      for (Point& p : points)
        for (double& x : p) x += random.uniform() - 0.5;
      std::vector<Vector> expected;
      std::vector<Vector> gradient(8, Vector{});
      const double value = energy(corners, points, 0.5, epsilon, &expected);
      CHECK(add_energy(bricks, points, 0.5, epsilon, gradient) == Approx(value));
      for (std::size_t v = 0; v < 8; ++v)
        for (std::size_t a = 0; a < 3; ++a)
          CHECK(gradient[v][a] == Approx(expected[v][a]).epsilon(1e-9).margin(1e-9 * value));
      const std::vector<double> d = determinants(corners, points);
      for (std::size_t c = 0; c < 8; ++c) CHECK(determinants(bricks, points)[c] == Approx(d[c]));
    }
  CHECK_THROWS_AS(brick({}, {1, 0, 1}), PreconditionError);
}
