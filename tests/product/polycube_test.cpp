// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/polycube.hpp"

#include "support/errors.hpp"
#include "support/solids.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/polycube_pullback.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace tetrarch;
using namespace tetrarch::product;
using support::error_of;
using support::Voxels;

namespace {

/// 3 x 3 x `height` cubes without the middle ones, each `fine` cubes wide.
Voxels frame(int height, int fine) {
  Voxels cubes({3 * fine, 3 * fine, height * fine}, true);
  for (int x = fine; x < 2 * fine; ++x)
    for (int y = fine; y < 2 * fine; ++y)
      for (int z = 0; z < height * fine; ++z) cubes.set({x, y, z}, false);
  return cubes;
}

/// Three cubes in the shape of an L, in the xz plane.
Voxels corner(int fine) {
  Voxels cubes({2 * fine, fine, 2 * fine}, true);
  for (int x = fine; x < 2 * fine; ++x)
    for (int y = 0; y < fine; ++y)
      for (int z = fine; z < 2 * fine; ++z) cubes.set({x, y, z}, false);
  return cubes;
}

using Map = std::function<Point(const Point&)>;

/// A solid whose polycube is that of the voxels.
struct Mapped {
  Mapped(const Voxels& voxels, const Map& map) {
    auto cubes = support::mesh_of(voxels);
    solid::TetMesh carried;
    for (const Point& p : cubes.points) carried.points.push_back(map(p));
    carried.tetrahedra = cubes.tets;
    solid = product::solid_of(std::move(carried));
    for (const int v : solid.vertex) image.push_back(cubes.points[v]);
  }
  /// Triangles whose image is where `axis` has the value.
  void label(int which, std::size_t axis, double value) {
    base.resize(static_cast<std::size_t>(solid.boundary.triangle_count()), -1);
    for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
      const auto& corners = solid.boundary.corners(t);
      if (std::all_of(corners.begin(), corners.end(), [&](int v) { return image[v][axis] == value; }))
        base[t] = which;
    }
  }

  Solid solid;
  std::vector<Point> image;
  std::vector<int> base;
};

Point same(const Point& p) {
  return p;
}

/// Turned by 0.3 about the z axis and then about the x axis, twice as large, moved.
Point similar(const Point& p) {
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  const Point q{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  return {2 * q[0] + 1, 2 * (c * q[1] - s * q[2]), 2 * (s * q[1] + c * q[2]) - 5};
}

/// Planes z = const. go to themselves, and so do verticals.
Point sheared(const Point& p) {
  return {p[0] + 0.15 * std::sin(p[1]), p[1] + 0.1 * std::sin(p[0]), p[2]};
}

double farthest(const PolycubeHexahedra& made, const Map& map) {
  double result = 0;
  for (std::size_t h = 0; h < made.cube.size(); ++h) {
    const std::array<Point, 8> cube = made.cubes.corners(made.cube[h]);
    const std::array<Point, 8> found = made.solid.mesh.corners(h);
    for (std::size_t c = 0; c < 8; ++c) result = std::max(result, numeric::distance(map(cube[c]), found[c]));
  }
  return result;
}

} // namespace

TEST_CASE("The surface of voxels is filled with these voxels", "[polycube]") {
  support::Random random(11);
  int tried = 0;
  for (int round = 0; round < 1000 && tried < 12; ++round) {
    Voxels voxels({3, 3, 3});
    for (int k = 0; k < 27; ++k) voxels.set({k / 9, k / 3 % 3, k % 3}, random.below(3) != 0);
    if (!support::is_manifold(voxels)) continue;
    const auto cubes = support::mesh_of(voxels);
    const std::string error = error_of([&] {
      const Mapped m(voxels, same);
      // Counted by the voxels themselves; 8 for each if steps are halved.
      std::vector<std::array<int, 3>> wanted;
      voxels.for_each_filled([&](const support::Point& at) { wanted.push_back(at); });
      const Polycube one = filled_polycube(m.solid.boundary, m.image);
      CHECK(one.cubes == wanted);
      const Polycube two = filled_polycube(m.solid.boundary, m.image, 1, 2);
      CHECK(two.cubes.size() == 8 * wanted.size());
      CHECK(two.edge == 0.5);
      CHECK(hexahedra(one).hexahedra.size() == wanted.size());
      CHECK(hexahedra(one).points.size() == cubes.points.size());
      CHECK(quality(hexahedra(two)).minimum == Approx(1));
      // The volume of the tetrahedra is decided by `solid`; so is that they make a solid.
      CHECK(product::solid_of(tetrahedra(one)).size() == 6 * static_cast<int>(wanted.size()));
      ++tried;
    });
    // Random voxels may fall apart, or have a hollow.
    if (!error.empty()) CHECK(error.find("solid") != std::string::npos);
  }
  CHECK(tried == 12);
}

