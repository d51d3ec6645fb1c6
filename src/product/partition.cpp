// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/partition.hpp"

#include "homology.hpp"

#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>

namespace tetrarch::product {
namespace {

using surface::Side;
using surface::SideEnd;

constexpr std::array<const char*, 2> base_name{"floor", "ceiling"};

/// The boundary torn along the rims: connected pieces, each of one base or between them.
struct Pieces {
  surface::Surface torn;
  surface::Parts parts;
  std::vector<surface::Part> piece;
  std::vector<int> base; ///< of each piece

  int first_triangle(int k) const { return piece[k].triangles.front(); }
};

std::string triangle_name(const Solid& solid, int triangle) {
  std::array<std::string, 3> v;
  for (int c = 0; c < 3; ++c) v[c] = std::to_string(solid.corner(triangle, c));
  return "triangle " + v[0] + " " + v[1] + " " + v[2];
}

void require_proper(const Solid& solid, const std::vector<int>& base, int outer) {
  const int triangles = solid.boundary.triangle_count();
  if (static_cast<int>(base.size()) != triangles)
    throw PreconditionError("partition: a base for each triangle of the boundary is needed");
  if (std::any_of(base.begin(), base.end(), [](int b) { return b < -1 || b > 1; }))
    throw PreconditionError("partition: bases are 0, 1, or -1 for walls");
  if (outer < -1 || outer >= triangles) throw PreconditionError("partition: no such outer triangle");
}

Pieces pieces_of(const Solid& solid, const std::vector<int>& base) {
  Pieces pieces{solid.boundary, {}, {}, {}};
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t))
      if (base[t] != base[solid.boundary.mate(s).triangle()] && !pieces.torn.is_boundary(s))
        pieces.torn.unglue(s);
  pieces.parts = surface::parts(pieces.torn);
  pieces.piece = surface::split(pieces.torn, pieces.parts);
  for (int k = 0; k < pieces.parts.count; ++k) pieces.base.push_back(base[pieces.first_triangle(k)]);
  return pieces;
}

/// What is wrong, in words; empty: nothing.
using Fault = std::string;

Fault why_not_connected_bases(const Solid& solid, const Pieces& pieces) {
  std::array<int, 2> seen{-1, -1};
  for (int k = 0; k < pieces.parts.count; ++k) {
    const int b = pieces.base[k];
    if (b < 0) continue;
    if (seen[b] >= 0)
      return std::string("the ") + base_name[b] + " falls apart: it has a piece with " +
             triangle_name(solid, pieces.first_triangle(seen[b])) + " and another with " +
             triangle_name(solid, pieces.first_triangle(k));
    seen[b] = k;
  }
  for (int b = 0; b < 2; ++b)
    if (seen[b] < 0) return std::string("there is no ") + base_name[b];
  return {};
}

/// The pieces that one meets around a vertex; a piece that is met twice is there twice.
std::vector<int> pieces_around(const Solid& solid, const Pieces& pieces, SideEnd at) {
  std::vector<int> around;
  for (const SideEnd e : surface::fan(solid.boundary, at)) {
    const int k = pieces.parts.of[e.side.triangle()];
    if (around.empty() || around.back() != k) around.push_back(k);
  }
  if (around.size() > 1 && around.front() == around.back()) around.pop_back();
  return around;
}

/// Around a vertex there is one piece, or a base and a wall once each.
Fault why_not_clean_vertices(const Solid& solid, const Pieces& pieces) {
  std::vector<char> seen(static_cast<std::size_t>(solid.boundary.vertex_count()), 0);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t)) {
      const SideEnd at{s, true};
      if (std::exchange(seen[solid.boundary.vertex(at)], 1)) continue;
      std::vector<int> around = pieces_around(solid, pieces, at);
      if (around.size() == 1) continue;
      const std::string place = "at vertex " + std::to_string(solid.corner(t, at.corner()));
      std::array<bool, 2> met{};
      for (const int k : around)
        if (pieces.base[k] >= 0) met[pieces.base[k]] = true;
      if (met[0] && met[1]) return "floor and ceiling touch " + place;
      if (around.size() == 2) continue;
      const int b = met[0] ? floor_patch : ceiling_patch;
      return std::string("the ") + base_name[b] + " is pinched " + place +
             ": several fans of its triangles meet there";
    }
  return {};
}

Fault why_not_type(const Solid& solid, const Pieces& pieces, int k, const surface::Surface& surface,
                   const SurfaceType& expected, const std::string& reason) {
  const SurfaceType type = surface::type_of(surface);
  if (type == expected) return {};
  const std::string name = pieces.base[k] < 0 ? "the wall" : std::string("the ") + base_name[pieces.base[k]];
  return name + " with " + triangle_name(solid, pieces.first_triangle(k)) + " is a " + type.str() +
         "; expected a " + expected.str() + reason;
}

Fault why_not_bases(const Solid& solid, const Pieces& pieces) {
  const int n = genus(solid);
  const SurfaceType expected{1 - n, n + 1};
  for (int k = 0; k < pieces.parts.count; ++k)
    if (pieces.base[k] >= 0) {
      Fault fault = why_not_type(solid, pieces, k, pieces.piece[k].surface, expected,
                                 ", because the boundary of the solid has genus " + std::to_string(n));
      if (!fault.empty()) return fault;
    }
  return {};
}

