// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/unfold/unfold.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

using namespace tetrarch::unfold;
using namespace tetrarch::numeric;
using tetrarch::support::Random;

namespace {

/// A ball of hexahedra:
///
///      .---.---.       A cube of n^3 cells in the middle, of diagonal 1, and between its surface and the
///     /  .-+-.  .      sphere of radius 1 as many layers of cells as are asked for. Points of the sphere are
///     |--| | |--|      fixed.
///     .  '-+-'  /
class Ball {
public:
  Ball(int n, int layers) : n_(n) {
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          const auto at = [&](int i, int j, int k) { return node({x + i, y + j, z + k}, 0); };
          add({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1),
               at(0, 1, 1)});
        }
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int end : {0, n})
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) add_column(axis, end, i, j, layers);
  }

  const Problem& problem() const { return problem_; }
  const std::vector<Point>& points() const { return points_; }

  /// The points inside, each moved by up to so much along each axis.
  std::vector<Point> shaken(double by, int seed) const {
    Random random(seed);
    std::vector<Point> result = points_;
    for (std::size_t v = 0; v < result.size(); ++v)
      for (double& x : result[v])
        if (problem_.freedom[v].kind != Freedom::Kind::fixed) x += by * (2 * random.uniform() - 1);
    return result;
  }

private:
  using Place = std::array<int, 3>;

  int node(const Place& at, double out) {
    const auto [found, is_new] = number_.try_emplace({at, out}, static_cast<int>(points_.size()));
    if (is_new) {
      Point p{};
      for (std::size_t a = 0; a < 3; ++a) p[a] = (2.0 * at[a] / n_ - 1) / (2 * std::sqrt(3.0));
      if (out > 0) p = (1 - out) * p + out / norm(p) * p;
      points_.push_back(p);
      problem_.freedom.push_back({out == 1 ? Freedom::Kind::fixed : Freedom::Kind::free, {}});
    }
    return found->second;
  }

  void add_column(std::size_t axis, int end, int i, int j, int layers) {
    // Counterclockwise as seen from outside.
    std::array<Place, 4> square{};
    constexpr std::array<std::array<int, 2>, 4> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      square[k][axis] = end;
      square[k][(axis + 1) % 3] = i + around[k][0];
      square[k][(axis + 2) % 3] = j + around[k][1];
    }
    if (end == 0) std::swap(square[1], square[3]);
    for (int layer = 0; layer < layers; ++layer) {
      std::array<int, 8> corner{};
      for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = node(square[k], 1.0 * layer / layers);
        corner[k + 4] = node(square[k], (layer + 1.0) / layers);
      }
      add(corner);
    }
  }

  void add(const std::array<int, 8>& corner) {
    const double side = 1 / std::sqrt(3.0) / n_;
    problem_.bricks.push_back(brick(corner, {side, side, side}));
  }

  int n_;
  std::map<std::pair<Place, double>, int> number_;
  Problem problem_;
  std::vector<Point> points_;
};

int folded_ball(const Problem& problem, const std::vector<Point>& points) {
  const std::vector<double> d = determinants(problem.bricks, points);
  return static_cast<int>(std::count_if(d.begin(), d.end(), [](double x) { return !(x > 0); }));
}

} // namespace

TEST_CASE("Random foldings of a ball of hexahedra with fixed boundary are all unfolded", "[unfold]") {
  int most = 0;
  for (int seed = 0; seed < 100; ++seed) {
    const Ball ball(2 + seed % 2, 2 + seed % 3);
    REQUIRE(folded_ball(ball.problem(), ball.points()) == 0);
    const std::vector<Point> start = ball.shaken(0.2 + 0.01 * seed, seed); // up to 1.2 times the radius
    const int before = folded_ball(ball.problem(), start);
    most = std::max(most, before);
    const Unfolded done = unfold(ball.problem(), start);
    CAPTURE(seed, done.rounds, done.iterations);
    CHECK(done.folded_before == before);
    CHECK(done.folded_after == 0);
    CHECK(folded_ball(ball.problem(), done.points) == 0);
    for (std::size_t v = 0; v < start.size(); ++v)
      if (ball.problem().freedom[v].kind == Freedom::Kind::fixed) REQUIRE(done.points[v] == ball.points()[v]);
  }
  CHECK(most > 300);
}

TEST_CASE("The gradient of bricks is that of their energy, by differences", "[unfold]") {
  const Ball ball(2, 2);
  for (const double epsilon : {1.0, 0.1}) {
    std::vector<Point> points = ball.shaken(0.3, 5);
    REQUIRE(folded_ball(ball.problem(), points) > 0);
    const auto value = [&] {
      std::vector<Vector> unused(points.size(), Vector{});
      return add_energy(ball.problem().bricks, points, 0.5, epsilon, unused);
    };
    std::vector<Vector> gradient(points.size(), Vector{});
    add_energy(ball.problem().bricks, points, 0.5, epsilon, gradient);
    constexpr double h = 1e-6;
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t a = 0; a < 3; ++a) {
        const double here = points[v][a];
        points[v][a] = here + h;
        const double more = value();
        points[v][a] = here - h;
        const double less = value();
        points[v][a] = here;
        CHECK(gradient[v][a] == Approx((more - less) / (2 * h)).epsilon(1e-4).margin(1e-2));
      }
  }
}
