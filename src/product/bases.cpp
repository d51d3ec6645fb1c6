// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/bases.hpp"

#include "patches.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/shortest_paths.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/product/partition.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using namespace numeric;

using surface::Side;

std::string name(const char* what, const std::array<int, 3>& v) {
  return std::string(what) + " " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " +
         std::to_string(v[2]);
}

std::array<int, 3> sorted(std::array<int, 3> v) {
  std::sort(v.begin(), v.end());
  return v;
}

std::size_t boundary_vertex(const Solid& solid, int v) {
  if (v < 0 || v >= static_cast<int>(solid.on_boundary.size()) || solid.on_boundary[v] < 0)
    throw InputError("vertex " + std::to_string(v) + " (counted from 0) is not on the boundary of the solid");
  return static_cast<std::size_t>(solid.on_boundary[v]);
}

/// The sides of the boundary, both of each edge, along closed walks.
std::vector<Side> sides_along(const Solid& solid, const std::vector<std::vector<int>>& walks) {
  std::map<std::pair<int, int>, Side> side;
  for (int k = 0; k < solid.boundary.side_count(); ++k)
    side[{solid.boundary.from(Side(k)), solid.boundary.to(Side(k))}] = Side(k);
  std::vector<Side> found;
  for (std::size_t w = 0; w < walks.size(); ++w)
    for (std::size_t k = 0; k < walks[w].size(); ++k) {
      const int u = walks[w][k];
      const int v = walks[w][(k + 1) % walks[w].size()];
      const auto at = side.find(
          {static_cast<int>(boundary_vertex(solid, u)), static_cast<int>(boundary_vertex(solid, v))});
      if (at == side.end())
        throw InputError("vertices " + std::to_string(u) + " and " + std::to_string(v) + " of walk " +
                         std::to_string(w) + " (all counted from 0) are no edge of the boundary");
      found.push_back(at->second);
      found.push_back(solid.boundary.mate(at->second));
    }
  return found;
}

/// Area as a vector over area: 1 for flat pieces.
double flatness(const std::vector<Point>& areas, const std::vector<int>& triangles) {
  Point sum{};
  double area = 0;
  for (const int t : triangles) {
    sum = sum + areas[t];
    area += norm(areas[t]);
  }
  return norm(sum) / area;
}

/// Of four annuli in a ring those two opposite ones that are flatter.
std::array<int, 2> flatter_annuli(const Solid& solid, const surface::Parts& parts,
                                  const std::vector<surface::Part>& pieces) {
  std::vector<char> beside_first(pieces.size(), 0);
  for (int k = 0; k < solid.boundary.side_count(); ++k)
    if (parts.of[Side(k).triangle()] == 0)
      beside_first[parts.of[solid.boundary.mate(Side(k)).triangle()]] = 1;
  std::array<int, 2> beside{-1, -1};
  int opposite = -1;
  for (int k = 1; k < 4; ++k) {
    if (!beside_first[k])
      opposite = k;
    else
      (beside[0] < 0 ? beside[0] : beside[1]) = k;
  }
  if (opposite < 0 || beside[1] < 0) throw InputError("the four pieces between the walks do not form a ring");
  const std::vector<Point> areas = vector_areas(solid);
  const auto flat = [&](int k) { return flatness(areas, pieces[k].triangles); };
  return flat(0) + flat(opposite) >= flat(beside[0]) + flat(beside[1]) ? std::array{0, opposite} : beside;
}

/// Bases by what two pieces are.
std::vector<int> bases_of(const surface::Parts& parts, std::array<int, 2> pieces) {
  std::vector<int> base;
  base.reserve(parts.of.size());
  for (const int part : parts.of) base.push_back(part == pieces[0] ? 0 : part == pieces[1] ? 1 : -1);
  return base;
}

/// Cleaned up only where that is needed, since it cuts off triangles at corners that are meant.
std::vector<int> mended(const Solid& solid, std::vector<int> base) {
  if (!try_partition(solid, base).partition) clean_up(solid, base);
  return base;
}

/// The triangles reached from a seed; `base` gets the number.
void flood(const Solid& solid, const std::vector<Point>& areas, int number, const Flooding& flooding,
           std::vector<int>& base) {
  const int seed = flooding.seeds[number];
  const int at = static_cast<int>(boundary_vertex(solid, seed));
  std::vector<int> around;
  Point normal{};
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const int v : solid.boundary.corners(t)) {
      if (v != at) continue;
      around.push_back(t);
      normal = normal + areas[t];
    }
  const auto faces_this_way = [&](int t) {
    return 1 - dot(areas[t], normal) / (norm(areas[t]) * norm(normal)) <= flooding.threshold;
  };
  std::vector<int> reached;
  const auto reach = [&](int t) {
    if (base[t] == number || !faces_this_way(t)) return;
    if (base[t] >= 0)
      throw InputError("floor and ceiling meet after flooding from " + std::to_string(flooding.seeds[0]) +
                       " and " + std::to_string(flooding.seeds[1]) + "; try a smaller threshold");
    base[t] = number;
    reached.push_back(t);
  };
  for (const int t : around) reach(t);
  if (reached.empty())
    throw InputError("no triangle at seed " + std::to_string(seed) +
                     " faces its way within the threshold; it may lie on a ridge");
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const int t = reached[k];
    for (const Side s : surface::sides_of(t)) reach(solid.boundary.mate(s).triangle());
  }
}

