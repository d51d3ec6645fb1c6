// SPDX-License-Identifier: GPL-2.0-or-later
#include "product/solids.hpp"
#include "tetrarch/hex/deviation.hpp"
#include "tetrarch/hex/features.hpp"
#include "tetrarch/hex/fill.hpp"
#include "tetrarch/hex/fit.hpp"
#include "tetrarch/hex/grid.hpp"
#include "tetrarch/hex/layers.hpp"
#include "tetrarch/hex/limbs.hpp"
#include "tetrarch/hex/match.hpp"
#include "tetrarch/hex/reach.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stop_token>

using namespace tetrarch;
using namespace tetrarch::hex;
using namespace tetrarch::numeric;

namespace {

product::Solid box_solid() {
  return product::solid_of(support::box({3, 2, 1}, {3, 2, 1}, 0).mesh);
}

/// A grid of n x n x n cells with those taken whose index is in the list.
struct Marked {
  Grid grid;
  std::vector<float> filled;

  Marked(int n, const std::set<std::array<int, 3>>& cells) {
    for (auto& planes : grid.plane)
      for (int k = 0; k <= n; ++k) planes.push_back(k);
    filled.assign(static_cast<std::size_t>(grid.size()), 0);
    for (const auto& [x, y, z] : cells) filled[grid.index(x, y, z)] = 1;
  }
};

/// Vertices - edges + faces of the surface, counted from its squares.
int euler(const product::HexMesh& mesh) {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  const auto surface = surface_of(mesh);
  for (const SurfaceSquare& s : surface) {
    const auto& side = product::outward_sides[s.side];
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = mesh.hexahedra[s.hexahedron][side[k]];
      const int b = mesh.hexahedra[s.hexahedron][side[(k + 1) % 4]];
      vertices.insert(a);
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(surface.size());
}

/// Each square belongs to two hexahedra at most, and no hexahedron names a point twice.
void require_mesh(const product::HexMesh& mesh) {
  std::map<std::array<int, 4>, int> count;
  for (const product::Hexahedron& h : mesh.hexahedra) {
    CHECK(std::set<int>(h.begin(), h.end()).size() == 8);
    for (const auto& side : product::outward_sides) {
      std::array<int, 4> square{h[side[0]], h[side[1]], h[side[2]], h[side[3]]};
      std::sort(square.begin(), square.end());
      CHECK(++count[square] <= 2);
    }
  }
}

} // namespace

TEST_CASE("a box has six patches, twelve ridges and eight corners", "[hex]") {
  const Features box = features(box_solid());
  CHECK(box.patches == 6);
  CHECK(box.ridges.size() == 12);
  CHECK(box.corners.size() == 8);
  CHECK(std::none_of(box.ridges.begin(), box.ridges.end(), [](const Ridge& r) { return r.is_closed; }));

  const Features can = features(product::solid_of(support::cylinder(6, 4).mesh));
  CHECK(can.patches == 3);
  CHECK(can.ridges.size() == 2);
  CHECK(can.corners.empty());
  for (const Ridge& rim : can.ridges) {
    CHECK(rim.is_closed);
    CHECK(rim.vertices.front() == rim.vertices.back());
  }
  // All patches of a box are smaller than this: one is left.
  CHECK(features(box_solid(), {.least_extent = 100}).patches == 1);
}

TEST_CASE("cells take in a box exactly where planes meet its sides", "[hex]") {
  const product::Solid solid = box_solid();
  const Grid grid = grid_around(solid.mesh.points, 0.5);
  const std::vector<float> full = filled(solid, solid.mesh.points, grid);
  CHECK(std::count(full.begin(), full.end(), 1.0F) == 6 * 4 * 2);
  CHECK(std::count(full.begin(), full.end(), 0.0F) == grid.size() - 6 * 4 * 2);
  const auto chosen = chosen_cells(grid, full, 0);
  REQUIRE(chosen);
  const SizedHexahedra cells = cells_of(grid, *chosen);
  CHECK(product::volume(cells.mesh) == 6);
  CHECK(euler(cells.mesh) == 2);
}

TEST_CASE("cells that touch along an edge or at a point are mended", "[hex]") {
  // Two cells of a row that meet at an edge; two that meet at a point; and a cell that would be a second
  // piece.
  for (const std::set<std::array<int, 3>>& cells :
       {std::set<std::array<int, 3>>{{1, 1, 1}, {2, 2, 1}}, {{1, 1, 1}, {2, 2, 2}}, {{1, 1, 1}, {4, 4, 4}}}) {
    const Marked marked(6, cells);
    const auto chosen = chosen_cells(marked.grid, marked.filled, 0);
    REQUIRE(chosen);
    CHECK(euler(cells_of(marked.grid, *chosen).mesh) == 2);
  }
  // A notch in the top of a block and a shaft from below that meet at a point: outside hangs together there,
  // too.
  std::set<std::array<int, 3>> block;
  for (int x = 1; x < 5; ++x)
    for (int y = 1; y < 5; ++y)
      for (int z = 1; z < 5; ++z) block.insert({x, y, z});
  block.erase({2, 2, 4});
  for (int z = 1; z < 4; ++z) block.erase({3, 3, z});
  const Marked notched(6, block);
  const auto mended = chosen_cells(notched.grid, notched.filled, 0);
  REQUIRE(mended);
  const product::HexMesh mesh = cells_of(notched.grid, *mended).mesh;
  std::map<std::pair<int, int>, int> squares;
  for (const SurfaceSquare& s : surface_of(mesh))
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = mesh.hexahedra[s.hexahedron][product::outward_sides[s.side][k]];
      const int b = mesh.hexahedra[s.hexahedron][product::outward_sides[s.side][(k + 1) % 4]];
      ++squares[{std::min(a, b), std::max(a, b)}];
    }
  CHECK(std::all_of(squares.begin(), squares.end(), [](const auto& e) { return e.second == 2; }));
  // A ring of eight cells has genus 1, and is no ball; nor is it a ring where one is missing.
  std::set<std::array<int, 3>> ring;
  for (int x = 1; x < 4; ++x)
    for (int y = 1; y < 4; ++y)
      if (x != 2 || y != 2) ring.insert({x, y, 1});
  const Marked marked(6, ring);
  CHECK(chosen_cells(marked.grid, marked.filled, 1));
  CHECK_FALSE(chosen_cells(marked.grid, marked.filled, 0));
  ring.erase({2, 1, 1});
  const Marked open(6, ring);
  CHECK(chosen_cells(open.grid, open.filled, 0));
  CHECK_FALSE(chosen_cells(open.grid, open.filled, 1));
}

