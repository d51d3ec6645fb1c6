// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/grid.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/flat_locator.hpp"
#include "tetrarch/surface/boundary_loops.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using Complex = std::complex<double>;
using Rectangle = std::array<Complex, 2>;

constexpr double most_cells = 1e8;

double along(Complex z, int axis) {
  return axis == 0 ? z.real() : z.imag();
}

/// From `low` to `high`, ends included.
template <class Number>
struct Interval {
  Number low{};
  Number high{};
  bool meets(const Interval& other) const { return low <= other.high && other.low <= high; }
};

Interval<double> side_of(const Rectangle& hole, int axis) {
  return {along(hole[0], axis), along(hole[1], axis)};
}

void require_disjoint(double height, const std::vector<Rectangle>& holes) {
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const std::string name = "hole " + std::to_string(k) + " (counted from 0)";
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] = side_of(holes[k], axis);
      if (!(low < high)) throw InputError(name + " of the floor is empty");
      if (!(low > 0 && high < (axis == 0 ? 1 : height)))
        throw InputError(name + " does not lie inside the floor's rectangle");
    }
    for (std::size_t j = 0; j < k; ++j)
      if (side_of(holes[j], 0).meets(side_of(holes[k], 0)) &&
          side_of(holes[j], 1).meets(side_of(holes[k], 1)))
        throw InputError(name + " of the floor touches hole " + std::to_string(j));
  }
}

/// Lines across one axis.
struct Lines {
  std::vector<double> at;           ///< of each line; bends not included
  std::vector<Interval<int>> holes; ///< the two lines of each hole
  std::vector<int> forced;          ///< the lines on which sides lie
};

/// A side of a hole, or an outer one.
struct Border {
  double at = 0;
  int hole = -1;
  bool is_high = false;
};

/// Borders, from left to right, in groups that share a line. `conflict(j, k)`: holes that no line may touch
/// from different sides.
template <class Conflict>
std::vector<std::vector<Border>> grouped(std::vector<Border> borders, double shared,
                                         const Conflict& conflict) {
  std::stable_sort(borders.begin(), borders.end(),
                   [](const Border& a, const Border& b) { return a.at < b.at; });
  std::vector<std::vector<Border>> groups;
  for (const Border& border : borders) {
    const auto fits = [&](const std::vector<Border>& group) {
      if (border.at - group.front().at > shared || border.hole < 0 || group.front().hole < 0) return false;
      return std::none_of(group.begin(), group.end(), [&](const Border& other) {
        return other.hole == border.hole ||
               (other.is_high != border.is_high && conflict(other.hole, border.hole));
      });
    };
    if (!groups.empty() && fits(groups.back()))
      groups.back().push_back(border);
    else
      groups.push_back({border});
  }
  return groups;
}

template <class Conflict>
Lines lines(double length, const std::vector<Rectangle>& holes, int axis, const GridOptions& options,
            const Conflict& conflict) {
  const double cell = 1.0 / options.across;
  std::vector<Border> borders{{0.0}, {length}};
  for (int k = 0; k < static_cast<int>(holes.size()); ++k)
    for (const bool is_high : {false, true})
      borders.push_back({along(holes[k][is_high ? 1 : 0], axis), k, is_high});

  Lines result;
  result.holes.resize(holes.size());
  for (const std::vector<Border>& group : grouped(std::move(borders), options.shared * cell, conflict)) {
    double mean = 0;
    for (const Border& b : group) mean += b.at / static_cast<double>(group.size());
    if (!result.at.empty()) {
      const double before = result.at.back();
      const double parts = std::max(1.0, std::round((mean - before) / cell));
      if (!(parts < most_cells)) throw InputError("the floor's grid would have too many cells");
      for (int part = 1; part < parts; ++part) result.at.push_back(before + (mean - before) * part / parts);
    }
    const int line = static_cast<int>(result.at.size());
    for (const Border& b : group) {
      if (b.hole < 0) continue;
      Interval<int>& hole = result.holes[b.hole];
      (b.is_high ? hole.high : hole.low) = line;
    }
    result.at.push_back(mean);
    result.forced.push_back(line);
  }
  return result;
}

/// The grid while it is made. Of points of lines inside of holes, nothing is asked.
class Maker {
public:
  Maker(Lines across, Lines up, const std::vector<Rectangle>& holes)
      : lines_{std::move(across), std::move(up)}, holes_(holes),
        node_(static_cast<std::size_t>(size(0)) * size(1), -1) {}

