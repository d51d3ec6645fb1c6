// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Solids whose harmonic field and fibres are known.
///
///      t = 1  .-------.       A planar mesh times `layers`, carried into space by a map place(x, y, t). Each
///            /  (_)  /|       triangle times a layer is a prism, cut into three tetrahedra; a vertex of a
///      t = 0 '------' /       layer has the number of that of the planar mesh plus layer times their number.
///            '-------'        So no tetrahedron has all four vertices on one base.
///
/// The floor is t = 0, the ceiling t = 1, whatever they look like in space. In all solids here but `bent` the
/// harmonic field of height 1 is t, and its fibres are the curves of constant (x, y):
///
///     plate, cylinder    the identity, times a height
///     pipe               a ring times an interval, floor and ceiling either its ends or its two cylinders:
///                        w = log(r/a) / log(b/a), so that r = a (b/a)^t
///     shell              radial between spheres of radius a and b: w = (1/a - 1/r) / (1/a - 1/b)

#include "tetrarch/product/partition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace tetrarch::support {

/// Triangles counterclockwise; a disk with holes.
struct PlanarMesh {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<int, 3>> triangles;
  int holes = 0;
};

enum class Hole : std::uint8_t { round, square };

namespace detail {

/// Makes a plate cell by cell. Points x, y that are multiples of 1/fine are shared.
class PlateMaker {
public:
  explicit PlateMaker(int fine, Hole hole) : fine_(fine), hole_(hole) {}

  void add_grid(int column, int row) {
    for (int y = row * fine_; y < (row + 1) * fine_; ++y)
      for (int x = column * fine_; x < (column + 1) * fine_; ++x)
        add_square(grid_point(x, y), grid_point(x + 1, y), grid_point(x + 1, y + 1), grid_point(x, y + 1));
  }

  void add_rings(int column, int row) {
    const auto sectors = static_cast<std::size_t>(4 * fine_);
    std::vector<int> outer(sectors);
    for (int k = 0; k < 4 * fine_; ++k)
      outer[k] = grid_point(column * fine_ + around(k)[0], row * fine_ + around(k)[1]);
    for (int ring = 1; ring <= fine_ / 2; ++ring) {
      std::vector<int> inner(sectors);
      for (int k = 0; k < 4 * fine_; ++k) {
        const auto [x, y] = in_ring(k, 1.0 * ring / (fine_ / 2));
        inner[k] = static_cast<int>(plate_.points.size());
        plate_.points.push_back({column + 0.5 + x, row + 0.5 + y});
      }
      for (std::size_t k = 0; k < sectors; ++k)
        add_square(outer[k], outer[(k + 1) % sectors], inner[(k + 1) % sectors], inner[k]);
      outer = std::move(inner);
    }
    ++plate_.holes;
  }

  PlanarMesh take() { return std::move(plate_); }

private:
  int grid_point(int x, int y) {
    const auto [at, is_new] = on_grid_.try_emplace({x, y}, static_cast<int>(plate_.points.size()));
    if (is_new) plate_.points.push_back({1.0 * x / fine_, 1.0 * y / fine_});
    return at->second;
  }
  void add_square(int a, int b, int c, int d) {
    plate_.triangles.push_back({a, b, c});
    plate_.triangles.push_back({a, c, d});
  }
  /// The k-th grid point around a cell, counterclockwise from its lower left corner.
  std::array<int, 2> around(int k) const {
    const int along = k % fine_;
    switch (k / fine_) {
    case 0:
      return {along, 0};
    case 1:
      return {fine_, along};
    case 2:
      return {fine_ - along, fine_};
    default:
      return {0, fine_ - along};
    }
  }
  /// The k-th point of a ring, seen from the middle of the cell; `inward` is 0 on the cell's sides and 1 on
  /// the hole's.
  std::array<double, 2> in_ring(int k, double inward) const {
    const double x = 1.0 * around(k)[0] / fine_ - 0.5;
    const double y = 1.0 * around(k)[1] / fine_ - 0.5;
    const double angle = std::numbers::pi * (k / (2.0 * fine_) - 0.75);
    const bool round = hole_ == Hole::round;
    const double hole_x = round ? 0.25 * std::cos(angle) : 0.5 * x;
    const double hole_y = round ? 0.25 * std::sin(angle) : 0.5 * y;
    return {x + inward * (hole_x - x), y + inward * (hole_y - y)};
  }

  int fine_;
  Hole hole_;
  PlanarMesh plate_;
  std::map<std::array<int, 2>, int> on_grid_; ///< by multiples of 1/fine
};

} // namespace detail

/// The rectangle [0, columns] x [0, rows] of unit cells, cell (i, j) with a hole in its middle if
/// j columns + i < holes: of diameter or width 1/2. Each side of a cell has `fine` >= 2 edges; a cell without
/// a hole is a grid of squares, one with a hole is made of fine/2 rings around it.
inline PlanarMesh planar_plate(int columns, int rows, int holes, int fine, Hole hole = Hole::round) {
  detail::PlateMaker maker(fine, hole);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      if (j * columns + i < holes)
        maker.add_rings(i, j);
      else
        maker.add_grid(i, j);
  return maker.take();
}

