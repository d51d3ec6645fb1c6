// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/filling.hpp"

#include "product/solids.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/format/mesh_json.hpp"

#include <catch2/catch.hpp>
#include <utility>

using namespace tetrarch;
using namespace tetrarch::workshop;

namespace {

/// 3 x 2 x 1, as a file gives it.
format::Soup brick() {
  solid::TetMesh mesh = support::box({3, 2, 1}, {3, 2, 1}, 0).mesh;
  format::Soup soup;
  soup.points = std::move(mesh.points);
  soup.tetrahedra = std::move(mesh.tetrahedra);
  return soup;
}

} // namespace

TEST_CASE("hexahedra that fill a brick have its volume", "[workshop]") {
  hex::FillOptions options;
  options.edge = 0.5;
  const FilledSolid found = filled_solid(solid_of(brick()), options);
  CHECK(found.verdict() == Verdict::yes);
  const format::MeshDocument document = document_of(found);
  product::HexMesh written;
  written.points = document.soup.points;
  written.hexahedra = document.hexahedra;
  CHECK(product::volume(written) == Approx(3 * 2 * 1).epsilon(1e-9));
  CHECK(document.fields.front().values.size() == written.hexahedra.size());

  const Tree tree = tree_of(found);
  CHECK(tree["hexahedra"].integer() == static_cast<int>(written.hexahedra.size()));
  CHECK(tree["inverted"].integer() == 0);
  CHECK(tree["volume_ratio"].number() == Approx(1).epsilon(1e-9));
  int in_bins = 0;
  for (const Tree& bin : tree["histogram"]) in_bins += bin.integer();
  CHECK(in_bins == tree["hexahedra"].integer());
  CHECK(tree["worst"].size() == product::worst_named);
}

TEST_CASE("what encloses no solid is not filled", "[workshop]") {
  format::Soup flat = brick();
  for (auto& point : flat.points) point[2] = 0;
  CHECK_THROWS_AS(solid_of(flat), InputError);
  format::Soup twice = brick(); // the same beside itself
  const auto count = static_cast<int>(twice.points.size());
  for (int v = 0; v < count; ++v) {
    const product::Point p = twice.points[static_cast<std::size_t>(v)];
    twice.points.push_back({p[0] + 10, p[1], p[2]});
  }
  for (const std::array<int, 4>& t : brick().tetrahedra)
    twice.tetrahedra.push_back({t[0] + count, t[1] + count, t[2] + count, t[3] + count});
  CHECK_THROWS_AS(solid_of(twice), InputError);
}

TEST_CASE("where no grid fits the answer is undecided, with its reason", "[workshop]") {
  FilledSolid none;
  none.search.ending = hex::Ending::memory;
  CHECK(none.verdict() == Verdict::undecided);
  CHECK(none.doubts().size() == 2);
  const Tree tree = tree_of(none);
  CHECK(tree["hexahedra"].integer() == 0);
  CHECK(tree["ended_by"].text() == "memory");
  CHECK_THROWS(tree["volume_ratio"]);
  CHECK_THROWS_AS(document_of(none), PreconditionError);
}