TEST_CASE("a layer keeps surface and topology", "[hex]") {
  const product::Solid solid = box_solid();
  const Grid grid = grid_around(solid.mesh.points, 0.5);
  const auto chosen = chosen_cells(grid, filled(solid, solid.mesh.points, grid), 0);
  REQUIRE(chosen);
  SizedHexahedra cells = cells_of(grid, *chosen);
  const std::size_t squares = surface_of(cells.mesh).size();
  const std::size_t before = cells.lengths.size();
  const std::vector<int> origin =
      add_layer(cells, std::vector<char>(before, 1), std::vector<char>(6 * before, 0), 0.1);
  CHECK(cells.lengths.size() == before + squares);
  CHECK(surface_of(cells.mesh).size() == squares);
  CHECK(product::volume(cells.mesh) == Approx(6).epsilon(1e-12));
  CHECK(euler(cells.mesh) == 2);
  CHECK(product::quality(cells.mesh).bad.empty());
  require_mesh(cells.mesh);
  // A layer around some of the squares alone, which ends on the surface: one more square for each edge of
  // the rim.
  const std::size_t now = cells.lengths.size();
  std::vector<char> shrinks(now);
  std::vector<char> stays(6 * now);
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t h = before; h < now; ++h) {
    const auto& side = product::outward_sides[1];
    double top = 1;
    for (const int c : side) top = std::min(top, cells.mesh.points[cells.mesh.hexahedra[h][c]][2]);
    if (top < 1) continue;
    shrinks[h] = 1;
    stays[6 * h + 1] = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      const int a = cells.mesh.hexahedra[h][side[k]];
      const int b = cells.mesh.hexahedra[h][side[(k + 1) % 4]];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  const auto rim = std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second == 1; });
  REQUIRE(rim == 20); // 2 (6 + 4)
  add_layer(cells, shrinks, stays, 0.1);
  CHECK(surface_of(cells.mesh).size() == squares + static_cast<std::size_t>(rim));
  CHECK(euler(cells.mesh) == 2);
  require_mesh(cells.mesh);
}

