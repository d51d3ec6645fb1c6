// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Meshes of solids: balls, handlebodies, exteriors of knots and links, of a thousand to millions of
/// tetrahedra.
///
/// A solid is a set of unit cubes of a grid; each is split into six tetrahedra around its diagonal, all
/// alike, so the pieces fit. Curves are drawn on a coarse lattice: polygons and graphs with axis-parallel
/// segments. A lattice point becomes a block of cubes, a lattice step a bar of them; what is in no bar is the
/// exterior. With lattice points four cubes apart and bars one cube thick, an edge of two steps looks like
/// this, and the margin is as wide as the gap between neighbouring bars:
///
///       . . . . . . . . . . . . . . .
///       . . . # # # # # # # # # . . .
///       . . . . . . . . . . . . . . .
///
/// What comes out is known by construction: the exterior of a link of c components in a box has H1 = Z^c and
/// a sphere and c tori as boundary; a thickened connected graph is a handlebody.

#include "support/random.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tetrarch::support {

using Point = std::array<int, 3>;

/// A set of cubes in a grid of size[0] * size[1] * size[2]; the cube `at` reaches from corner `at` to `at` +
/// 111.
class Voxels {
public:
  explicit Voxels(const Point& size, bool filled = false)
      : size_(size), filled_(static_cast<std::size_t>(size[0]) * size[1] * size[2], filled) {}

  const Point& size() const { return size_; }
  /// False outside of the grid.
  bool filled(const Point& at) const {
    for (int a = 0; a < 3; ++a)
      if (at[a] < 0 || at[a] >= size_[a]) return false;
    return filled_[index(at)] != 0;
  }
  /// `at` must lie in the grid.
  void set(const Point& at, bool filled) { filled_.at(index(at)) = filled; }
  int count() const { return static_cast<int>(std::count(filled_.begin(), filled_.end(), 1)); }
  /// Calls `visit(at)` for every filled cube, in lexicographic order.
  template <class Visit>
  void for_each_filled(Visit visit) const {
    Point at{};
    for (at[0] = 0; at[0] < size_[0]; ++at[0])
      for (at[1] = 0; at[1] < size_[1]; ++at[1])
        for (at[2] = 0; at[2] < size_[2]; ++at[2])
          if (filled(at)) visit(static_cast<const Point&>(at));
  }
  Voxels complement() const {
    Voxels out = *this;
    for (char& f : out.filled_) f = !f;
    return out;
  }
  std::size_t index(const Point& at) const {
    return (static_cast<std::size_t>(at[0]) * size_[1] + at[1]) * size_[2] + at[2];
  }

private:
  Point size_;
  std::vector<char> filled_;
};

namespace detail {

/// Whether the cubes of a 2*2*2 block whose bits are set hang together by faces (so does the empty set). Bit
/// i is the cube at (i & 1, i / 2 & 1, i / 4).
constexpr bool hangs_together(unsigned block) {
  unsigned reached = block & (~block + 1);
  for (int round = 0; round < 8; ++round)
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned axis = 1; axis < 8; axis *= 2)
        if (reached >> i & 1U) reached |= block & 1U << (i ^ axis);
  return reached == block;
}

} // namespace detail

/// Whether the solid is a 3-manifold: around every grid point the filled cubes hang together by faces, and so
/// do the empty ones. (On the small sphere around the point both are then connected, without pinches: disks.)
/// O(volume).
inline bool is_manifold(const Voxels& solid) {
  std::array<bool, 256> good{};
  for (unsigned block = 0; block < 256; ++block)
    good[block] = detail::hangs_together(block) && detail::hangs_together(~block & 255U);
  const Point& size = solid.size();
  for (int x = 0; x <= size[0]; ++x)
    for (int y = 0; y <= size[1]; ++y)
      for (int z = 0; z <= size[2]; ++z) {
        unsigned block = 0;
        for (int i = 0; i < 8; ++i)
          if (solid.filled({x - 1 + (i & 1), y - 1 + (i / 2 & 1), z - 1 + i / 4})) block |= 1U << i;
        if (!good[block]) return false;
      }
  return true;
}

/// Six tetrahedra for each filled cube, cubes in lexicographic order. O(volume).
inline Triangulation triangulation_of(const Voxels& solid) {
  std::vector<int> first(static_cast<std::size_t>(solid.size()[0]) * solid.size()[1] * solid.size()[2], -1);
  int cubes = 0;
  solid.for_each_filled([&](const Point& at) { first[solid.index(at)] = 6 * cubes++; });
  return detail::cubes(solid.size(), false, cubes, [&](const Point& at) { return first[solid.index(at)]; });
}