/// In a product the loops around the holes of the floor are a basis of the homology.
Fault why_not_homology(const Solid& solid, const Pieces& pieces, const FirstHomology& homology) {
  std::vector<FirstHomology::Element> loops;
  int at = -1;
  for (int k = 0; k < pieces.parts.count; ++k) {
    if (pieces.base[k] != floor_patch) continue;
    at = pieces.first_triangle(k);
    for (auto& rim : surface::boundary_curves(pieces.piece[k].surface)) {
      for (SideEnd& e : rim) e.side = pieces.piece[k].in_whole(e.side);
      loops.push_back(homology.of(rim));
    }
  }
  if (homology.generated_by(loops)) return {};
  return "the floor with " + triangle_name(solid, at) +
         " does not go around the handles of the solid: the loops around its holes do not generate the first "
         "homology, so the solid is no product over this floor";
}

/// A wall, found.
struct Wall {
  int piece = 0;
  double length = 0; ///< of its rim on the floor
};

double length(const Solid& solid, const surface::Part& part, const std::vector<SideEnd>& rim) {
  std::vector<double> lengths;
  for (const SideEnd e : rim) {
    const Side s = part.in_whole(e.side);
    lengths.push_back(numeric::distance(solid.point(solid.vertex[solid.boundary.from(s)]),
                                        solid.point(solid.vertex[solid.boundary.to(s)])));
  }
  // Summed in order of size, congruent rims are equally long, wherever they begin.
  std::sort(lengths.begin(), lengths.end());
  return std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

/// Piece k, which is on no base.
Fault why_not_wall(const Solid& solid, const Pieces& pieces, int k, Wall& result) {
  const surface::Part& part = pieces.piece[k];
  if (Fault fault = why_not_type(solid, pieces, k, part.surface, {0, 2}, ", a cylinder"); !fault.empty())
    return fault;
  result = {k, 0};
  std::array<int, 2> rims{};
  for (const auto& rim : surface::boundary_curves(part.surface)) {
    const Side beyond = solid.boundary.mate(part.in_whole(rim.front().side));
    const int b = pieces.base[pieces.parts.of[beyond.triangle()]];
    ++rims[b];
    if (b == floor_patch) result.length = length(solid, part, rim);
  }
  if (rims[0] != 1)
    return "the wall with " + triangle_name(solid, pieces.first_triangle(k)) + " has both rims on the " +
           base_name[rims[0] == 0 ? 1 : 0];
  return {};
}

Fault why_not_walls(const Solid& solid, const Pieces& pieces, int outer, std::vector<Wall>& walls) {
  for (int k = 0; k < pieces.parts.count; ++k) {
    if (pieces.base[k] >= 0) continue;
    Fault fault = why_not_wall(solid, pieces, k, walls.emplace_back());
    if (!fault.empty()) return fault;
  }
  // Each wall has one rim on the floor, which has genus + 1 of them: so there are as many walls.
  const int first = outer < 0 ? -1 : pieces.parts.of[outer];
  if (first >= 0 && pieces.base[first] >= 0)
    return "the outer wall should contain " + triangle_name(solid, outer) + ", which is on the " +
           base_name[pieces.base[first]];
  std::stable_sort(walls.begin(), walls.end(), [first](const Wall& a, const Wall& b) {
    if ((a.piece == first) != (b.piece == first)) return a.piece == first;
    return a.length > b.length;
  });
  return {};
}

} // namespace

PartitionAttempt try_partition(const Solid& solid, const std::vector<int>& base, int outer,
                               const FirstHomology* homology) {
  require_proper(solid, base, outer);
  const Pieces pieces = pieces_of(solid, base);
  std::vector<Wall> walls;
  Fault fault = why_not_connected_bases(solid, pieces);
  if (fault.empty()) fault = why_not_clean_vertices(solid, pieces);
  if (fault.empty()) fault = why_not_bases(solid, pieces);
  if (fault.empty()) fault = why_not_walls(solid, pieces, outer, walls);
  if (fault.empty() && homology != nullptr) fault = why_not_homology(solid, pieces, *homology);
  if (!fault.empty()) return {std::nullopt, std::move(fault)};

  std::vector<int> patch(pieces.base);
  for (std::size_t i = 0; i < walls.size(); ++i) patch[walls[i].piece] = first_wall + static_cast<int>(i);
  Partition result{{}, static_cast<int>(walls.size())};
  result.patch.reserve(base.size());
  for (const int k : pieces.parts.of) result.patch.push_back(patch[k]);
  return {std::move(result), {}};
}

PartitionAttempt try_partition(const Solid& solid, const std::vector<int>& base, int outer) {
  // First all that is cheaper.
  PartitionAttempt attempt = try_partition(solid, base, outer, nullptr);
  if (!attempt.partition || attempt.partition->holes() == 0) return attempt;
  const FirstHomology homology(solid);
  return try_partition(solid, base, outer, &homology);
}

Partition partition(const Solid& solid, const std::vector<int>& base, int outer) {
  PartitionAttempt attempt = try_partition(solid, base, outer);
  if (!attempt.partition) throw InputError(attempt.why_not);
  return *std::move(attempt.partition);
}

std::vector<int> bases_of_vertices(const Solid& solid, const Partition& partition) {
  std::vector<int> base(solid.mesh.points.size(), -1);
  for (int t = 0; t < solid.boundary.triangle_count(); ++t)
    for (int c = 0; c < 3 && partition.patch[t] < first_wall; ++c)
      base[solid.corner(t, c)] = partition.patch[t];
  return base;
}

} // namespace tetrarch::product
