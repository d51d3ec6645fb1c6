// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/show/product.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/scene/files.hpp"
#include "tetrarch/scene/palette.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace tetrarch::show {

using namespace scene;

namespace {

/// How thick lines are in terms of the whole picture.
constexpr double line_share = 1.0 / 600;

void require_coordinates(const product::Solid& solid, const std::vector<Point>& uvw) {
  if (uvw.size() == solid.mesh.points.size()) return;
  throw PreconditionError(std::to_string(uvw.size()) + " coordinates for " +
                          std::to_string(solid.mesh.points.size()) + " vertices");
}

/// The boundary with its vertices at `places`, those of the mesh.
Surface boundary_at(const std::vector<Point>& places, const product::Solid& solid,
                    const product::Partition& partition, const std::vector<Point>& uvw) {
  require_coordinates(solid, uvw);
  Surface out;
  out.point_fields = {{"w", {}}};
  for (const int v : solid.vertex) {
    const auto& [u_, v_, w_] = uvw[static_cast<std::size_t>(v)];
    out.points.push_back(places[static_cast<std::size_t>(v)]);
    out.textures.push_back({u_, v_});
    out.point_fields[0].values.push_back(w_);
  }
  out.triangles = solid.boundary.triangles();
  out.data = {{"patch", partition.patch}};
  out.colors.reserve(partition.patch.size());
  for (const int patch : partition.patch) out.colors.push_back(qualitative(patch));
  return out;
}

void set_radius(Tubes& tubes) {
  if (!tubes.points.empty())
    tubes.radii.assign(tubes.points.size(), line_share * numeric::extent(tubes.points));
}

} // namespace

Cells product_cells(const product::Solid& solid, const std::vector<Point>& uvw) {
  require_coordinates(solid, uvw);
  Cells out;
  out.name = "solid";
  out.points = solid.mesh.points;
  out.tetrahedra = solid.mesh.tetrahedra;
  out.textures = uvw;
  Field height{"w", {}};
  height.values.reserve(uvw.size());
  for (const Point& at : uvw) height.values.push_back(at[2]);
  out.point_fields.push_back(std::move(height));
  return out;
}

Cells domain_cells(const product::Solid& solid, const std::vector<Point>& uvw) {
  Cells out = product_cells(solid, uvw);
  out.name = "domain";
  out.points = uvw;
  return out;
}

Surface boundary_surface(const product::Solid& solid, const product::Partition& partition,
                         const std::vector<Point>& uvw) {
  Surface out = boundary_at(solid.mesh.points, solid, partition, uvw);
  out.name = "solid";
  return out;
}

Surface domain_surface(const product::Solid& solid, const product::Partition& partition,
                       const std::vector<Point>& uvw) {
  Surface out = boundary_at(uvw, solid, partition, uvw);
  out.name = "domain";
  return out;
}

Tubes fibers(const std::vector<std::vector<Point>>& paths) {
  Tubes out;
  out.name = "fibres";
  out.data = {{"fiber", {}}};
  for (const std::vector<Point>& path : paths) {
    out.points.insert(out.points.end(), path.begin(), path.end());
    out.starts.push_back(static_cast<int>(out.points.size()));
    out.data[0].values.push_back(static_cast<int>(out.data[0].values.size()));
  }
  out.colors = {{60, 60, 60, 255}};
  set_radius(out);
  return out;
}

Cells hexahedra(const std::vector<Point>& points, const std::vector<std::array<int, 8>>& cells,
                const HexahedraData& data) {
  Cells out;
  out.name = "hexahedra";
  out.points = points;
  out.hexahedra = cells;
  out.data = {{"layer", data.layer}};
  out.cell_fields = {{"quality", data.quality}};
  return out;
}

Tubes outer_edges(const Cells& hexahedra) {
  Cells bare;
  bare.points = hexahedra.points;
  bare.hexahedra = hexahedra.hexahedra;
  const Surface faces = outer_faces(bare);
  // Quadrilaterals abcd come as abc, acd.
  std::vector<std::array<int, 2>> edges;
  edges.reserve(2 * faces.triangles.size());
  for (std::size_t t = 0; t + 1 < faces.triangles.size(); t += 2) {
    const auto& [a, b, c] = faces.triangles[t];
    const int d = faces.triangles[t + 1][2];
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
      edges.push_back({std::min(from, to), std::max(from, to)});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Tubes out;
  out.name = "edges";
  for (const auto& [from, to] : edges) {
    out.points.insert(out.points.end(), {faces.points[from], faces.points[to]});
    out.starts.push_back(static_cast<int>(out.points.size()));
  }
  out.colors = {{60, 60, 60, 255}};
  set_radius(out);
  return out;
}

} // namespace tetrarch::show