/// The same tetrahedra in the same order with their points, as a mesh file has them. All are positively
/// handed: those that are not so in `triangulation_of` have their last two vertices exchanged. Points are
/// numbered by first use.
struct TetMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> tets;
};
inline TetMesh mesh_of(const Voxels& solid) {
  const Point corners{solid.size()[0] + 1, solid.size()[1] + 1, solid.size()[2] + 1};
  const Voxels grid(corners); // only for the numbering of its cells
  std::vector<int> number(static_cast<std::size_t>(corners[0]) * corners[1] * corners[2], -1);
  TetMesh mesh;
  const auto vertex = [&](const Point& p) {
    int& n = number[grid.index(p)];
    if (n < 0) {
      n = static_cast<int>(mesh.points.size());
      mesh.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    return n;
  };
  solid.for_each_filled([&](const Point& at) {
    for (const auto& order : detail::axis_order) {
      Point p = at;
      std::array<int, 4> tet{vertex(p)};
      for (int step = 0; step < 3; ++step) {
        ++p[order[step]];
        tet[step + 1] = vertex(p);
      }
      if (Perm4(order[0], order[1], order[2], 3).sign() < 0) std::swap(tet[2], tet[3]);
      mesh.tets.push_back(tet);
    }
  });
  return mesh;
}

/// How a drawing on the lattice becomes cubes: bars `thickness` cubes thick, lattice points `spacing`
/// cubes apart, so that bars which do not meet stay spacing - thickness >= 1 cubes apart.
struct Scale {
  int spacing = 2;
  int thickness = 1;
};

/// An axis-parallel segment of the lattice; coordinates are >= 0.
using Segment = std::array<Point, 2>;

/// All segments as bars, in the smallest box that leaves a margin of spacing - thickness around them. Throws
/// PreconditionError for a segment that is not parallel to an axis and unless 0 < thickness < spacing.
/// O(volume).
inline Voxels bars(const std::vector<Segment>& segments, const Scale& scale) {
  if (scale.thickness < 1 || scale.thickness >= scale.spacing)
    throw PreconditionError("bars: the thickness must be positive and below the spacing");
  Point top{};
  for (const Segment& s : segments)
    for (int a = 0; a < 3; ++a) top[a] = std::max({top[a], s[0][a], s[1][a]});
  const int margin = scale.spacing - scale.thickness;
  for (int& t : top) t = t * scale.spacing + scale.thickness + 2 * margin;
  Voxels solid(top);
  for (const auto& [from, to] : segments) {
    if ((from[0] != to[0]) + (from[1] != to[1]) + (from[2] != to[2]) > 1)
      throw PreconditionError("bars: a segment is not parallel to an axis");
    Point low{};
    Point high{};
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(from[a], to[a]) * scale.spacing + margin;
      high[a] = std::max(from[a], to[a]) * scale.spacing + margin + scale.thickness;
    }
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) solid.set({x, y, z}, true);
  }
  return solid;
}

/// A random connected graph on the x*y*z lattice: a random spanning tree and `genus` more steps, so that its
/// `bars` are a handlebody of that genus. Throws PreconditionError if the lattice has too few steps. O(xyz).
inline std::vector<Segment> random_graph(const Point& size, int genus, Random& random) {
  std::vector<Segment> steps;
  const Voxels lattice(size, true);
  lattice.for_each_filled([&](const Point& at) {
    for (int a = 0; a < 3; ++a) {
      Point next = at;
      ++next[a];
      if (lattice.filled(next)) steps.push_back({at, next});
    }
  });
  random.shuffle(steps);
  std::vector<int> parent(static_cast<std::size_t>(lattice.count()));
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<Segment> chosen;
  for (const Segment& step : steps) {
    const int a = numeric::find_root(parent, static_cast<int>(lattice.index(step[0])));
    const int b = numeric::find_root(parent, static_cast<int>(lattice.index(step[1])));
    if (a == b && --genus < 0) continue;
    parent[a] = b;
    chosen.push_back(step);
  }
  if (genus > 0) throw PreconditionError("random_graph: the lattice has too few steps for that genus");
  return chosen;
}

} // namespace tetrarch::support