/// Along edges of the boundary, of each of its vertices.
std::vector<double> edge_distances(const Solid& solid, const std::vector<Side>& from) {
  std::vector<std::vector<int>> neighbors(solid.vertex.size());
  for (int k = 0; k < solid.boundary.side_count(); ++k)
    neighbors[solid.boundary.from(Side(k))].push_back(solid.boundary.to(Side(k)));
  std::vector<int> roots;
  roots.reserve(from.size());
  for (const Side s : from) roots.push_back(solid.boundary.from(s));
  const auto steps = [&](int v, const auto& visit) {
    for (const int u : neighbors[v])
      visit(u, numeric::distance(solid.point(solid.vertex[v]), solid.point(solid.vertex[u])), v);
  };
  return numeric::shortest_paths(neighbors.size(), roots, -1, steps).distance;
}

} // namespace

std::vector<int> bases_with_labels(const Solid& solid, const std::vector<std::array<int, 3>>& triangles,
                                   const std::vector<int>& label, std::array<int, 2> floor_and_ceiling) {
  if (label.size() != triangles.size())
    throw PreconditionError("bases_with_labels: a label for each triangle is needed");
  std::map<std::array<int, 3>, int> face;
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    face[sorted({solid.corner(t, 0), solid.corner(t, 1), solid.corner(t, 2)})] = t;
  std::vector<int> base(face.size(), -1);
  std::array<int, 2> count{};
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (int b = 0; b < 2; ++b) {
      if (label[k] != floor_and_ceiling[b]) continue;
      const auto at = face.find(sorted(triangles[k]));
      if (at == face.end())
        throw InputError(name("triangle", triangles[k]) + " (counted from 0) has label " +
                         std::to_string(label[k]) + ", but is not on the boundary of the solid");
      base[at->second] = b;
      ++count[b];
    }
  for (int b = 0; b < 2; ++b)
    if (count[b] == 0) throw InputError("no triangle has label " + std::to_string(floor_and_ceiling[b]));
  return base;
}

std::vector<int> bases_between_cycles(const Solid& solid, const std::vector<std::vector<int>>& cycles) {
  surface::Surface torn = solid.boundary;
  for (const Side s : sides_along(solid, cycles))
    if (!torn.is_boundary(s)) torn.unglue(s);
  const surface::Parts parts = surface::parts(torn);
  const std::vector<surface::Part> pieces = surface::split(torn, parts);
  std::vector<int> others;
  std::string types;
  for (int k = 0; k < parts.count; ++k) {
    const SurfaceType type = surface::type_of(pieces[k].surface);
    types += (k > 0 ? ", " : "") + type.str();
    if (type.euler != 0 || type.boundary_curves != 2) others.push_back(k);
  }
  if (others.empty() && parts.count == 4) return bases_of(parts, flatter_annuli(solid, parts, pieces));
  if (others.size() != 2)
    throw InputError("the walks cut the boundary into " + std::to_string(parts.count) + " pieces (" + types +
                     "); expected two bases, and annuli between them");
  return bases_of(parts, {others[0], others[1]});
}

std::vector<int> bases_by_flooding(const Solid& solid, const Flooding& flooding) {
  const std::vector<Point> areas = vector_areas(solid);
  std::vector<int> base(areas.size(), -1);
  for (const int number : {0, 1}) flood(solid, areas, number, flooding, base);
  return mended(solid, std::move(base));
}

std::vector<int> bases_beyond_tunnels(const Solid& solid, const std::vector<std::vector<int>>& tunnels,
                                      double extend) {
  const std::vector<double> distance = edge_distances(solid, sides_along(solid, tunnels));
  surface::Surface torn = solid.boundary;
  std::vector<char> is_wall;
  for (const auto& corners : solid.boundary.triangles())
    is_wall.push_back(
        std::all_of(corners.begin(), corners.end(), [&](int v) { return distance[v] <= extend; }) ? 1 : 0);
  for (int k = 0; k < torn.side_count(); ++k) {
    const Side s(k);
    if (is_wall[s.triangle()] != is_wall[solid.boundary.mate(s).triangle()] && !torn.is_boundary(s))
      torn.unglue(s);
  }
  const surface::Parts parts = surface::parts(torn);
  std::vector<int> size(static_cast<std::size_t>(parts.count), 0);
  for (std::size_t t = 0; t < is_wall.size(); ++t) size[parts.of[t]] += is_wall[t] ? 0 : 1;
  std::array<int, 2> largest{-1, -1};
  for (int k = 0; k < parts.count; ++k) {
    if (size[k] == 0) continue;
    if (largest[0] < 0 || size[k] > size[largest[0]])
      largest = {k, largest[0]};
    else if (largest[1] < 0 || size[k] > size[largest[1]])
      largest[1] = k;
  }
  if (largest[1] < 0)
    throw InputError("the walls around the tunnels do not leave two pieces for floor and ceiling");
  std::sort(largest.begin(), largest.end());
  return mended(solid, bases_of(parts, largest));
}

} // namespace tetrarch::product
