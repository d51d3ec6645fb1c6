// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_hexahedra.hpp"

#include "in_file.hpp"
#include "input.hpp"
#include "product_report.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/product/polycube.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetrarch::program {
namespace {

using product::Point;

/// Smoothed if wanted, measured and told.
void add_quality(SolidProduct& made, double solid_volume, const HexahedraOptions& options,
                 const Progress& progress) {
  product::HexQuality quality = product::quality(made.hexahedra->mesh);
  if (options.smooth) {
    const product::HexQuality before = std::move(quality);
    const product::Smoothed smoothed =
        product::smooth(made.hexahedra->mesh, made.hexahedra->on_boundary, {}, progress);
    made.report.add(smoothed_report(smoothed, before));
    quality = product::quality(made.hexahedra->mesh);
  }
  const MeasuredHexahedra measured{*made.hexahedra, quality, product::volume(made.hexahedra->mesh),
                                   solid_volume};
  made.report.add(hexahedra_report(measured));
  const std::vector<std::string> doubts = doubts_about(measured, options.volume_tolerance);
  made.report.add(verdict_report(
      {"filling", "a mesh of it", doubts, "no hexahedron is inverted or left out, and the volume agrees"}));
  made.doubts.insert(made.doubts.end(), doubts.begin(), doubts.end());
  made.scaled_jacobian = std::move(quality.scaled_jacobian);
}

} // namespace

void add_hexahedra(SolidProduct& made, const product::FiberField& field, const product::FloorMap& floor,
                   const HexahedraOptions& options, const Context& context) {
  const product::FloorGrid grid =
      product::floor_grid(floor.height, floor.rectangles, {.across = options.across});
  product::HexOptions hex;
  hex.threads = context.threads;
  hex.layers = options.layers > 0
                   ? options.layers
                   : std::max(1, static_cast<int>(std::lround(options.across * field.height())));
  made.hexahedra = product::hexahedra(field, grid, product::nodes_on_floor(field.solid(), floor, grid), hex,
                                      context.progress);
  made.cells = static_cast<int>(grid.cells.size());
  made.report.add(grid_report(grid));
  add_quality(made, product::volume(field.solid()), options, context.progress);
}

/// Vertex k of the file is the image of vertex k of the solid; those inside are passed over.
void add_polycube(SolidProduct& made, const product::Solid& solid, const product::Partition& partition,
                  const HexahedraOptions& options, const Context& context) {
  const format::Soup soup = read_soup(options.polycube, context);
  std::vector<Point> image;
  image.reserve(solid.vertex.size());
  for (const int v : solid.vertex) {
    if (v >= static_cast<int>(soup.points.size()))
      throw InputError({options.polycube, 0},
                       "the polycube has no image of vertex v" + std::to_string(v) + ": the file has " +
                           counted(static_cast<long long>(soup.points.size()), "vertex"));
    image.push_back(soup.points[v]);
  }
  std::vector<int> base;
  base.reserve(partition.patch.size());
  for (const int patch : partition.patch) base.push_back(patch < product::first_wall ? patch : -1);
  product::PolycubeOptions polycube;
  polycube.step = options.step;
  polycube.cells = options.cells;
  polycube.threads = context.threads;
  product::PolycubeHexahedra found = in_file(options.polycube, [&] {
    return product::polycube_hexahedra(solid, image, base, polycube, context.progress);
  });
  made.hexahedra = std::move(found.solid);
  add_quality(made, product::volume(solid), options, context.progress);
}

} // namespace tetrarch::program
