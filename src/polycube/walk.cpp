// SPDX-License-Identifier: GPL-2.0-or-later
#include "walk.hpp"

#include "tetrarch/numeric/vector.hpp"

#include <cstddef>
#include <limits>

namespace tetrarch::polycube {
namespace {

using namespace numeric;

double determinant(const Point& o, const Point& a, const Point& b, const Point& c) {
  return dot(a - o, cross(b - o, c - o));
}

} // namespace

Weights ImageWalk::weights(int tet, const Point& p) const {
  const auto& v = solid_.corners(tet);
  const Point& a = image_[v[0]];
  const Point& b = image_[v[1]];
  const Point& c = image_[v[2]];
  const Point& d = image_[v[3]];
  const double whole = determinant(a, b, c, d);
  return {determinant(p, b, c, d) / whole, determinant(a, p, c, d) / whole, determinant(a, b, p, d) / whole,
          determinant(a, b, c, p) / whole};
}

WalkEnd ImageWalk::walk(int tet, const Point& from, const Point& to) const {
  WalkEnd end;
  end.tet = tet;
  int entry = -1;
  for (int steps = 0; steps <= solid_.size(); ++steps) {
    const Weights start = weights(end.tet, from);
    end.weight = weights(end.tet, to);
    // The face through which the line leaves: the first one that it crosses outwards.
    int exit = -1;
    double first = std::numeric_limits<double>::infinity();
    for (int f = 0; f < 4; ++f) {
      const double falls = start[f] - end.weight[f];
      if (f == entry || !(end.weight[f] < 0) || !(falls > 0)) continue;
      if (const double at = start[f] / falls; at < first) {
        first = at;
        exit = f;
      }
    }
    if (exit < 0) return end;
    const TetFace face{end.tet, exit};
    if (solid_.gluings.is_boundary(face)) {
      end.triangle = solid_.outside[static_cast<std::size_t>(4) * face.tet + face.face];
      return end;
    }
    const TetFace beyond = solid_.gluings.partner(face);
    end.tet = beyond.tet;
    entry = beyond.face;
  }
  end.is_lost = true;
  return end;
}

} // namespace tetrarch::polycube