TEST_CASE("Images that are no polycube are refused, and the triangle is named", "[polycube]") {
  const Mapped cube(Voxels({2, 2, 2}, true), same);
  const auto refused = [&](const std::vector<Point>& image, double step = 1) {
    return error_of([&] { (void)filled_polycube(cube.solid.boundary, image, step); });
  };
  CHECK(refused(cube.image).empty());
  CHECK(refused(cube.image, 2).empty());
  const auto vertex = [&](const Point& p) {
    return std::find(cube.image.begin(), cube.image.end(), p) - cube.image.begin();
  };
  std::vector<Point> image = cube.image;
  image[vertex({1, 1, 2})] = {1, 1, 2.2};
  CHECK(refused(image).find("lies in no plane of the lattice") != std::string::npos);
  image[vertex({1, 1, 2})] = {1, 1, 2 + 1e-7}; // as a file rounds it
  CHECK(refused(image).empty());
  image[vertex({1, 1, 2})] = {1, 2.5, 2}; // beyond its neighbours, and the face
  CHECK(refused(image).find("no surface of a polycube") != std::string::npos);
  image[vertex({1, 1, 2})] = {1, 0, 2}; // on one of them
  CHECK(refused(image).find("no area") != std::string::npos);
  image[vertex({1, 1, 2})] = {NAN, 1, 2};
  CHECK(refused(image).find("not finite") != std::string::npos);
  // Beyond a neighbour, inside of the only square of a face.
  const Mapped large(Voxels({4, 4, 4}, true), same);
  image = large.image;
  *std::find(image.begin(), image.end(), Point{3, 1, 4}) = {3.9, 0.3, 4};
  CHECK(error_of([&] { (void)filled_polycube(large.solid.boundary, image, 4); }).find("inverted") !=
        std::string::npos);
  // Mirrored, the surface is seen from inside.
  image = cube.image;
  for (Point& p : image) p[0] = 2 - p[0];
  CHECK(refused(image).find("seen from outside") != std::string::npos);
  // Corners off the lattice.
  CHECK(refused(cube.image, 1.5).find("lies in no plane of the lattice") != std::string::npos);
  CHECK_THROWS_AS(filled_polycube(cube.solid.boundary, {}), PreconditionError);
  CHECK_THROWS_AS(filled_polycube(cube.solid.boundary, cube.image, 0), PreconditionError);
  CHECK_THROWS_AS(filled_polycube(cube.solid.boundary, cube.image, 1, 0), PreconditionError);
}

TEST_CASE("A frame is carried to a similar one exactly", "[polycube]") {
  Mapped m(frame(2, 2), similar);
  m.label(0, 2, 0);
  m.label(1, 2, 4);
  PolycubeOptions options;
  options.step = 2;
  PolycubeHexahedra made;
  for (const int cells : {3, 2}) { // with 3, corners are no vertices of the solid's mesh
    options.cells = cells;
    made = polycube_hexahedra(m.solid, m.image, m.base, options);
    // 8 x 2 cubes, each cut.
    CHECK(made.solid.mesh.hexahedra.size() == static_cast<std::size_t>(16 * cells * cells * cells));
    CHECK(made.solid.stuck.empty());
    CHECK(made.farthest < 1e-9);
    CHECK(quality(made.solid.mesh).minimum > 1 - 1e-6);
    CHECK(farthest(made, similar) < 1e-6);
  }
  options.threads = 2;
  CHECK(polycube_hexahedra(m.solid, m.image, m.base, options).solid.mesh.points == made.solid.mesh.points);
}

TEST_CASE("A frame sheared within its levels is found again", "[polycube]") {
  // The map takes verticals to verticals and levels to levels, so harmonic fields and fibres correspond; on
  // the floor it is linear on triangles.
  for (const int fine : {2, 4}) {
    Mapped m(frame(1, fine), sheared);
    m.label(0, 2, 0);
    m.label(1, 2, fine);
    PolycubeOptions options;
    options.step = fine;
    options.cells = fine;
    const PolycubeHexahedra made = polycube_hexahedra(m.solid, m.image, m.base, options);
    CHECK(made.solid.stuck.empty());
    CHECK(farthest(made, sheared) < 1e-6);
    CHECK(quality(made.solid.mesh).minimum > 0.5);
  }
}

