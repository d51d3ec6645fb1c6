// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/grid.hpp"

#include "product/floors.hpp"
#include "product/solids.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tetrarch;
using namespace tetrarch::product;
using support::Random;
using Complex = std::complex<double>;
using Rectangle = std::array<Complex, 2>;

namespace {

double cross(Complex a, Complex b) {
  return (std::conj(a) * b).imag();
}

/// Of a cell, by the way around.
double area(const FloorGrid& grid, const std::array<int, 4>& cell) {
  double twice = 0;
  for (std::size_t c = 0; c < 4; ++c)
    twice += cross(grid.nodes[cell[c]].position, grid.nodes[cell[(c + 1) % 4]].position);
  return twice / 2;
}

/// What must be true of every grid: cells are convex and not turned over, together they are the floor, and
/// nodes on loops are on the sides of the rectangles.
void require_laws(double height, const std::vector<Rectangle>& holes, const FloorGrid& grid) {
  double rest = height;
  for (const auto& [low, high] : holes) rest -= (high - low).real() * (high - low).imag();
  for (const auto& cell : grid.cells) {
    rest -= area(grid, cell);
    for (std::size_t c = 0; c < 4; ++c) {
      const Complex at = grid.nodes[cell[c]].position;
      REQUIRE(cross(grid.nodes[cell[(c + 1) % 4]].position - at,
                    grid.nodes[cell[(c + 3) % 4]].position - at) > 0);
    }
  }
  CHECK(std::abs(rest) < 1e-12);
  for (const GridNode& node : grid.nodes) {
    const double x = node.position.real();
    const double y = node.position.imag();
    if (node.loop == 0) REQUIRE((x == 0 || x == 1 || y == 0 || y == height));
    if (node.loop <= 0) continue;
    const auto& [low, high] = holes[node.loop - 1];
    REQUIRE((x == low.real() || x == high.real() || y == low.imag() || y == high.imag()));
    REQUIRE((x >= low.real() && x <= high.real() && y >= low.imag() && y <= high.imag()));
  }
  // Of holes that are too thin to have nodes between their corners, all four are there.
  for (std::size_t k = 0; k < holes.size(); ++k)
    CHECK(std::count_if(grid.nodes.begin(), grid.nodes.end(),
                        [&](const GridNode& node) { return node.loop == static_cast<int>(k) + 1; }) >= 4);
}

std::vector<Rectangle> random_holes(int count, Random& random) {
  std::vector<Rectangle> holes;
  while (static_cast<int>(holes.size()) < count) {
    const auto pair = [&] {
      std::array<double, 2> p{0.01 + 0.98 * random.uniform(), 0.01 + 0.98 * random.uniform()};
      std::sort(p.begin(), p.end());
      return p;
    };
    const std::array<double, 2> x = pair();
    const std::array<double, 2> y = pair();
    const bool meets = std::any_of(holes.begin(), holes.end(), [&](const Rectangle& other) {
      return x[0] <= other[1].real() && other[0].real() <= x[1] && y[0] <= other[1].imag() &&
             other[0].imag() <= y[1];
    });
    if (!meets) holes.push_back({Complex(x[0], y[0]), Complex(x[1], y[1])});
  }
  return holes;
}

} // namespace

TEST_CASE("A rectangle without holes becomes a plain grid", "[grid]") {
  // Counted by hand: 8 x 4 cells, 9 x 5 nodes, 7 x 3 of them inside.
  const FloorGrid grid = floor_grid(0.5, {}, {8});
  CHECK(grid.columns == 8);
  CHECK(grid.rows == 4);
  CHECK(grid.cells.size() == 32);
  CHECK(grid.nodes.size() == 45);
  CHECK(std::count_if(grid.nodes.begin(), grid.nodes.end(), [](const GridNode& n) { return n.loop < 0; }) ==
        21);
  CHECK(grid.max_stretch == Approx(1).margin(1e-12));
  require_laws(0.5, {}, grid);
}

TEST_CASE("A hole whose sides are on lines of the grid leaves the grid as it is", "[grid]") {
  // Counted by hand: 10 x 7 cells without 4 x 3, 11 x 8 nodes without 3 x 2; 14 nodes around the hole.
  const std::vector<Rectangle> holes{{Complex(0.3, 0.2), Complex(0.7, 0.5)}};
  const FloorGrid grid = floor_grid(0.7, holes, {10});
  CHECK(grid.cells.size() == 58);
  CHECK(grid.nodes.size() == 82);
  CHECK(grid.holes == std::vector<std::array<int, 4>>{{3, 2, 7, 5}});
  CHECK(std::count_if(grid.nodes.begin(), grid.nodes.end(), [](const GridNode& n) { return n.loop == 1; }) ==
        14);
  CHECK(grid.mean_stretch == Approx(1).margin(1e-12));
  require_laws(0.7, holes, grid);
}

TEST_CASE("Stretch is the ratio of the sides of cells", "[grid]") {
  // By hand: one column beside the hole, of width 0.1, cells 0.25 high; between, and right of it, squares.
  const std::vector<Rectangle> holes{{Complex(0.1, 0.25), Complex(0.6, 0.5)}};
  const FloorGrid grid = floor_grid(0.75, holes, {4});
  CHECK(grid.columns == 1 + 2 + 2);
  CHECK(grid.rows == 3);
  CHECK(grid.max_stretch == Approx(2.5));
  // 13 cells: 3 of 2.5, 4 beside the hole of 1, 6 to its right of 0.25 / 0.2.
  CHECK(grid.mean_stretch == Approx((3 * 2.5 + 4 * 1 + 6 * 1.25) / 13));
}

