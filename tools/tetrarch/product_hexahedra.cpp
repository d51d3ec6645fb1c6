// SPDX-License-Identifier: GPL-2.0-or-later
#include "product_hexahedra.hpp"

#include "in_file.hpp"
#include "input.hpp"
#include "product_report.hpp"
#include "text.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/product/polycube.hpp"
#include "tetrarch/product/polycube_pullback.hpp"
#include "tetrarch/product/untangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tetrarch::program {
namespace {

using product::Point;

/// Meshes with a lesser scaled Jacobian are untangled before they are smoothed.
constexpr double smooth_enough = 0.2;

/// Untangled and smoothed if wanted, measured and told.
void add_quality(SolidProduct& made, const MeasuredSolid& solid, const HexahedraOptions& options,
                 const Progress& progress) {
  product::HexQuality quality = product::quality(made.hexahedra->mesh);
  if (options.smooth) {
    const product::HexQuality before = std::move(quality);
    // Points move one at a time in smoothing, which seldom undoes a tangle.
    if (before.minimum < smooth_enough)
      made.report.add(untangled_report(product::untangle(made.hexahedra->mesh, {}, progress)));
    const product::Smoothed smoothed =
        product::smooth(made.hexahedra->mesh, made.hexahedra->on_boundary, {}, progress);
    made.report.add(smoothed_report(smoothed, before));
    quality = product::quality(made.hexahedra->mesh);
  }
  const MeasuredHexahedra measured{*made.hexahedra, quality, product::volume(made.hexahedra->mesh),
                                   solid.volume, hex::deviation(solid.boundary, made.hexahedra->mesh)};
  made.report.add(hexahedra_report(measured));
  const std::vector<std::string> doubts = doubts_about(measured, options.volume_tolerance);
  made.report.add(verdict_report(
      {"filling", "a mesh of it", doubts, "no hexahedron is inverted or left out, and the volume agrees"}));
  made.doubts.insert(made.doubts.end(), doubts.begin(), doubts.end());
  made.scaled_jacobian = std::move(quality.scaled_jacobian);
}

/// Of each vertex of the solid's boundary.
std::vector<Point> boundary_images(const product::Solid& solid, const std::vector<Point>& image,
                                   const std::string& path) {
  std::vector<Point> result;
  result.reserve(solid.vertex.size());
  for (const int v : solid.vertex) {
    if (v >= static_cast<int>(image.size()))
      throw InputError({path, 0}, "the polycube has no image of vertex v" + std::to_string(v) +
                                      ": the file has " +
                                      counted(static_cast<long long>(image.size()), "vertex"));
    result.push_back(image[v]);
  }
  return result;
}

product::PolycubeOptions lattice(const HexahedraOptions& options, const Context& context) {
  product::PolycubeOptions result;
  result.step = options.step;
  result.cells = options.cells;
  result.threads = context.threads;
  return result;
}

/// Taken if better: fewer left out, or as many and of better quality.
void offer(CarriedCubes& best, product::SolidHexahedra found, const char* how) {
  product::HexQuality quality = product::quality(found.mesh);
  if (best.hexahedra &&
      (found.left_out > best.hexahedra->left_out ||
       (found.left_out == best.hexahedra->left_out && !product::is_better(quality, best.quality))))
    return;
  best = {std::move(found), std::move(quality), how};
}

} // namespace

MeasuredSolid measured(const product::Solid& solid) {
  return {product::volume(solid), hex::boundary_triangles(solid)};
}

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
  add_quality(made, measured(field.solid()), options, context.progress);
}

bool CarriedCubes::is_good() const {
  // Above 0.2 solvers are content; below, another way may do better.
  constexpr double content = 0.2;
  return hexahedra && hexahedra->left_out == 0 && quality.bad.empty() && quality.minimum >= content;
}

CarriedCubes carried_by_map(const product::Solid& solid, const format::Soup& polycube,
                            const HexahedraOptions& options, const Context& context) {
  const std::vector<Point> boundary = boundary_images(solid, polycube.points, options.polycube);
  CarriedCubes best;
  const auto try_map = [&](const std::vector<Point>& image, const char* how) {
    if (!product::folded(solid, image).empty()) return;
    product::PolycubeHexahedra found = in_file(options.polycube, [&] {
      return product::pulled_back(solid, image, lattice(options, context), context.progress);
    });
    offer(best, std::move(found.solid), how);
  };
  const std::size_t count = solid.mesh.points.size();
  if (polycube.points.size() >= count)
    try_map({polycube.points.begin(), polycube.points.begin() + static_cast<std::ptrdiff_t>(count)},
            "the map in the file");
  for (const bool clamped : {false, true}) {
    if (best.is_good()) break;
    if (const auto image = product::harmonic_image(solid, boundary, clamped))
      try_map(*image, clamped ? "a harmonic map, with clamped weights" : "a harmonic map");
  }
  if (!best.is_good())
    if (const auto start = product::harmonic_image(solid, boundary, true))
      if (const auto image = product::unfolded_image(solid, *start, context.progress))
        try_map(*image, "an unfolded map");
  return best;
}

void try_fibers(CarriedCubes& carried, const PartitionedSolid& start, const format::Soup& polycube,
                const HexahedraOptions& options, const Context& context) {
  std::vector<Point> image = polycube.points;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  image.resize(start.solid.mesh.points.size() - start.splits.size(), {none, none, none});
  for (const mesh::EdgePoint& s : start.splits) {
    Point p = image[s.from];
    for (std::size_t a = 0; a < 3; ++a) p[a] += s.part * (image[s.to][a] - p[a]);
    image.push_back(p);
  }
  std::vector<int> base;
  base.reserve(start.partition.patch.size());
  for (const int patch : start.partition.patch) base.push_back(patch < product::first_wall ? patch : -1);
  try {
    product::PolycubeHexahedra found = in_file(options.polycube, [&] {
      return product::polycube_hexahedra(start.solid, boundary_images(start.solid, image, options.polycube),
                                         base, lattice(options, context), context.progress);
    });
    offer(carried, std::move(found.solid), "fibers");
  } catch (const InputError&) { // the partition does not fit the lattice: what there is has to do
    if (!carried.hexahedra) throw;
  }
}

void add_polycube(SolidProduct& made, CarriedCubes carried, const MeasuredSolid& solid,
                  const HexahedraOptions& options, const Context& context) {
  if (!carried.hexahedra) throw PreconditionError("add_polycube: there are no hexahedra");
  made.hexahedra = std::move(carried.hexahedra);
  made.report.json["carried_by"] = carried.how;
  made.report.rows.emplace_back("cubes carried by", carried.how);
  add_quality(made, solid, options, context.progress);
}

} // namespace tetrarch::program