/// The disk of radius 1: a middle vertex and `rings` rings, ring i of 6 i vertices.
inline PlanarMesh planar_disk(int rings) {
  PlanarMesh out;
  out.points.push_back({0, 0});
  const auto at = [](int ring, int k) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring); };
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < 6 * ring; ++k) {
      const double angle = std::numbers::pi * k / (3.0 * ring);
      out.points.push_back({1.0 * ring / rings * std::cos(angle), 1.0 * ring / rings * std::sin(angle)});
    }
  for (int ring = 1; ring <= rings; ++ring)
    for (int sixth = 0; sixth < 6; ++sixth)
      for (int k = 0; k < ring; ++k) {
        const int outer = sixth * ring + k;
        const int inner = sixth * (ring - 1) + k;
        out.triangles.push_back({at(ring, outer), at(ring, outer + 1), at(ring - 1, inner)});
        if (k + 1 < ring)
          out.triangles.push_back({at(ring, outer + 1), at(ring - 1, inner + 1), at(ring - 1, inner)});
      }
  return out;
}

/// The ring between the circles of radius `inner` and 1.
inline PlanarMesh planar_ring(double inner, int rings, int sectors) {
  PlanarMesh out;
  out.holes = 1;
  const auto at = [&](int ring, int k) { return ring * sectors + k % sectors; };
  for (int ring = 0; ring <= rings; ++ring)
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2 * std::numbers::pi * k / sectors;
      const double radius = inner + (1 - inner) * ring / rings;
      out.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < sectors; ++k) {
      out.triangles.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      out.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
  return out;
}

/// What `extruded` makes.
struct Extrusion {
  solid::TetMesh mesh;
  /// (x, y, t) of each vertex: fibre and harmonic field, where those are known.
  std::vector<std::array<double, 3>> at;
  int floor_vertices = 0;
  int layers = 0;
  int holes = 0;

  int layer(int v) const { return v / floor_vertices; }
};

namespace detail {

/// Moves vertices off the rim within the plane, and those between floor and ceiling along t: a regular grid
/// would give better orders than linear elements have. Smooth along no direction of the grid, the same
/// function on all grids times the size of a triangle.
inline void unsettle(Extrusion& solid, const PlanarMesh& plan, double unrest) {
  std::map<std::array<int, 2>, int> sides;
  double shortest = 1e300;
  for (const auto& t : plan.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i];
      const int b = t[(i + 1) % 3];
      ++sides[{std::min(a, b), std::max(a, b)}];
      shortest = std::min(
          shortest, std::hypot(plan.points[a][0] - plan.points[b][0], plan.points[a][1] - plan.points[b][1]));
    }
  std::vector<char> on_rim(plan.points.size(), 0);
  for (const auto& [ends, count] : sides)
    if (count == 1) on_rim[ends[0]] = on_rim[ends[1]] = 1;
  for (int v = 0; v < static_cast<int>(solid.at.size()); ++v) {
    auto& [x, y, t] = solid.at[v];
    if (!on_rim[v % solid.floor_vertices]) {
      x += unrest * shortest * std::sin(11.0 * v);
      y += unrest * shortest * std::sin(17.0 * v);
    }
    if (solid.layer(v) > 0 && solid.layer(v) < solid.layers) t += unrest / solid.layers * std::sin(23.0 * v);
  }
}

} // namespace detail

/// `place(x, y, t)` is a point {x, y, z} of space; it must not turn space over: then all volumes are
/// positive. With `unrest` 0 all layers are the same.
template <class Place>
Extrusion extruded(const PlanarMesh& plan, int layers, const Place& place, double unrest = 0.15) {
  Extrusion out;
  const int n = static_cast<int>(plan.points.size());
  out.floor_vertices = n;
  out.layers = layers;
  out.holes = plan.holes;
  for (int layer = 0; layer <= layers; ++layer)
    for (const auto& [x, y] : plan.points) out.at.push_back({x, y, 1.0 * layer / layers});
  if (unrest > 0) detail::unsettle(out, plan, unrest);
  for (const auto& [x, y, t] : out.at) out.mesh.points.push_back(place(x, y, t));
  for (int layer = 0; layer < layers; ++layer)
    for (std::array<int, 3> low : plan.triangles) {
      // The diagonal of a side of the prism starts below at the vertex of smaller number; so neighbours
      // agree.
      std::rotate(low.begin(), std::min_element(low.begin(), low.end()), low.end());
      const bool turned = low[1] > low[2];
      if (turned) std::swap(low[1], low[2]);
      for (int& v : low) v += layer * n;
      const auto& [a, b, c] = low;
      for (std::array<int, 4> tet :
           {std::array{a, b, c, c + n}, {b, a, b + n, c + n}, {a, a + n, b + n, c + n}}) {
        if (turned) std::swap(tet[0], tet[1]);
        out.mesh.tetrahedra.push_back(tet);
      }
    }
  return out;
}