  FloorGrid make() {
    FloorGrid grid;
    grid.columns = size(0) - 1;
    grid.rows = size(1) - 1;
    for (std::size_t k = 0; k < holes_.size(); ++k)
      grid.holes.push_back(
          {lines_[0].holes[k].low, lines_[1].holes[k].low, lines_[0].holes[k].high, lines_[1].holes[k].high});
    add_nodes(grid);
    add_cells(grid);
    return grid;
  }

private:
  int size(int axis) const { return static_cast<int>(lines_[axis].at.size()); }
  int& node(int column, int row) { return node_[static_cast<std::size_t>(row) * size(0) + column]; }

  /// The hole on whose rim, or in which, a node lies; -1 if there is none.
  int hole_at(int column, int row) const {
    for (std::size_t k = 0; k < holes_.size(); ++k)
      if (lines_[0].holes[k].meets({column, column}) && lines_[1].holes[k].meets({row, row}))
        return static_cast<int>(k);
    return -1;
  }

  /// A coordinate of a node on a forced line: that of the side, where it is on one.
  double forced(int axis, int line, int other_line) const {
    const int k = axis == 0 ? hole_at(line, other_line) : hole_at(other_line, line);
    if (k >= 0 && line == lines_[axis].holes[k].low) return along(holes_[k][0], axis);
    if (k >= 0 && line == lines_[axis].holes[k].high) return along(holes_[k][1], axis);
    return lines_[axis].at[line];
  }

  /// Linear between forced lines.
  double coordinate(int axis, int line, int other_line) const {
    const std::vector<int>& all = lines_[axis].forced;
    const auto after = std::lower_bound(all.begin(), all.end(), line);
    if (*after == line) return forced(axis, line, other_line);
    const int before = *std::prev(after);
    const double low = forced(axis, before, other_line);
    const double high = forced(axis, *after, other_line);
    return low + (high - low) * (line - before) / (*after - before);
  }

  void add_nodes(FloorGrid& grid) {
    for (int row = 0; row < size(1); ++row)
      for (int column = 0; column < size(0); ++column) {
        const int k = hole_at(column, row);
        if (k >= 0 && column > grid.holes[k][0] && row > grid.holes[k][1] && column < grid.holes[k][2] &&
            row < grid.holes[k][3])
          continue;
        const bool outer = column == 0 || row == 0 || column == grid.columns || row == grid.rows;
        node(column, row) = static_cast<int>(grid.nodes.size());
        grid.nodes.push_back({column,
                              row,
                              outer   ? 0
                              : k < 0 ? -1
                                      : k + 1,
                              {coordinate(0, column, row), coordinate(1, row, column)}});
      }
  }

  void add_cells(FloorGrid& grid) {
    double sum = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        if (std::any_of(grid.holes.begin(), grid.holes.end(), [&](const std::array<int, 4>& hole) {
              return column >= hole[0] && row >= hole[1] && column < hole[2] && row < hole[3];
            }))
          continue;
        const std::array<int, 4> cell{node(column, row), node(column + 1, row), node(column + 1, row + 1),
                                      node(column, row + 1)};
        std::array<Complex, 4> p;
        for (int c = 0; c < 4; ++c) p[c] = grid.nodes[cell[c]].position;
        const double ratio = std::abs(p[1] - p[0] + p[2] - p[3]) / std::abs(p[3] - p[0] + p[2] - p[1]);
        const double stretch = std::max(ratio, 1 / ratio);
        sum += stretch;
        grid.max_stretch = std::max(grid.max_stretch, stretch);
        grid.cells.push_back(cell);
      }
    grid.mean_stretch = sum / static_cast<double>(grid.cells.size());
  }

  std::array<Lines, 2> lines_;
  const std::vector<Rectangle>& holes_;
  std::vector<int> node_; ///< of each crossing of lines
};

FloorGrid made(double height, const std::vector<Rectangle>& holes, const GridOptions& options) {
  // Holes beside each other keep a gap. Those that are apart vertically may share a vertical line; if they do
  // not, they may share a horizontal one.
  Lines across = lines(1, holes, 0, options,
                       [&](int j, int k) { return side_of(holes[j], 1).meets(side_of(holes[k], 1)); });
  Lines up =
      lines(height, holes, 1, options, [&](int j, int k) { return across.holes[j].meets(across.holes[k]); });
  if (static_cast<double>(across.at.size()) * static_cast<double>(up.at.size()) > most_cells)
    throw InputError("the floor's grid would have too many cells");
  return Maker(std::move(across), std::move(up), holes).make();
}

/// Whether all angles of cells are between 30 and 150 degrees, in spite of bends.
bool has_shape(const FloorGrid& grid) {
  constexpr double least_sine = 0.5;
  for (const auto& cell : grid.cells)
    for (std::size_t c = 0; c < 4; ++c) {
      const Complex at = grid.nodes[cell[c]].position;
      const Complex next = grid.nodes[cell[(c + 1) % 4]].position - at;
      const Complex last = grid.nodes[cell[(c + 3) % 4]].position - at;
      if (!((std::conj(next) * last).imag() > least_sine * std::abs(next) * std::abs(last))) return false;
    }
  return true;
}

