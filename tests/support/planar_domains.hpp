// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangulated domains whose slit maps are known: rings with slits, straight or bent by a conformal map, and
/// prisms, where linear elements are exact.
///
///      .-----------.       A grid of `rings` x `sectors` squares in the cylinder of height 0 (the outer
///     /   .---      \      circle) to `height`. A crack runs along grid lines of one height; the vertices
///    |    | .-.      |     strictly inside it are there twice. `place` then puts each vertex somewhere: at
///     \     '-' ---./      exp(-height + i angle) it is a ring with concentric slits.
///      '-----------'

#include "tetrarch/doctor/build.hpp"
#include "tetrarch/format/soup.hpp"
#include "tetrarch/surface/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tetrarch::support {

/// Along ring line `ring`, 0 < ring < rings, from sector line `first` over `count` sectors.
struct Crack {
  int ring = 1;
  int first = 0;
  int count = 2;
};

/// A place on the cylinder.
struct OnCylinder {
  double angle = 0;
  double height = 0;
  int bank = 0; ///< strictly inside a crack: -1 below it, 1 above
};

struct CrackedCylinder {
  surface::TriangleMesh mesh;
  std::vector<OnCylinder> at; ///< of each vertex: what the slit map should find, up to a rotation
  /// Of each crack, the vertices at which it starts and ends.
  std::vector<std::array<int, 2>> tips;
  int outer_vertex = 0; ///< one on height 0
  int inner_vertex = 0; ///< and one on top
};

struct CylinderGrid {
  int rings = 4;
  int sectors = 8;
  double height = 1;
  std::vector<Crack> cracks;
  /// How far vertices off the circles and cracks are moved, as a part of a square: a regular grid would give
  /// better orders than linear elements have.
  double unrest = 0.2;
};

/// Twice, thrice, ... as fine, with the same cracks.
inline CylinderGrid refined(CylinderGrid grid, int times) {
  grid.rings *= times;
  grid.sectors *= times;
  for (Crack& crack : grid.cracks) crack = {crack.ring * times, crack.first * times, crack.count * times};
  return grid;
}

/// `place(OnCylinder)` is a point of space, {x, y, z}.
template <class Place>
CrackedCylinder cracked_cylinder(const CylinderGrid& grid, const Place& place) {
  const int m = grid.rings;
  const int n = grid.sectors;
  const double turn = 2 * std::numbers::pi;
  CrackedCylinder out;
  const auto lower = [&](int i, int j) { return i * n + j % n; };
  std::vector<int> upper(static_cast<std::size_t>((m + 1) * n));
  std::vector<char> still(upper.size(), 0);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j < n; ++j) {
      upper[lower(i, j)] = lower(i, j);
      still[lower(i, j)] = static_cast<char>(i == 0 || i == m);
      out.at.push_back({turn * j / n, grid.height * i / m, 0});
    }
  for (const Crack& crack : grid.cracks) {
    out.tips.push_back({lower(crack.ring, crack.first), lower(crack.ring, crack.first + crack.count)});
    for (int j = 0; j <= crack.count; ++j) {
      const int v = lower(crack.ring, crack.first + j);
      still[v] = 1;
      if (j == 0 || j == crack.count) continue;
      upper[v] = static_cast<int>(out.at.size());
      out.at.push_back(out.at[v]);
      out.at[v].bank = -1;
      out.at.back().bank = 1;
    }
  }
  // Smooth along no direction of the grid, and the same function on all grids times the width of a square.
  for (int v = 0; v < static_cast<int>(still.size()); ++v) {
    if (still[v]) continue;
    out.at[v].angle += grid.unrest * turn / n * std::sin(11.0 * v);
    out.at[v].height += grid.unrest * grid.height / m * std::sin(17.0 * v);
  }
  format::Soup soup;
  for (const OnCylinder& p : out.at) soup.points.push_back(place(p));
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      // A crack's own vertices below it, their doubles above.
      const int a = upper[lower(i, j)];
      const int b = upper[lower(i, j + 1)];
      const int c = lower(i + 1, j + 1);
      const int d = lower(i + 1, j);
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  out.mesh = doctor::build_surface(std::move(soup));
  out.outer_vertex = lower(0, 0);
  out.inner_vertex = lower(m, 0);
  return out;
}

/// The ring of the concentric slit domain, bent by a function that is conformal on it.
template <class Bend>
CrackedCylinder slit_ring(const CylinderGrid& grid, const Bend& bend) {
  return cracked_cylinder(grid, [&](const OnCylinder& p) {
    const std::complex<double> w = bend(std::polar(std::exp(-p.height), p.angle));
    return std::array<double, 3>{w.real(), w.imag(), 0.0};
  });
}

/// A prism over the regular polygon of circumference 2 pi, standing on z = 0: its slit map is linear on every
/// triangle if there is no unrest, so linear elements find it exactly.
inline CrackedCylinder slit_prism(const CylinderGrid& grid) {
  const double corner = std::numbers::pi / (grid.sectors * std::sin(std::numbers::pi / grid.sectors));
  return cracked_cylinder(grid, [&](const OnCylinder& p) {
    return std::array<double, 3>{corner * std::cos(p.angle), corner * std::sin(p.angle), p.height};
  });
}

} // namespace tetrarch::support