TEST_CASE("the distance of two surfaces is taken both ways", "[hex]") {
  const product::Solid solid = box_solid();
  const Grid grid = grid_around(solid.mesh.points, 0.5);
  std::vector<char> chosen = *chosen_cells(grid, filled(solid, solid.mesh.points, grid), 0);
  const Deviation none = deviation(solid, cells_of(grid, chosen).mesh);
  CHECK(none.greatest() == Approx(0).margin(1e-12));
  CHECK(none.diagonal == Approx(std::sqrt(14.0)));
  // Without a layer at the end of greatest x the solid sticks out by half a unit; with a cell more they do.
  std::vector<char> fewer = chosen;
  for (std::size_t k = 0; k < fewer.size(); ++k)
    if (grid.cell(k)[0] == 6) fewer[k] = 0;
  const Deviation less = deviation(solid, cells_of(grid, fewer).mesh);
  CHECK(less.from_solid == Approx(0.5));
  CHECK(less.solid_at[0] == Approx(3));
  chosen[grid.index(7, 2, 1)] = 1;
  const Deviation more = deviation(solid, cells_of(grid, chosen).mesh);
  CHECK(more.from_hexahedra == Approx(0.5));
  CHECK(more.hexahedra_at[0] == 3.5);
  CHECK(more.from_solid < 0.5);
}

TEST_CASE("a box is filled with boxes", "[hex]") {
  const auto filling = fill(box_solid(), {.cells = 200});
  REQUIRE(filling);
  CHECK(filling->quality.minimum == Approx(1).epsilon(1e-9));
  CHECK(filling->volume == Approx(6).epsilon(1e-9));
  CHECK(filling->deviation.greatest() < 1e-9);
  CHECK(filling->ridges == 12);
  CHECK_FALSE(filling->has_layer);
}

TEST_CASE("curved solids are filled without an inverted hexahedron", "[hex]") {
  // Volumes: a cylinder, a pipe, and a bent plate with two holes, all as their tetrahedra have them.
  for (const solid::TetMesh& mesh :
       {support::cylinder(6, 4).mesh, support::pipe(0.5, 0.6, 5).mesh, support::bent(2, 4, 3).mesh}) {
    const product::Solid solid = product::solid_of(mesh);
    const auto filling = fill(solid, {.cells = 1500});
    REQUIRE(filling);
    require_mesh(filling->mesh);
    CHECK(filling->quality.bad.empty());
    CHECK(filling->quality.minimum > 0.2);
    CHECK(std::abs(filling->volume_ratio() - 1) < 0.01);
    CHECK(filling->deviation.relative() < 0.01);
    CHECK(filling->ridges == filling->ridges_of_solid);
    CHECK(euler(filling->mesh) == 2 - 2 * product::genus(solid));
    CHECK(filling->volume == Approx(product::volume(filling->mesh)));
  }
}

TEST_CASE("what no grid fits is not filled, and a stop is heeded", "[hex]") {
  // A plate far thinner than the cells, slanted so that no planes meet its sides.
  auto thin = support::box({1, 1, 1e-6}, {2, 2, 1}, 0).mesh;
  for (Point& p : thin.points) p = {p[0] - p[2], p[1] - p[2], 0.3 * p[0] + 0.4 * p[1] + p[2]};
  CHECK_FALSE(fill(product::solid_of(thin), {.edge = 0.2}));

  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(fill(box_solid(), {}, Progress({}, stop.get_token())), Stopped);
}

