// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/product.hpp"

#include "product/solids.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"
#include "tetrarch/product/polycube.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

/// Floor and ceiling as the solid was made.
ProductOptions between_ends(const support::Extrusion& from) {
  ProductOptions options;
  options.is_partition_given = true;
  options.partition = [&from](product::Solid solid) {
    PartitionedSolid start;
    start.partition = product::partition(solid, support::bases(solid, from));
    start.solid = std::move(solid);
    start.how = "as made";
    return start;
  };
  return options;
}

/// A column whose cross-section turns by so many radians from floor to ceiling.
support::Extrusion column(double turn) {
  support::Extrusion result = support::box({1, 1, 3}, {3, 3, 9}, 0);
  for (product::Point& p : result.mesh.points) {
    const double angle = turn * p[2] / 3;
    const double x = p[0] - 0.5;
    const double y = p[1] - 0.5;
    p = {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, p[2]};
  }
  return result;
}

double det(const product::Point& a, const product::Point& b, const product::Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Tetrahedra of no positive volume in the domain, those that are flat up to rounding among them.
std::size_t turned_over(const format::MeshDocument& document) {
  const std::vector<double>& uvw = document.fields.front().values;
  const auto edge = [&](int from, int to) {
    product::Point e{};
    for (std::size_t c = 0; c < 3; ++c)
      e[c] = uvw[3 * static_cast<std::size_t>(to) + c] - uvw[3 * static_cast<std::size_t>(from) + c];
    return e;
  };
  std::size_t count = 0;
  for (const std::array<int, 4>& t : document.soup.tetrahedra)
    if (det(edge(t[0], t[1]), edge(t[0], t[2]), edge(t[0], t[3])) < 1e-12) ++count;
  return count;
}

/// Each member of a result is listed, and no name is listed twice.
void check_members(const SolidProduct& found) {
  Tree rest = tree_of(found);
  CHECK(rest.size() > 1);
  std::set<std::string> names;
  for (const FieldNote& note : notes_of<SolidProduct>()) {
    INFO(note.name);
    CHECK(names.insert(note.name).second);
    CHECK(std::string(note.meaning).size() > 3);
    rest.erase(note.name);
  }
  CHECK(rest.empty());
}

PolycubeImage own_image(const solid::TetMesh& mesh) {
  PolycubeImage polycube;
  polycube.name = "cubes";
  polycube.image = mesh.points;
  polycube.cells = 2;
  return polycube;
}

/// Eight cubes of edge 1/2, and the point that they share.
product::HexMesh eight_cubes(const product::Point& middle) {
  product::Polycube cubes{0.5, {}};
  for (int k = 0; k < 8; ++k) cubes.cubes.push_back({k >> 2, k >> 1 & 1, k & 1});
  product::HexMesh mesh = product::hexahedra(cubes);
  for (product::Point& p : mesh.points)
    if (p == product::Point{0.5, 0.5, 0.5}) p = middle;
  return mesh;
}

} // namespace

TEST_CASE("a box is a product, and its hexahedra are cuboids of its volume", "[workshop]") {
  const support::Extrusion box = support::box({2, 1, 0.5}, {6, 3, 3});
  ProductOptions options = between_ends(box);
  options.across = 4;
  options.layers = 3;
  const SolidProduct found = solid_product(product::solid_of(box.mesh), options);
  CHECK(found.verdict() == Verdict::yes);
  CHECK(found.doubts().empty());
  REQUIRE(found.hexahedra);
  REQUIRE(found.hexahedra->grid);
  CHECK(found.hexahedra->of.mesh.hexahedra.size() == 3 * found.hexahedra->grid->cells.size());
  CHECK(found.hexahedra->volume == Approx(2 * 1 * 0.5).epsilon(1e-9));
  CHECK(found.hexahedra->quality.minimum == Approx(1).epsilon(1e-6));
  check_members(found);

  const Tree tree = tree_of(found);
  CHECK(tree["partition"]["how"].text() == "as made");
  // By hand: two triangles to a square.
  CHECK(tree["partition"]["floor"].integer() == 2 * 6 * 3);
  CHECK(tree["partition"]["walls"].front().integer() == 2 * 3 * (6 + 3 + 6 + 3));
  CHECK(tree["holes"].integer() == 0);
  CHECK(tree["volume"]["solid"].number() == Approx(1));
  CHECK(tree["product"]["verdict"].text() == "yes");
  CHECK(tree["filling"]["doubts"].empty());
  CHECK(rows_of(found).back().second.starts_with("yes: "));
  CHECK(document_of(found).hexahedra.size() == found.hexahedra->of.mesh.hexahedra.size());
}

