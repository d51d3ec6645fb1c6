// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/solid/tet_mesh.hpp"

#include "support/random.hpp"
#include "support/soups.hpp"
#include "tetrarch/core/check.hpp"
#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/mesh_files.hpp"

#include <catch2/catch.hpp>

using namespace tetrarch;
using namespace tetrarch::solid;
using namespace tetrarch::doctor;
using namespace tetrarch::support::soups;

namespace {

/// The second route to the gluings: every pair of faces is compared.
Triangulation naive_triangulation_of(const TetMesh& mesh) {
  Triangulation tri(static_cast<int>(mesh.tetrahedra.size()));
  for (int t = 0; t < tri.size(); ++t)
    for (int u = 0; u < t; ++u) {
      const auto& a = mesh.tetrahedra[static_cast<std::size_t>(t)];
      const auto& b = mesh.tetrahedra[static_cast<std::size_t>(u)];
      for (int r = 0; r < Perm4::count; ++r) {
        const Perm4 p = Perm4::from_rank(r);
        int common = 0;
        int other = 0;
        for (int v = 0; v < 4; ++v) {
          common += a[v] == b[p[v]];
          if (a[v] != b[p[v]]) other = v;
        }
        if (common == 3) tri.glue({t, other}, u, p);
      }
    }
  return tri;
}

/// A ball of cubes as support::cubical_ball makes it, with points on the integer grid.
TetMesh grid(int n) {
  TetMesh mesh;
  for (double x = 0; x <= n; ++x)
    for (double y = 0; y <= n; ++y)
      for (double z = 0; z <= n; ++z) mesh.points.push_back({x, y, z});
  const auto point = [&](const std::array<int, 3>& at) {
    return (at[0] * (n + 1) + at[1]) * (n + 1) + at[2];
  };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (const auto& order : support::detail::axis_order) {
          std::array<int, 3> at{x, y, z};
          std::array<int, 4> tetrahedron{point(at)};
          for (std::size_t k = 0; k < 3; ++k) {
            ++at[static_cast<std::size_t>(order[k])];
            tetrahedron[k + 1] = point(at);
          }
          mesh.tetrahedra.push_back(tetrahedron);
        }
  return mesh;
}

} // namespace

TEST_CASE("the knotted Y's mesh becomes a triangulation", "[solid]") {
  const std::string path = std::string(TETRARCH_SOURCE_DIR) + "/tests/data/knotted_y_8k.mesh";
  const TetMesh mesh = build(format::read_soup_file(path));
  const Triangulation tri = triangulation_of(mesh);
  CHECK(tri.size() == 7709); // as the file's header says
  const Skeleton skeleton(tri);
  CHECK(is_valid(skeleton));
  CHECK(skeleton.vertex_count() == 1916);
  CHECK(skeleton.component_count() == 1);
  CHECK(skeleton.is_orientable());
  // A handlebody's worth of boundary: genus 2, so chi(M) = chi(boundary) / 2 = -1.
  CHECK(skeleton.vertex_count() - skeleton.edge_count() + skeleton.face_count() - tri.size() == -1);
}

TEST_CASE("a grid of points becomes the cubical ball", "[solid]") {
  for (int n = 1; n <= 3; ++n) CHECK(triangulation_of(grid(n)) == support::cubical_ball(n, n, n));
}

TEST_CASE("faces are found as by comparing all of them", "[solid]") {
  support::Random random(5);
  for (int round = 0; round < 20; ++round) {
    TetMesh mesh = grid(2);
    // Another numbering of the points, tetrahedra and corners; and some tetrahedra missing.
    std::vector<int> image(mesh.points.size());
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = static_cast<int>(i);
    random.shuffle(image);
    random.shuffle(mesh.tetrahedra);
    mesh.tetrahedra.resize(40);
    for (auto& corners : mesh.tetrahedra) {
      const Perm4 order = random.perm();
      const auto old = corners;
      for (int v = 0; v < 4; ++v) corners[v] = image[static_cast<std::size_t>(old[order[v]])];
    }
    CHECK(triangulation_of(mesh) == naive_triangulation_of(mesh));
  }
}