TEST_CASE("a wall thinner than the cells keeps a row of them", "[hex]") {
  // A block with a plate beside it that fills a fifth of its cells: neither half full nor lost.
  std::set<std::array<int, 3>> block;
  for (int x = 1; x < 4; ++x)
    for (int y = 1; y < 6; ++y)
      for (int z = 1; z < 6; ++z) block.insert({x, y, z});
  Marked marked(10, block);
  for (int x = 4; x < 9; ++x)
    for (int y = 1; y < 6; ++y) marked.filled[marked.grid.index(x, y, 3)] = 0.2F;
  // What is beside the plate's cells is touched, and less than half as full.
  for (int x = 4; x < 9; ++x)
    for (int y = 1; y < 6; ++y) marked.filled[marked.grid.index(x, y, 4)] = 0.05F;
  const auto half = chosen_cells(marked.grid, marked.filled, 0);
  REQUIRE(half);
  CHECK(std::count(half->begin(), half->end(), 1) == 75);
  const auto thin = thinned_cells(marked.grid, marked.filled, 0, 0.01);
  REQUIRE(thin);
  CHECK(thin->changes == 0);
  CHECK(euler(cells_of(marked.grid, thin->chosen).mesh) == 2);
  // The cells beside the block may go, as far as the plate hangs together with it.
  for (int x = 5; x < 9; ++x)
    for (int y = 1; y < 6; ++y) {
      CHECK(thin->chosen[marked.grid.index(x, y, 3)] == 1);
      CHECK(thin->chosen[marked.grid.index(x, y, 4)] == 0);
    }
}

TEST_CASE("holes are pierced and bridges laid where the genus wants them", "[hex]") {
  // A ring of eight cells around one that is nearly empty: a membrane, if a little is enough to be taken.
  std::set<std::array<int, 3>> ring;
  for (int x = 1; x < 4; ++x)
    for (int y = 1; y < 4; ++y)
      if (x != 2 || y != 2) ring.insert({x, y, 1});
  Marked closed(6, ring);
  closed.filled[closed.grid.index(2, 2, 1)] = 0.3F;
  CHECK_FALSE(chosen_cells(closed.grid, closed.filled, 1, 0.2));
  // The same where a cell of the ring is nearly full.
  Marked open(6, ring);
  open.filled[open.grid.index(2, 1, 1)] = 0.4F;
  CHECK_FALSE(chosen_cells(open.grid, open.filled, 1, 0.5));
  for (const auto& [marked, full] : {std::pair(&closed, 0.2), std::pair(&open, 0.5)}) {
    const auto one = thinned_cells(marked->grid, marked->filled, 1, full);
    REQUIRE(one);
    CHECK(one->changes == 1);
    CHECK(std::count(one->chosen.begin(), one->chosen.end(), 1) == 8);
    CHECK(one->chosen[marked->grid.index(2, 2, 1)] == 0);
    CHECK(euler(cells_of(marked->grid, one->chosen).mesh) == 0);
    const auto none = thinned_cells(marked->grid, marked->filled, 0, full);
    REQUIRE(none);
    CHECK(none->changes == 0);
    CHECK(euler(cells_of(marked->grid, none->chosen).mesh) == 2);
    // One hole is all that one cell can make.
    CHECK_FALSE(thinned_cells(marked->grid, marked->filled, 2, full));
  }
}

TEST_CASE("a corner where more ridges meet than a point has edges is kept with all of them", "[hex]") {
  // Pyramids of n sides, 2 high over a base of radius 1, cut into n tetrahedra around the axis.
  for (const int n : {7, 8}) {
    solid::TetMesh pyramid;
    pyramid.points = {{0, 0, 2}, {0, 0, 0}};
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      pyramid.points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    for (int k = 0; k < n; ++k) pyramid.tetrahedra.push_back({1, 2 + k, 2 + (k + 1) % n, 0});
    const product::Solid solid = product::solid_of(pyramid);
    const auto filling = fill(solid, {.cells = 600, .sharp = 30, .most_effort = 1});
    REQUIRE(filling);
    CHECK(filling->ridges_of_solid == 2 * n);
    CHECK(filling->ridges == 2 * n);
    CHECK(filling->quality.bad.empty());
    CHECK(std::abs(filling->volume_ratio() - 1) < 0.02);
  }
}

