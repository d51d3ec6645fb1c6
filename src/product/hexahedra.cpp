// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/hexahedra.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/parallel.hpp"

#include <algorithm>
#include <utility>

namespace tetrarch::product {
namespace {

/// What a fibre leaves behind: fewer points than levels if it was stuck.
struct Column {
  std::vector<Point> points;
  StuckNode stuck;
};

Column climbed(const FiberField& field, const FloorPoint& start, int node, int layers) {
  Column column;
  column.points.reserve(static_cast<std::size_t>(layers) + 1);
  Location at = field.on_triangle(start.triangle, start.weight);
  column.points.push_back(point_at(field.solid(), at));
  for (int level = 1; level <= layers; ++level) {
    const Fiber fiber = level == layers ? field.trace(at, Way::up)
                                        : field.trace_to(at, Way::up, field.height() * level / layers);
    at = fiber.at;
    // A fibre may arrive on the ceiling at the last level only; before, rounding alone brings it there.
    if (fiber.end != FiberEnd::base && fiber.end != FiberEnd::level) {
      column.stuck = {node, level, fiber.end, point_at(field.solid(), at)};
      break;
    }
    column.points.push_back(point_at(field.solid(), at));
  }
  return column;
}

} // namespace

SolidHexahedra hexahedra(const FiberField& field, const FloorGrid& grid, const std::vector<FloorPoint>& start,
                         const HexOptions& options, const Progress& progress) {
  if (options.layers < 1) throw PreconditionError("hexahedra: there must be at least one layer");
  if (start.size() != grid.nodes.size())
    throw PreconditionError("hexahedra: exactly one fiber must start at each node of the grid");
  const int count = static_cast<int>(start.size());
  std::vector<Column> columns(start.size());
  numeric::parallel_for(
      count, {options.threads, 16},
      [&](int node) { columns[node] = climbed(field, start[node], node, options.layers); },
      [&](double part) { progress.step("hexahedra", part); });

  SolidHexahedra result;
  for (const Column& column : columns)
    if (static_cast<int>(column.points.size()) <= options.layers) result.stuck.push_back(column.stuck);
  std::vector<int> below(start.size(), -1); // the numbers of the points of one level
  std::vector<int> above(start.size(), -1);
  for (int level = 0; level <= options.layers; ++level) {
    std::fill(above.begin(), above.end(), -1);
    for (int node = 0; node < count; ++node) {
      if (level >= static_cast<int>(columns[node].points.size())) continue;
      above[node] = static_cast<int>(result.mesh.points.size());
      result.mesh.points.push_back(columns[node].points[level]);
      result.on_boundary.push_back(
          static_cast<char>(level == 0 || level == options.layers || grid.nodes[node].loop >= 0));
    }
    for (const auto& [a, b, c, d] : grid.cells) {
      if (level == 0) break;
      const Hexahedron hexahedron{below[a], below[b], below[c], below[d],
                                  above[a], above[b], above[c], above[d]};
      if (std::count(hexahedron.begin(), hexahedron.end(), -1) > 0)
        ++result.left_out;
      else
        result.mesh.hexahedra.push_back(hexahedron);
    }
    std::swap(below, above);
  }
  return result;
}

} // namespace tetrarch::product