TEST_CASE("the field of a box rises evenly, and so do its coordinates", "[workshop]") {
  const support::Extrusion box = support::box({2, 1, 0.5}, {6, 3, 3});
  ProductOptions options = between_ends(box);
  options.height = 7;
  const SolidProduct found = solid_product(product::solid_of(box.mesh), options);
  CHECK(found.verdict() == Verdict::yes);
  CHECK_FALSE(found.hexahedra);
  REQUIRE(found.fibered);
  REQUIRE(found.fibered->coordinates);
  const std::vector<product::Point>& uvw = found.fibered->coordinates->of.uvw;
  for (std::size_t v = 0; v < box.mesh.points.size(); ++v)
    CHECK(uvw[v][2] == Approx(7 * box.mesh.points[v][2] / 0.5).margin(1e-6));
  CHECK(found.fibered->coordinates->fibers.size() == found.fibered->coordinates->straight.size());
  CHECK(turned_over(document_of(found)) == 0);
  check_members(found);
}

TEST_CASE("a column that turns folds its coordinates: undecided, and each fold is told", "[workshop]") {
  const support::Extrusion turned = column(5);
  const SolidProduct found = solid_product(product::solid_of(turned.mesh), between_ends(turned));
  REQUIRE(found.fibered);
  CHECK(found.fibered->critical.none());
  REQUIRE(found.fibered->coordinates);
  const std::size_t folds = turned_over(document_of(found));
  REQUIRE(folds > 0);
  CHECK(found.verdict() == Verdict::undecided);
  CHECK(found.doubts().front() == std::to_string(folds) + " tetrahedra flipped");
  const Tree tree = tree_of(found);
  CHECK(tree["product"]["verdict"].text() == "undecided");
  CHECK(tree["flipped"].integer() == static_cast<int>(folds));
  CHECK(tree["flipped_tetrahedra"].size() == folds);
}

TEST_CASE("a partition is searched for if nobody gives one", "[workshop]") {
  const SolidProduct found = solid_product(product::solid_of(support::plate(2, 4, 2).mesh));
  CHECK(found.sides.holes() == 2);
  REQUIRE(found.sides.triangles.size() == 5); // floor, ceiling, and three walls
  CHECK(found.sides.triangles[0] == found.sides.triangles[1]);
  const std::vector<int>& tags = document_of(found).soup.triangle_tags;
  CHECK(std::set<int>(tags.begin(), tags.end()) == std::set<int>{1, 2, 3, 4, 5});
}

TEST_CASE("a solid that is its own polycube gets its cubes, without a partition", "[workshop]") {
  const solid::TetMesh box = support::box({2, 1, 1}, {2, 1, 1}, 0).mesh;
  ProductOptions options;
  options.polycube = own_image(box);
  const SolidProduct found = solid_product(product::solid_of(box), options);
  CHECK(found.verdict() == Verdict::yes);
  CHECK(found.is_of_polycube());
  CHECK_FALSE(found.fibered);
  CHECK_FALSE(found.sides.is_divided());
  REQUIRE(found.hexahedra);
  CHECK(found.hexahedra->of.mesh.hexahedra.size() == 2 * 8);
  CHECK(found.hexahedra->volume == 2);
  CHECK(found.hexahedra->quality.minimum == 1);
  CHECK(tree_of(found)["carried_by"].text() == "the map in the file");
  CHECK(tree_of(found)["tetrahedra"].integer() == static_cast<int>(box.tetrahedra.size()));
  check_members(found);
}

TEST_CASE("cubes do without a partition that cannot be had, unless somebody gave it", "[workshop]") {
  const solid::TetMesh box = support::box({2, 1, 1}, {2, 1, 1}, 0).mesh;
  ProductOptions options;
  options.name = "brick";
  options.polycube = own_image(box);
  options.partition = [](product::Solid) -> PartitionedSolid { throw InputError("no floor"); };
  options.wants_coordinates = true;
  const SolidProduct found = solid_product(product::solid_of(box), options);
  CHECK(found.verdict() == Verdict::yes);
  CHECK(found.why_undivided == "brick: no floor");
  check_members(found);
  options.is_partition_given = true;
  CHECK_THROWS_WITH(solid_product(product::solid_of(box), options), "brick: no floor");
}