TEST_CASE("a slanted plate thinner than the cells is filled", "[hex]") {
  // Half as thick as edges are long, turned about two axes.
  auto plate = support::box({0.6, 0.5, 0.05}, {4, 4, 1}, 0).mesh;
  for (Point& p : plate.points) {
    p = {0.8 * p[0] - 0.6 * p[2], p[1], 0.6 * p[0] + 0.8 * p[2]};
    p = {p[0], 0.8 * p[1] - 0.6 * p[2], 0.6 * p[1] + 0.8 * p[2]};
  }
  const product::Solid solid = product::solid_of(plate);
  const auto filling = fill(solid, {.edge = 0.1});
  REQUIRE(filling);
  CHECK(filling->quality.bad.empty());
  CHECK(filling->volume == Approx(0.6 * 0.5 * 0.05).epsilon(0.01));
  CHECK(filling->deviation.relative() < 0.01);
}

TEST_CASE("a plate is not lost where none of its cells is half full", "[hex]") {
  // A fifth as thick as edges are long.
  auto plate = support::box({0.6, 0.5, 0.02}, {4, 4, 1}, 0).mesh;
  for (Point& p : plate.points) {
    p = {0.8 * p[0] - 0.6 * p[2], p[1], 0.6 * p[0] + 0.8 * p[2]};
    p = {p[0], 0.8 * p[1] - 0.6 * p[2], 0.6 * p[1] + 0.8 * p[2]};
  }
  const auto filling = fill(product::solid_of(plate), {.edge = 0.1, .most_effort = 1});
  REQUIRE(filling);
  CHECK(filling->quality.bad.empty());
  // No part of the plate is farther away than cells are long.
  CHECK(filling->deviation.from_solid < 0.1);
}

TEST_CASE("in a sharp wedge hexahedra stay good at the cost of its edge", "[hex]") {
  // Of 8 degrees: a hexahedron with a corner there has a scaled Jacobian of sin(8) = 0.14 at most.
  solid::TetMesh wedge;
  const double half = 2 * std::tan(4 * std::numbers::pi / 180);
  for (const double z : {0.0, 1.0})
    for (const Point& p : {Point{0, 0, z}, {2, -half, z}, {2, half, z}}) wedge.points.push_back(p);
  wedge.tetrahedra = {{0, 1, 2, 5}, {0, 1, 5, 4}, {0, 4, 5, 3}};
  const auto filling =
      fill(product::solid_of(wedge),
           {.cells = 500, .volume_tolerance = 0.1, .hausdorff_tolerance = 0.1, .most_effort = 1});
  REQUIRE(filling);
  CHECK(filling->quality.minimum > std::sin(8 * std::numbers::pi / 180));
  CHECK(filling->quality.minimum > 0.2);
}