TEST_CASE("A ball in the shape of an L is filled, from one end to the other", "[polycube]") {
  for (const int fine : {4, 8}) {
    Mapped m(corner(fine), similar);
    m.label(0, 0, 2 * fine);
    m.label(1, 2, 2 * fine);
    PolycubeOptions options;
    options.step = fine;
    options.cells = fine / 2;
    const PolycubeHexahedra made = polycube_hexahedra(m.solid, m.image, m.base, options);
    CHECK(made.solid.left_out == 0);
    CHECK(made.farthest < 1e-9);
    // The mesh of the cubes is that of the solid up to similarity, so corners come back to where they were,
    // but where fibres turn round the outer ridge, along which the field vanishes, and several become one.
    // An edge of the mesh is 2 long.
    double mean = 0;
    for (std::size_t v = 0; v < made.cubes.points.size(); ++v)
      mean += numeric::distance(similar(made.cubes.points[v]), made.solid.mesh.points[v]);
    CHECK(mean / static_cast<double>(made.cubes.points.size()) < 0.1 * 2);
    CHECK(farthest(made, similar) < 2 * 2);
    CHECK(quality(made.solid.mesh).minimum > 0.25);
  }
}

TEST_CASE("A floor that goes round a ridge is followed, where edges across it are split, too", "[polycube]") {
  Mapped m(Voxels({6, 2, 2}, true), similar);
  m.label(1, 0, 0);
  m.label(0, 0, 6);
  for (int t = 0; t < m.solid.boundary.triangle_count(); ++t) {
    const auto& v = m.solid.boundary.corners(t);
    if (std::all_of(v.begin(), v.end(), [&](int c) { return m.image[c][2] == 0 && m.image[c][0] >= 4; }))
      m.base[t] = 0;
  }
  PolycubeOptions options;
  options.step = 2;
  options.cells = 2;
  options.finer = 1;
  const PolycubeHexahedra made = polycube_hexahedra(m.solid, m.image, m.base, options);
  CHECK(made.solid.mesh.hexahedra.size() == 24);
  double mean = 0;
  for (std::size_t v = 0; v < made.cubes.points.size(); ++v)
    mean += numeric::distance(similar(made.cubes.points[v]), made.solid.mesh.points[v]);
  // As for the L: but for fibres that become one, an edge being 2 long.
  CHECK(mean / static_cast<double>(made.cubes.points.size()) < 0.1 * 2);
  CHECK(farthest(made, similar) < 2);
}

TEST_CASE("A solid that is its own polycube gets its own cubes back", "[polycube]") {
  // The harmonic map of the identity is the identity, whatever the mesh; what is at a vertex is found there.
  for (const Voxels& voxels : {corner(1), corner(2), frame(1, 2), Voxels({2, 2, 2}, true)}) {
    const Mapped m(voxels, same);
    const auto image = harmonic_image(m.solid, m.image);
    REQUIRE(image);
    for (std::size_t v = 0; v < image->size(); ++v)
      CHECK(numeric::distance((*image)[v], m.solid.mesh.points[v]) < 1e-12);
    CHECK(folded(m.solid, *image).empty());
    for (const int cells : {1, 2, 3}) {
      PolycubeOptions options;
      options.cells = cells;
      const PolycubeHexahedra made = pulled_back(m.solid, m.solid.mesh.points, options);
      CHECK(made.solid.left_out == 0);
      CHECK(made.solid.mesh.hexahedra == made.cubes.hexahedra);
      if (cells < 3) { // halves are exact
        CHECK(made.solid.mesh.points == made.cubes.points);
        CHECK(quality(made.solid.mesh).minimum == 1);
      }
      CHECK(farthest(made, same) < 1e-12);
      CHECK(quality(pulled_back(m.solid, *image, options).solid.mesh).minimum > 1 - 1e-9);
    }
  }
}

TEST_CASE("Random foldings of a solid's image are unfolded, and cubes carried by it", "[polycube]") {
  for (int seed = 0; seed < 20; ++seed) {
    const Mapped m(seed % 2 == 0 ? corner(3) : Voxels({3, 4, 3}, true), same);
    std::vector<Point> image = m.solid.mesh.points;
    support::Random random(seed);
    for (std::size_t v = 0; v < image.size(); ++v)
      for (double& x : image[v])
        if (m.solid.on_boundary[v] < 0) x += (0.5 + 0.1 * seed) * (2 * random.uniform() - 1);
    const bool was_folded = !folded(m.solid, image).empty();
    CHECK((was_folded || seed < 4));
    const auto unfolded = unfolded_image(m.solid, image);
    REQUIRE(unfolded);
    CHECK(folded(m.solid, *unfolded).empty());
    for (const int v : m.solid.vertex) REQUIRE((*unfolded)[v] == image[v]);
    const PolycubeHexahedra made = pulled_back(m.solid, *unfolded);
    CHECK(made.solid.left_out == 0);
    CHECK(quality(made.solid.mesh).bad.empty());
  }
  // A tetrahedron whose corners are all on the boundary cannot be helped: here those of a single cube.
  const Mapped cube(Voxels({1, 1, 1}, true), same);
  std::vector<Point> flat = cube.solid.mesh.points;
  for (Point& p : flat) p[2] = 0;
  CHECK_FALSE(unfolded_image(cube.solid, flat));
}