TEST_CASE("Sides that nearly coincide share a line if asked to, and each hole keeps its own", "[grid]") {
  const std::vector<Rectangle> holes{{Complex(0.2, 0.2), Complex(0.4, 0.4)},
                                     {Complex(0.21, 0.6), Complex(0.41, 0.8)}};
  // By hand: lines at 0, 0.205, 0.405, 1 with 2, 2 and 6 cells between; or at 0, 0.2, 0.21, 0.4, 0.41, 1 with
  // 2, 1, 2, 1, 6.
  const FloorGrid shared = floor_grid(1, holes, {10, 0.25});
  CHECK(shared.columns == 10);
  CHECK(shared.holes[0][0] == shared.holes[1][0]);
  require_laws(1, holes, shared);
  const FloorGrid separate = floor_grid(1, holes, {10, 0});
  CHECK(separate.columns == 12);
  CHECK(separate.max_stretch == Approx(10));
  require_laws(1, holes, separate);
}

TEST_CASE("Holes next to each other keep a gap however narrow", "[grid]") {
  const std::vector<Rectangle> beside{{Complex(0.2, 0.2), Complex(0.4, 0.6)},
                                      {Complex(0.401, 0.3), Complex(0.7, 0.8)}};
  const FloorGrid grid = floor_grid(1, beside, {10});
  CHECK(grid.holes[0][2] + 1 == grid.holes[1][0]);
  require_laws(1, beside, grid);
  // Corner to corner, one line may be shared, not both.
  const std::vector<Rectangle> diagonal{{Complex(0.2, 0.2), Complex(0.4, 0.4)},
                                        {Complex(0.401, 0.401), Complex(0.7, 0.8)}};
  const FloorGrid corners = floor_grid(1, diagonal, {10});
  CHECK(corners.holes[0][2] == corners.holes[1][0]);
  CHECK(corners.holes[0][3] + 1 == corners.holes[1][1]);
  require_laws(1, diagonal, corners);
}

TEST_CASE("Grids of random floors are grids", "[grid]") {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Rectangle> holes = random_holes(1 + round % 6, random);
    for (const int across : {1, 5, 24}) {
      const FloorGrid grid = floor_grid(1, holes, {across});
      require_laws(1, holes, grid);
      // Euler's number of a disk with holes, each cell and each edge counted once.
      int edges = 0;
      for (const auto& cell : grid.cells)
        for (std::size_t c = 0; c < 4; ++c) {
          // An edge is counted from its left or lower cell; those of none are on loops.
          const std::array<int, 2> ends{cell[(c + 1) % 4], cell[c]};
          const bool first = c == 1 || c == 2;
          const bool has_other = std::any_of(grid.cells.begin(), grid.cells.end(), [&](const auto& other) {
            return (other[0] == ends[0] && other[1] == ends[1]) ||
                   (other[1] == ends[0] && other[2] == ends[1]) ||
                   (other[2] == ends[0] && other[3] == ends[1]) ||
                   (other[3] == ends[0] && other[0] == ends[1]);
          });
          edges += first || !has_other ? 1 : 0;
        }
      CHECK(static_cast<int>(grid.nodes.size()) - edges + static_cast<int>(grid.cells.size()) ==
            1 - static_cast<int>(holes.size()));
      if (across == 5) break;
    }
  }
}

TEST_CASE("Floors that are no rectangles with holes are refused", "[grid]") {
  using Catch::Contains;
  CHECK_THROWS_WITH(floor_grid(1, {{Complex(0.5, 0.2), Complex(0.5, 0.4)}}),
                    Contains("hole 0") && Contains("empty"));
  CHECK_THROWS_WITH(floor_grid(1, {{Complex(0.5, 0.2), Complex(1.5, 0.4)}}), Contains("does not lie inside"));
  CHECK_THROWS_WITH(
      floor_grid(1, {{Complex(0.2, 0.2), Complex(0.4, 0.4)}, {Complex(0.4, 0.4), Complex(0.6, 0.6)}}),
      Contains("hole 1") && Contains("touches hole 0"));
  CHECK_THROWS_AS(floor_grid(0, {}), InputError);
  CHECK_THROWS_AS(floor_grid(1, {}, {0}), PreconditionError);
  CHECK_THROWS_AS(floor_grid(1, {}, {1'000'000}), InputError);
}

TEST_CASE("Nodes lie on the floor where their coordinates are, those of loops on loops", "[grid]") {
  const auto plate = support::plate(2, 6, 1, support::Hole::square, 0.5, 0.15);
  const Solid solid = product::solid_of(plate.mesh);
  const Partition parts = partition(solid, support::bases(solid, plate));
  const FloorMap floor = support::floor_from_plan(solid, parts, plate);
  const FloorGrid grid = floor_grid(floor.height, floor.rectangles, {12});
  const std::vector<FloorPoint> points = nodes_on_floor(solid, floor, grid);
  REQUIRE(points.size() == grid.nodes.size());
  std::vector<Complex> position(solid.mesh.points.size());
  for (std::size_t v = 0; v < floor.vertex.size(); ++v) position[floor.vertex[v]] = floor.position[v];
  for (std::size_t n = 0; n < points.size(); ++n) {
    Complex there;
    int on_rim = 0;
    for (int c = 0; c < 3; ++c) {
      const int v = solid.corner(points[n].triangle, c);
      there += points[n].weight[c] * position[v];
      on_rim += points[n].weight[c] == 0 ? 1 : 0;
    }
    CHECK(points[n].miss < 1e-12);
    CHECK(std::abs(there - grid.nodes[n].position) == Approx(points[n].miss).margin(1e-9));
    if (grid.nodes[n].loop >= 0) CHECK(on_rim >= 1);
  }
}