TEST_CASE("a search ends within its means, and tells how", "[hex]") {
  const Search box = search(box_solid(), {.cells = 200});
  REQUIRE(box.best);
  CHECK(box.ending == Ending::good);
  CHECK(box.grids == 1);
  CHECK(cells_for(box_solid(), 0.5) == Approx(6 / 0.125 + 22 / 0.25));
  CHECK(cells_for(box_solid(), edge_for(box_solid(), 200)) == Approx(200));

  // The slanted plate, as good as without volume: each grid has 1 / 0.64 times the cells of the one before,
  // 1 + 1.56 + 2.44 + 3.81 + 5.96 = 14.8 in all, and a sixth would have edges of 0.8^5 = 0.33 of the first.
  auto thin = support::box({1, 1, 1e-6}, {2, 2, 1}, 0).mesh;
  for (Point& p : thin.points) p = {p[0] - p[2], p[1] - p[2], 0.3 * p[0] + 0.4 * p[1] + p[2]};
  const product::Solid plate = product::solid_of(thin);
  const Search all = search(plate, {.edge = 0.2});
  CHECK_FALSE(all.best);
  CHECK(all.ending == Ending::finest);
  CHECK(all.grids == 5);
  CHECK(all.finest_edge == Approx(0.2 * 0.8 * 0.8 * 0.8 * 0.8));
  const Search less = search(plate, {.edge = 0.2, .most_effort = 3});
  CHECK(less.ending == Ending::effort);
  CHECK(less.grids == 2);
  const Search least = search(plate, {.edge = 0.2, .most_bytes = 1});
  CHECK(least.ending == Ending::memory);
  CHECK(least.grids == 1);
}

TEST_CASE("a needle is not filled with a thousand times the cells that were wished for", "[hex]") {
  // 10^8 long: by volume and area 30 cells have edges of some thousands, where nothing lies inside; once a
  // grid finds a limb, ten thousands of its cells are in a row.
  const product::Solid needle =
      product::solid_of({{{0, 0, 0}, {3, 0, 0}, {0, 3, 1}, {1, 1, 1e8}}, {{0, 1, 2, 3}}});
  const Search found = search(needle, {.cells = 30});
  CHECK_FALSE(found.best);
  CHECK(found.ending == Ending::effort);
  CHECK(found.grids > 1);
}

TEST_CASE("points of a long and narrow triangle are as many as its area asks for", "[hex]") {
  const product::Solid needle = product::solid_of(support::box({40, 0.5, 0.5}, {1, 1, 1}, 0).mesh);
  const Targets targets(needle, features(needle));
  const std::vector<SurfaceSample> samples = surface_samples(targets, 1);
  double area = 0;
  for (const SurfaceSample& s : samples) area += s.area;
  CHECK(area == Approx(80.5)); // 4 * 20 + 2 * 0.25
  // Eight triangles of length 40.003: a row of 42 points along it, and the corner across. Four of a square's
  // half.
  CHECK(samples.size() == 8 * 43 + 4 * 3);
}

TEST_CASE("a limb thinner than the cells keeps a row of them", "[hex]") {
  // A cube of side 3 with a rod 0.4 thick and 3 long, which no cell of length 1 is half full of.
  std::set<std::array<int, 3>> cube;
  for (int x = 1; x < 4; ++x)
    for (int y = 1; y < 4; ++y)
      for (int z = 1; z < 4; ++z) cube.insert({x, y, z});
  Marked marked(9, cube);
  for (int x = 4; x < 7; ++x) marked.filled[marked.grid.index(x, 2, 2)] = 0.16F;
  std::vector<char> met(marked.filled.size());
  for (std::size_t k = 0; k < met.size(); ++k) met[k] = marked.filled[k] > 0 ? 1 : 0;
  const auto any = [](const std::vector<float>&) { return true; };
  const auto none = [](const std::vector<float>&) { return false; };
  // The last one but one touches no cell that is taken, and from there the way goes back.
  const std::vector<float> with = with_limbs(marked.grid, marked.filled, met, 0.5, any);
  for (int x = 4; x < 7; ++x) CHECK(with[marked.grid.index(x, 2, 2)] == 1);
  CHECK(std::count(with.begin(), with.end(), 1.0F) == 27 + 3);
  CHECK(with_limbs(marked.grid, marked.filled, met, 0.5, none) == marked.filled);
  // One that may be two cells long at most is laid by three quarters of three: two.
  const auto short_ones = [&](const std::vector<float>& f) { return f[marked.grid.index(6, 2, 2)] < 1; };
  const std::vector<float> part = with_limbs(marked.grid, marked.filled, met, 0.5, short_ones);
  CHECK(std::count(part.begin(), part.end(), 1.0F) == 27 + 2);

  // A shaft into a block of five, as thin: cells there are let out.
  std::set<std::array<int, 3>> block;
  for (int x = 1; x < 6; ++x)
    for (int y = 1; y < 6; ++y)
      for (int z = 1; z < 6; ++z) block.insert({x, y, z});
  Marked pierced(7, block);
  for (int x = 3; x < 6; ++x) pierced.filled[pierced.grid.index(x, 3, 3)] = 0.84F;
  for (std::size_t k = 0; k < pierced.filled.size(); ++k) met[k] = pierced.filled[k] > 0 ? 1 : 0;
  met.resize(pierced.filled.size());
  const std::vector<float> opened = with_limbs(pierced.grid, pierced.filled, met, 0.5, any);
  for (int x = 3; x < 6; ++x) CHECK(opened[pierced.grid.index(x, 3, 3)] == 0);
}

