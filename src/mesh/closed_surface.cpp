// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/union_find.hpp"
#include "tetrarch/mesh/fill.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetrarch::mesh {
namespace {

/// Side s of a triangle, from corner s to corner s+1.
struct Side {
  int from;
  int to;
  int triangle;
  int corner;
};

std::array<int, 2> ends(const Side& side) {
  return {std::min(side.from, side.to), std::max(side.from, side.to)};
}

class SurfaceCheck {
public:
  explicit SurfaceCheck(const format::Soup& surface) : surface_(surface) {}

  void run() {
    if (surface_.triangles.empty())
      throw InputError(Place{surface_.source, 0}, "the surface has no triangles");
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) require_proper(static_cast<int>(t));
    join_sides();
    require_disks();
  }

private:
  [[noreturn]] void fail(int t, const std::string& what) const {
    const format::Labels& labels = surface_.triangle_labels;
    throw InputError(Place{surface_.source, labels.line(t)},
                     "triangle " + std::to_string(labels.number(t, surface_.first_number)) + " " + what);
  }
  std::string vertex(int v) const { return "vertex " + std::to_string(format::point_number(surface_, v)); }

  void require_proper(int t) const {
    const auto& corners = surface_.triangles[static_cast<std::size_t>(t)];
    for (std::size_t c = 0; c < 3; ++c) {
      const int v = corners[c];
      if (v < 0 || static_cast<std::size_t>(v) >= surface_.points.size())
        fail(t, "names " + vertex(v) + ", which is none of the " + std::to_string(surface_.points.size()) +
                    " there are");
      if (v == corners[(c + 1) % 3]) fail(t, "names " + vertex(v) + " twice");
      for (const double x : surface_.points[static_cast<std::size_t>(v)])
        if (!std::isfinite(x)) fail(t, "has " + vertex(v) + ", whose coordinates are not finite");
    }
  }

  /// Finds the two triangles at each edge; corners_ becomes the corners around each vertex that hang
  /// together.
  void join_sides() {
    corners_.resize(3 * surface_.triangles.size());
    std::iota(corners_.begin(), corners_.end(), 0);
    std::vector<Side> sides;
    sides.reserve(corners_.size());
    for (int t = 0; t < static_cast<int>(surface_.triangles.size()); ++t)
      for (int c = 0; c < 3; ++c) {
        const auto& corners = surface_.triangles[static_cast<std::size_t>(t)];
        sides.push_back({corners[c], corners[(c + 1) % 3], t, c});
      }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return ends(a) != ends(b) ? ends(a) < ends(b) : a.triangle < b.triangle;
    });
    for (std::size_t i = 0; i < sides.size(); i += 2) {
      const Side& side = sides[i];
      const std::string edge = "the edge on " + vertex(side.from) + " and " + vertex(side.to);
      if (i + 1 == sides.size() || ends(sides[i + 1]) != ends(side))
        fail(side.triangle, "is alone at " + edge + ": the surface is not closed");
      if (i + 2 < sides.size() && ends(sides[i + 2]) == ends(side))
        fail(sides[i + 2].triangle, "is the third at " + edge + ": the surface is no manifold");
      if (sides[i + 1].from == side.from)
        fail(sides[i + 1].triangle, "is turned against its neighbour at " + edge);
      join(side, sides[i + 1]);
    }
  }

  void join(const Side& a, const Side& b) {
    const auto corner = [](const Side& s, int step) { return 3 * s.triangle + (s.corner + step) % 3; };
    corners_[find_root(corners_, corner(a, 0))] = find_root(corners_, corner(b, 1));
    corners_[find_root(corners_, corner(a, 1))] = find_root(corners_, corner(b, 0));
  }

  void require_disks() {
    std::vector<int> fan(surface_.points.size(), -1);
    std::vector<int> part(surface_.points.size());
    std::iota(part.begin(), part.end(), 0);
    for (int k = 0; k < static_cast<int>(corners_.size()); ++k) {
      const auto& corners = surface_.triangles[static_cast<std::size_t>(k / 3)];
      const int v = corners[static_cast<std::size_t>(k % 3)];
      int& first = fan[static_cast<std::size_t>(v)];
      if (first < 0) first = find_root(corners_, k);
      if (first != find_root(corners_, k))
        fail(k / 3, "meets others in " + vertex(v) + " alone: the surface is no manifold");
      part[find_root(part, v)] = find_root(part, corners[0]);
    }
    const int first = find_root(part, surface_.triangles[0][0]);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      if (find_root(part, surface_.triangles[t][0]) != first)
        fail(static_cast<int>(t), "is not connected with the first one: expected one closed surface");
  }

  const format::Soup& surface_;
  std::vector<int> corners_; ///< union-find of the corners 3t+c
};

} // namespace

void require_closed_surface(const format::Soup& surface) {
  SurfaceCheck(surface).run();
}

} // namespace tetrarch::mesh
