// SPDX-License-Identifier: GPL-2.0-or-later
#include "patches.hpp"

#include "vectors.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tetrarch::product {
namespace {

using mesh::Side;
using mesh::SideEnd;

constexpr int most_rounds = 20;

/// The boundary torn between bases and walls.
struct Torn {
  mesh::Surface surface;
  mesh::Parts parts;
};

Torn torn_between(const Solid& solid, const std::vector<int>& base) {
  Torn torn{solid.boundary, {}};
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : mesh::sides_of(t))
      if (base[t] != base[solid.boundary.mate(s).triangle()] && !torn.surface.is_boundary(s))
        torn.surface.unglue(s);
  torn.parts = mesh::parts(torn.surface);
  return torn;
}

/// Each base keeps its largest piece.
bool drop_crumbs(const Solid& solid, std::vector<int>& base, const std::vector<Point>& areas) {
  const mesh::Parts parts = torn_between(solid, base).parts;
  std::vector<double> area(static_cast<std::size_t>(parts.count), 0.0);
  for (std::size_t t = 0; t < base.size(); ++t) area[parts.of[t]] += vectors::norm(areas[t]);
  std::array<int, 2> largest{-1, -1};
  for (std::size_t t = 0; t < base.size(); ++t) {
    if (base[t] < 0) continue;
    int& best = largest[base[t]];
    if (best < 0 || area[parts.of[t]] > area[best]) best = parts.of[t];
  }
  bool changed = false;
  for (std::size_t t = 0; t < base.size(); ++t) {
    if (base[t] < 0 || parts.of[t] == largest[base[t]]) continue;
    base[t] = -1;
    changed = true;
  }
  return changed;
}

/// Disks of wall, which border on one base only.
bool fill_holes(const Solid& solid, std::vector<int>& base) {
  const Torn torn = torn_between(solid, base);
  const std::vector<mesh::Part> pieces = mesh::split(torn.surface, torn.parts);
  bool changed = false;
  for (const mesh::Part& piece : pieces) {
    if (base[piece.triangles.front()] >= 0 || !mesh::type_of(piece.surface).is_disk()) continue;
    const SideEnd rim = mesh::boundary_curves(piece.surface).front().front();
    const int around = base[solid.boundary.mate(piece.in_whole(rim.side)).triangle()];
    for (const int t : piece.triangles) base[t] = around;
    changed = true;
  }
  return changed;
}

/// Around each vertex: at most one run of a base.
bool open_pinches(const Solid& solid, std::vector<int>& base) {
  std::vector<char> seen(static_cast<std::size_t>(solid.boundary.vertex_count()), 0);
  bool changed = false;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : mesh::sides_of(t)) {
      if (std::exchange(seen[solid.boundary.vertex({s, true})], 1)) continue;
      const std::vector<SideEnd> around = mesh::fan(solid.boundary, {s, true});
      int changes = 0;
      std::array<bool, 2> met{};
      for (std::size_t k = 0; k < around.size(); ++k) {
        const int here = base[around[k].side.triangle()];
        if (here >= 0) met[here] = true;
        changes += here != base[around[(k + 1) % around.size()].side.triangle()] ? 1 : 0;
      }
      if (changes <= 2 && !(met[0] && met[1])) continue;
      for (const SideEnd e : around) base[e.side.triangle()] = -1;
      changed = true;
    }
  return changed;
}

/// One after the other, so that a strip does not change back and forth.
bool shave_jags(const Solid& solid, std::vector<int>& base) {
  bool changed = false;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    std::array<int, 3> beyond{};
    for (const Side s : mesh::sides_of(t)) beyond[s.corner()] = base[solid.boundary.mate(s).triangle()];
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
    areas.push_back(
        vectors::times(0.5, vectors::cross(vectors::difference(solid.point(solid.corner(t, 1)), p),
                                           vectors::difference(solid.point(solid.corner(t, 2)), p))));
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
