// SPDX-License-Identifier: GPL-2.0-or-later
#include "patches.hpp"

#include "tetrarch/numeric/union_find.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

using surface::Side;
using surface::SideEnd;

constexpr int most_rounds = 20;

bool is_rim(const Solid& solid, const std::vector<int>& base, Side s) {
  return base[s.triangle()] != base[solid.boundary.mate(s).triangle()];
}

/// Connected pieces of one base or of wall: of each triangle the one that stands for its piece.
std::vector<int> pieces(const Solid& solid, const std::vector<int>& base) {
  std::vector<int> piece(base.size());
  std::iota(piece.begin(), piece.end(), 0);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t))
      if (solid.boundary.mate(s).value < s.value && !is_rim(solid, base, s))
        piece[numeric::find_root(piece, t)] = numeric::find_root(piece, solid.boundary.mate(s).triangle());
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) piece[t] = numeric::find_root(piece, t);
  return piece;
}

/// For each vertex 1 if it is on a rim.
std::vector<char> on_rims(const Solid& solid, const std::vector<int>& base) {
  std::vector<char> on(static_cast<std::size_t>(solid.boundary.vertex_count()), 0);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t))
      if (is_rim(solid, base, s)) on[solid.boundary.from(s)] = on[solid.boundary.to(s)] = 1;
  return on;
}

/// At the triangle that stands for a piece, twice its Euler characteristic. Its rims are torn apart, so that
/// it is a surface whose boundary has as many vertices as sides: V - E + F = I + B - (3 F + B) / 2 + F with I
/// vertices inside and B sides on rims.
std::vector<int> twice_euler(const Solid& solid, const std::vector<int>& base,
                             const std::vector<int>& piece) {
  std::vector<int> twice(piece.size(), 0);
  std::vector<char> counted = on_rims(solid, base);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    int& sum = twice[piece[t]];
    --sum;
    for (const Side s : surface::sides_of(t)) {
      if (is_rim(solid, base, s)) ++sum;
      if (!std::exchange(counted[solid.boundary.apex(s)], 1)) sum += 2;
    }
  }
  return twice;
}

/// Each base keeps its largest piece.
bool drop_crumbs(const Solid& solid, std::vector<int>& base, const std::vector<Point>& areas) {
  const std::vector<int> piece = pieces(solid, base);
  std::vector<double> area(piece.size(), 0.0);
  for (std::size_t t = 0; t < base.size(); ++t) area[piece[t]] += norm(areas[t]);
  std::array<int, 2> largest{-1, -1};
  for (std::size_t t = 0; t < base.size(); ++t) {
    if (base[t] < 0) continue;
    int& best = largest[base[t]];
    if (best < 0 || area[piece[t]] > area[best]) best = piece[t];
  }
  bool changed = false;
  for (std::size_t t = 0; t < base.size(); ++t) {
    if (base[t] < 0 || piece[t] == largest[base[t]]) continue;
    base[t] = -1;
    changed = true;
  }
  return changed;
}

/// Disks of wall, which border on one base only.
bool fill_holes(const Solid& solid, std::vector<int>& base) {
  const std::vector<int> piece = pieces(solid, base);
  // The boundary of a solid is orientable.
  const std::vector<int> twice = twice_euler(solid, base, piece);
  std::vector<int> filled(piece.size(), -1);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    int& with = filled[piece[t]];
    if (base[t] >= 0 || twice[piece[t]] != 2 || with >= 0) continue;
    for (const Side s : surface::sides_of(t))
      if (with < 0 && is_rim(solid, base, s)) with = base[solid.boundary.mate(s).triangle()];
  }
  bool changed = false;
  for (std::size_t t = 0; t < base.size(); ++t) {
    if (filled[piece[t]] < 0) continue;
    base[t] = filled[piece[t]];
    changed = true;
  }
  return changed;
}

/// Around each vertex: at most one run of a base.
bool open_pinches(const Solid& solid, std::vector<int>& base) {
  std::vector<char> seen(static_cast<std::size_t>(solid.boundary.vertex_count()), 0);
  std::vector<char> on_rim = on_rims(solid, base);
  bool changed = false;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t)) {
      const int v = solid.boundary.vertex({s, true});
      if (std::exchange(seen[v], 1) || !on_rim[v]) continue;
      const std::vector<SideEnd> around = surface::fan(solid.boundary, {s, true});
      int changes = 0;
      std::array<bool, 2> met{};
      for (std::size_t k = 0; k < around.size(); ++k) {
        const int here = base[around[k].side.triangle()];
        if (here >= 0) met[here] = true;
        changes += here != base[around[(k + 1) % around.size()].side.triangle()] ? 1 : 0;
      }
      if (changes <= 2 && !(met[0] && met[1])) continue;
      for (const SideEnd e : around) {
        base[e.side.triangle()] = -1;
        for (const int corner : solid.boundary.corners(e.side.triangle())) on_rim[corner] = 1;
      }
      changed = true;
    }
  return changed;
}

/// One after the other, so that a strip does not change back and forth.
bool shave_jags(const Solid& solid, std::vector<int>& base) {
  bool changed = false;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    std::array<int, 3> beyond{};
    for (const Side s : surface::sides_of(t)) beyond[s.corner()] = base[solid.boundary.mate(s).triangle()];
    for (int c = 0; c < 3; ++c) {
      const int other = beyond[c];
      const bool shaved = other == beyond[(c + 1) % 3] && other != base[t] && beyond[(c + 2) % 3] == base[t];
      if (!shaved || (other >= 0 && base[t] >= 0)) continue;
      base[t] = other;
      changed = true;
      break;
    }
  }
  return changed;
}

} // namespace

std::vector<Point> vector_areas(const Solid& solid) {
  std::vector<Point> areas;
  areas.reserve(static_cast<std::size_t>(solid.boundary.triangle_count()));
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    const Point& p = solid.point(solid.corner(t, 0));
    areas.push_back(0.5 * cross(solid.point(solid.corner(t, 1)) - p, solid.point(solid.corner(t, 2)) - p));
  }
  return areas;
}

void clean_up(const Solid& solid, std::vector<int>& base) {
  const std::vector<Point> areas = vector_areas(solid);
  bool changed = true;
  for (int round = 0; round < most_rounds && changed; ++round) {
    changed = round < most_rounds / 2 && shave_jags(solid, base);
    changed = open_pinches(solid, base) || changed;
    changed = drop_crumbs(solid, base, areas) || changed;
    changed = fill_holes(solid, base) || changed;
  }
}

} // namespace tetrarch::product