TEST_CASE("what cannot be is refused", "[workshop]") {
  const solid::TetMesh box = support::box({2, 1, 1}, {2, 1, 1}, 0).mesh;
  ProductOptions options;
  options.polycube = own_image(box);
  options.across = 3;
  CHECK_THROWS_AS(solid_product(product::solid_of(box), options), PreconditionError);
  options.across = 0;
  options.polycube->image.pop_back();
  CHECK_THROWS_WITH(solid_product(product::solid_of(box), options), Catch::StartsWith("cubes: "));
  CHECK_THROWS_AS(document_of(SolidProduct()), PreconditionError);
  CHECK_THROWS_AS(FiberedSolid().doubts(), PreconditionError);
}

TEST_CASE("critical points are a no, a floor without a map is none", "[workshop]") {
  const support::Extrusion box = support::box({1, 1, 1}, {3, 3, 3});
  SolidProduct found = solid_product(product::solid_of(box.mesh), between_ends(box));
  REQUIRE(found.verdict() == Verdict::yes);
  found.fibered->floor.found = false;
  CHECK(found.verdict() == Verdict::undecided);
  found.fibered->critical.vertices.push_back({20, 2, 1, false});
  CHECK(found.verdict() == Verdict::proved_no);
  CHECK(found.doubts() == std::vector<std::string>{"the field has critical points"});
  CHECK(tree_of(found)["critical"]["vertices"].front()["vertex"].integer() == 20);
  found.hexahedra.emplace().carried_by = "hand"; // cubes are the result, whatever the field is like
  CHECK(found.verdict() == Verdict::undecided);
  CHECK(found.doubts() == std::vector<std::string>{"there are no hexahedra"});
}

TEST_CASE("hexahedra are improved inside and measured", "[workshop]") {
  const product::Solid cube = product::solid_of(support::box({1, 1, 1}, {2, 2, 2}, 0).mesh);
  MeasuredHexahedra found;
  found.of.mesh = eight_cubes({0.9, 0.8, 0.85});
  found.of.on_boundary.assign(found.of.mesh.points.size(), 1);
  for (std::size_t k = 0; k < found.of.mesh.points.size(); ++k)
    if (found.of.mesh.points[k][2] == 0.85) found.of.on_boundary[k] = 0;
  const double before = product::quality(found.of.mesh).minimum;
  REQUIRE(before < 0); // some are inverted
  HexahedraOptions options;
  options.smooth = true;
  improve_and_measure(found, measure_of(cube), options);
  CHECK(found.quality.minimum > before);
  CHECK(found.quality.minimum == Approx(1).epsilon(0.05)); // the best place is the middle
  CHECK(found.volume == Approx(1));
  CHECK(found.solid_volume == Approx(1));
  CHECK(found.deviation.relative() < 1e-12);
  CHECK(found.doubts().empty());
  const Tree tree = tree_of(found);
  CHECK(tree["untangling"]["min_scaled_jacobian_before"].number() == before);
  CHECK(tree["smoothing"]["sweeps"].integer() == found.smoothing->done.sweeps);
  int in_bins = 0;
  for (const Tree& bin : tree["histogram"]["counts"]) in_bins += bin.integer();
  CHECK(in_bins == 8);

  found.of.left_out = 3;
  found.of.mesh.hexahedra.pop_back();
  improve_and_measure(found, measure_of(cube));
  REQUIRE(found.doubts().size() == 2);
  CHECK(found.doubts()[0] == "3 hexahedra left out");
  CHECK(found.volume_error() == Approx(1. / 8).epsilon(0.05));
  CHECK(tree_of(found)["filling"]["verdict"].text() == "undecided");
}

TEST_CASE("a box as thin as a sheet has a map of numbers, or says what is missing", "[workshop]") {
  for (const double thin : {1e-4, 1e-8, 1e-12}) {
    INFO(thin);
    const support::Extrusion box = support::box({2, 4, 8 * thin}, {2, 4, 8}, 0);
    ProductOptions options = between_ends(box);
    options.across = 2;
    const SolidProduct found = solid_product(product::solid_of(box.mesh), options);
    REQUIRE(found.fibered);
    if (!found.fibered->coordinates) {
      CHECK(found.verdict() != Verdict::yes);
      continue;
    }
    const FiberedSolid::Coordinates& coordinates = *found.fibered->coordinates;
    for (const product::Point& p : coordinates.of.uvw)
      for (const double x : p) REQUIRE(std::isfinite(x));
    CHECK(std::isfinite(coordinates.confirmation.mean_distance));
    if (found.hexahedra)
      for (const product::Point& p : found.hexahedra->of.mesh.points)
        for (const double x : p) REQUIRE(std::isfinite(x));
    const bool good = coordinates.of.stuck.empty() && coordinates.quality.flipped.empty();
    CHECK((found.verdict() != Verdict::yes || good));
  }
}