/// A point of a triangle of the floor as one of the solid's boundary.
FloorPoint on_solid(const Solid& solid, const FloorMap& floor, int triangle,
                    const std::array<double, 3>& weight, double miss) {
  FloorPoint point{floor.triangle[triangle], {}, miss};
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)
      if (solid.corner(point.triangle, k) == floor.vertex[floor.mesh.surface.corners(triangle)[c]])
        point.weight[k] = weight[c];
  return point;
}

/// The loops of the floor in the order of those of the grid: the outer one, then those of the holes.
std::vector<surface::BoundaryLoop> loops_of(const FloorMap& floor) {
  const std::vector<surface::BoundaryLoop> loops = surface::boundary_loops(floor.mesh);
  if (loops.size() != floor.rectangles.size() + 1)
    throw PreconditionError("the floor is not laid out as a rectangle with holes");
  std::vector<Rectangle> wanted{{0.0, {1.0, floor.height}}};
  wanted.insert(wanted.end(), floor.rectangles.begin(), floor.rectangles.end());
  std::vector<surface::BoundaryLoop> result;
  for (const Rectangle& box : wanted) {
    const auto off = [&](const surface::BoundaryLoop& loop) {
      double left = 1;
      double right = 0;
      double below = floor.height;
      double above = 0;
      for (const surface::SideEnd e : loop.sides) {
        const Complex p = floor.position[floor.mesh.surface.vertex(e)];
        left = std::min(left, p.real());
        right = std::max(right, p.real());
        below = std::min(below, p.imag());
        above = std::max(above, p.imag());
      }
      return std::abs(Complex(left, below) - box[0]) + std::abs(Complex(right, above) - box[1]);
    };
    result.push_back(*std::min_element(loops.begin(), loops.end(),
                                       [&](const auto& a, const auto& b) { return off(a) < off(b); }));
  }
  return result;
}

FloorPoint nearest_on(const surface::BoundaryLoop& loop, const Solid& solid, const FloorMap& floor,
                      Complex z) {
  const surface::Surface& surface = floor.mesh.surface;
  double least = std::numeric_limits<double>::infinity();
  surface::Side best;
  double best_part = 0;
  for (const surface::SideEnd e : loop.sides) {
    const Complex from = floor.position[surface.from(e.side)];
    const Complex to = floor.position[surface.to(e.side)];
    const double part = numeric::nearest_part(from, to, z);
    const double distance = std::abs(from + part * (to - from) - z);
    if (!(distance < least)) continue;
    least = distance;
    best = e.side;
    best_part = part;
  }
  std::array<double, 3> weight{};
  weight[best.next().corner()] = 1 - best_part;
  weight[best.previous().corner()] = best_part;
  return on_solid(solid, floor, best.triangle(), weight, least);
}

} // namespace

FloorGrid floor_grid(double height, const std::vector<Rectangle>& holes, const GridOptions& options) {
  if (options.across < 1) throw PreconditionError("floor_grid: there must be at least one cell across");
  if (!(options.shared >= 0 && options.shared < 0.5))
    throw PreconditionError("floor_grid: lines are shared within less than half a cell");
  if (!(height > 0 && std::isfinite(height))) throw InputError("the floor's rectangle has no height");
  require_disjoint(height, holes);
  GridOptions fewer = options;
  for (FloorGrid grid = made(height, holes, fewer);; grid = made(height, holes, fewer)) {
    if (fewer.shared == 0 || has_shape(grid)) return grid;
    fewer.shared = fewer.shared > 0.01 ? fewer.shared / 2 : 0;
  }
}

std::vector<FloorPoint> nodes_on_floor(const Solid& solid, const FloorMap& floor, const FloorGrid& grid) {
  const std::vector<surface::BoundaryLoop> loops = loops_of(floor);
  std::vector<numeric::FlatTriangle> triangles;
  triangles.reserve(floor.triangle.size());
  for (const auto& [a, b, c] : floor.mesh.surface.triangles())
    triangles.push_back({floor.position[a], floor.position[b], floor.position[c]});
  const numeric::FlatLocator locator(std::move(triangles));
  std::vector<FloorPoint> points;
  points.reserve(grid.nodes.size());
  for (const GridNode& node : grid.nodes) {
    if (node.loop >= 0) {
      points.push_back(nearest_on(loops[node.loop], solid, floor, node.position));
      continue;
    }
    const numeric::FlatPlace place = locator.nearest(node.position);
    if (place.triangle < 0) throw PreconditionError("all triangles of the floor are inverted");
    points.push_back(on_solid(solid, floor, place.triangle, place.weight, place.outside));
  }
  return points;
}

} // namespace tetrarch::product