/// The base of each triangle of the boundary, as product::partition wants it: 0, 1, or -1 on the walls.
/// `solid` must have the vertices of `from` by the same numbers.
inline std::vector<int> bases(const product::Solid& solid, const Extrusion& from) {
  std::vector<int> base(static_cast<std::size_t>(solid.boundary.triangle_count()), -1);
  for (int triangle = 0; triangle < solid.boundary.triangle_count(); ++triangle) {
    const auto all_in = [&](int layer) {
      return from.layer(solid.corner(triangle, 0)) == layer &&
             from.layer(solid.corner(triangle, 1)) == layer && from.layer(solid.corner(triangle, 2)) == layer;
    };
    if (all_in(0)) base[triangle] = 0;
    if (all_in(from.layers)) base[triangle] = 1;
  }
  return base;
}

/// A solid with the partition that it was made for.
struct Divided {
  product::Solid solid;
  product::Partition partition;
};
inline Divided divided(const Extrusion& from) {
  Divided d{product::solid_of(from.mesh), {}};
  d.partition = product::partition(d.solid, bases(d.solid, from));
  return d;
}

/// With edges of about 1/fine, `layers` of them upwards.
inline Extrusion plate(int holes, int fine, int layers, Hole hole = Hole::round, double height = 0.5,
                       double unrest = 0.15) {
  const auto place = [height](double x, double y, double t) { return std::array{x, y, height * t}; };
  return extruded(planar_plate(std::max(holes, 1), 1, holes, fine, hole), layers, place, unrest);
}

/// a x b x c, cut into nx x ny x nz boxes.
inline Extrusion box(const std::array<double, 3>& sides, const std::array<int, 3>& cuts,
                     double unrest = 0.15) {
  PlanarMesh plan;
  for (int j = 0; j <= cuts[1]; ++j)
    for (int i = 0; i <= cuts[0]; ++i)
      plan.points.push_back({sides[0] * i / cuts[0], sides[1] * j / cuts[1]});
  for (int j = 0; j < cuts[1]; ++j)
    for (int i = 0; i < cuts[0]; ++i) {
      const int v = j * (cuts[0] + 1) + i;
      const int above = v + cuts[0] + 1;
      plan.triangles.push_back({v, v + 1, above + 1});
      plan.triangles.push_back({v, above + 1, above});
    }
  const auto place = [&](double x, double y, double t) { return std::array{x, y, sides[2] * t}; };
  return extruded(plan, cuts[2], place, unrest);
}

/// Of radius 1.
inline Extrusion cylinder(int rings, int layers, double height = 1, double unrest = 0.15) {
  const auto place = [height](double x, double y, double t) { return std::array{x, y, height * t}; };
  return extruded(planar_disk(rings), layers, place, unrest);
}

/// Between cylinders of radius `inner` and 1 about the z axis, of this height; floor and ceiling are its
/// ends.
inline Extrusion pipe(double inner, double height, int fine, double unrest = 0.15) {
  const auto place = [height](double x, double y, double t) { return std::array{x, y, height * t}; };
  return extruded(planar_ring(inner, fine, 6 * fine), fine, place, unrest);
}

/// Between cylinders of radius `inner`, the floor, and 1, the ceiling. The walls are its flat ends, at
/// z = -0.5 and z = -1.
inline Extrusion radial_pipe(double inner, int fine, double unrest = 0.15) {
  const auto place = [inner](double x, double y, double t) {
    const double around = std::hypot(x, y);
    const double r = std::pow(inner, 1 - t);
    return std::array{r * x / around, r * y / around, -around};
  };
  return extruded(planar_ring(0.5, fine, 6 * fine), fine, place, unrest);
}

/// Between spheres about 0 of radius `inner`, the floor, and 1, the ceiling: a plate with holes, put on the
/// sphere by stereographic projection (times 0.8, its middle going to the north pole), times radii.
inline Extrusion shell(int holes, double inner, int fine, double unrest = 0.15) {
  const double middle = 0.5 * std::max(holes, 1);
  const auto place = [inner, middle](double x, double y, double t) {
    const double p = 0.8 * (x - middle);
    const double q = 0.8 * (y - 0.5);
    const double square = p * p + q * q;
    const double r = 1 / ((1 - t) / inner + t);
    return std::array{r * 2 * p / (1 + square), r * 2 * q / (1 + square), r * (1 - square) / (1 + square)};
  };
  return extruded(planar_plate(std::max(holes, 1), 1, holes, fine), fine, place, unrest);
}

/// No product: a plate bent by a quarter turn about an axis, thicker at one end, with a bulging ceiling and
/// walls that lean. Nothing is known of its field but that there is one.
inline Extrusion bent(int holes, int fine, int layers, double unrest = 0.15) {
  const double length = std::max(holes, 1);
  const auto place = [length](double x, double y, double t) {
    const double angle = 0.5 * std::numbers::pi * x / length;
    const double thick = 0.4 + 0.2 * x / length + 0.1 * std::sin(std::numbers::pi * y);
    const double r = length + thick * t;
    return std::array{-r * std::cos(angle), y + 0.2 * t, r * std::sin(angle)};
  };
  return extruded(planar_plate(std::max(holes, 1), 1, holes, fine), layers, place, unrest);
}

} // namespace tetrarch::support