TEST_CASE("Cubes are carried by any map that folds nothing", "[polycube]") {
  // Corners of the cubes that are vertices of the mesh go where these are, and no others are asked for.
  for (const int fine : {2, 4}) {
    const Mapped m(frame(1, fine), sheared);
    PolycubeOptions options;
    options.step = fine;
    options.cells = fine;
    std::vector<Point> inside(m.solid.mesh.points.size());
    const auto cubes = support::mesh_of(frame(1, fine));
    for (std::size_t v = 0; v < inside.size(); ++v) inside[v] = cubes.points[v];
    const PolycubeHexahedra made = pulled_back(m.solid, inside, options);
    CHECK(made.solid.mesh.hexahedra.size() == static_cast<std::size_t>(8 * fine * fine * fine));
    CHECK(farthest(made, sheared) < 1e-12);
    CHECK(quality(made.solid.mesh).bad.empty());
    // By hand, of fine layers of (3 fine + 1)^2 points less (fine - 1)^2 in the hole, those inside: off both
    // planes, off the outside and off the hole's rim.
    const int ring = (3 * fine - 1) * (3 * fine - 1) - (fine + 1) * (fine + 1);
    CHECK(std::count(made.solid.on_boundary.begin(), made.solid.on_boundary.end(), 0) == ring * (fine - 1));
    // Neither a map that is not finite nor a folded one has an inverse.
    for (const double wild : {std::nan(""), HUGE_VAL}) {
      std::vector<Point> image = inside;
      image[5][1] = wild;
      CHECK_FALSE(folded(m.solid, image).empty());
    }
    std::swap(inside[0], inside[1]);
    CHECK_FALSE(folded(m.solid, inside).empty());
    CHECK_THROWS_AS(pulled_back(m.solid, inside, options), PreconditionError);
  }
  CHECK_THROWS_AS(harmonic_image(Mapped(corner(1), same).solid, {}), PreconditionError);
}

TEST_CASE("A surface that covers the polycube twice is refused", "[polycube]") {
  const Mapped m(frame(1, 2), same);
  const surface::Surface& once = m.solid.boundary;
  const int n = once.vertex_count();
  // Two copies, cut where y is between 3 and 4 on one side of the hole, and glued crosswise.
  std::vector<surface::Surface::Triangle> triangles;
  for (const int copy : {0, 1})
    for (surface::Surface::Triangle t : once.triangles()) {
      const auto height = [&](int v) { return m.image[v][1]; };
      const auto [low, high] = std::minmax({height(t[0]), height(t[1]), height(t[2])});
      const bool is_cut = low <= 3 && high >= 4 && m.image[t[0]][0] >= 4;
      for (int& v : t) v += (is_cut && height(v) >= 4 ? 1 - copy : copy) * n;
      triangles.push_back(t);
    }
  std::vector<Point> image = m.image;
  image.insert(image.end(), m.image.begin(), m.image.end());
  const surface::Surface twice(2 * n, triangles);
  REQUIRE(surface::parts(twice).count == 1);
  REQUIRE(error_of([&] { (void)filled_polycube(once, m.image, 2); }).empty());
  CHECK(error_of([&] { (void)filled_polycube(twice, image, 2); }).find("squares instead of") !=
        std::string::npos);
}

TEST_CASE("Bases whose rims do not follow the lattice are refused", "[polycube]") {
  Mapped m(frame(1, 2), same);
  m.label(0, 2, 0);
  m.label(1, 2, 2);
  PolycubeOptions options;
  options.step = 2;
  options.cells = 1;
  options.finer = 1;
  CHECK(error_of([&] { (void)polycube_hexahedra(m.solid, m.image, m.base, options); }).empty());
  // Of a square of the lattice on the outer wall, two triangles of eight go to the floor.
  std::vector<int> base = m.base;
  int moved = 0;
  for (int t = 0; t < m.solid.boundary.triangle_count(); ++t) {
    const auto& v = m.solid.boundary.corners(t);
    bool is_below = true;
    for (int c = 0; c < 3; ++c)
      is_below = is_below && m.image[v[c]][1] == 0 && m.image[v[c]][2] <= 1 && m.image[v[c]][0] <= 1;
    if (is_below) base[t] = 0, ++moved;
  }
  CHECK(moved == 2);
  CHECK(error_of([&] {
          (void)polycube_hexahedra(m.solid, m.image, base, options);
        }).find("does not follow") != std::string::npos);
}