TEST_CASE("edges of tetrahedra meet cells that no sample point does", "[hex]") {
  // A needle between the sample points of cells of length 1.
  auto needle = support::box({4, 0.01, 0.01}, {1, 1, 1}, 0).mesh;
  for (Point& p : needle.points) p = p + Vector{0.05, 0.05, 0.05};
  const product::Solid solid = product::solid_of(needle);
  Marked marked(6, {});
  const std::vector<float> full = filled(solid, solid.mesh.points, marked.grid);
  CHECK(*std::max_element(full.begin(), full.end()) == 0);
  const std::vector<char> met = met_cells(solid, marked.grid, full);
  CHECK(std::count(met.begin(), met.end(), 1) == 5);
  for (int x = 0; x < 5; ++x) CHECK(met[marked.grid.index(x, 0, 0)] == 1);
}

TEST_CASE("what sticks out draws the square below it", "[hex]") {
  const product::Solid solid = box_solid();
  const Targets targets(solid, features(solid));
  const std::vector<SurfaceSample> samples = surface_samples(targets, 0.25);
  double area = 0;
  for (const SurfaceSample& s : samples) area += s.area;
  CHECK(area == Approx(22)); // 2 (6 + 3 + 2)
  const Grid grid = grid_around(solid.mesh.points, 0.5);
  std::vector<char> chosen = *chosen_cells(grid, filled(solid, solid.mesh.points, grid), 0);
  product::HexMesh mesh = cells_of(grid, chosen).mesh;
  for (const Vector& way : reach(mesh, samples, 1e-6, 1)) CHECK(way == Vector{});
  // Half a unit is missing at the end of greatest x: its points are drawn there, and others hardly.
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (grid.cell(k)[0] == 6) chosen[k] = 0;
  mesh = cells_of(grid, chosen).mesh;
  const std::vector<Vector> way = reach(mesh, samples, 0.1, 1);
  for (std::size_t v = 0; v < way.size(); ++v) {
    if (mesh.points[v][0] < 2.4) CHECK(way[v] == Vector{});
    if (mesh.points[v][0] == 2.5) CHECK(way[v][0] > 0.25);
    CHECK(numeric::norm(way[v]) <= 0.5 + 1e-9);
  }
  for (const Vector& w : reach(mesh, samples, 0.1, 0.2)) CHECK(numeric::norm(w) < 0.2 + 1e-9);
}

TEST_CASE("points far inside stay where the grid has them", "[hex]") {
  const product::Solid solid = product::solid_of(support::box({16, 16, 16}, {1, 1, 1}, 0).mesh);
  const Grid grid = grid_around(solid.mesh.points, 1);
  SizedHexahedra cells = cells_of(grid, *chosen_cells(grid, filled(solid, solid.mesh.points, grid), 0));
  const std::vector<char> deep = deep_points(cells.mesh, unmatched(cells.mesh).home);
  // By hand: more than six from the surface are those with coordinates 7, 8 and 9.
  CHECK(std::count(deep.begin(), deep.end(), 1) == 27);
  for (std::size_t v = 0; v < deep.size(); ++v)
    for (const double x : cells.mesh.points[v])
      if (deep[v] != 0) CHECK((x > 6.5 && x < 9.5));
}
