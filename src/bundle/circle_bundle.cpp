// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/circle_bundle.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace tetrarch::bundle {
namespace {

using surface::SideEnd;

/// A corner of a prism: the place of its column in the order r0, r1, r2, and 0 below or 1 above.
struct PrismCorner {
  int place;
  int above;
};

/// The three tetrahedra of a prism.
constexpr std::array<std::array<PrismCorner, 4>, 3> prism{{
    {{{0, 0}, {1, 0}, {2, 0}, {2, 1}}},
    {{{0, 0}, {1, 0}, {1, 1}, {2, 1}}},
    {{{0, 0}, {0, 1}, {1, 1}, {2, 1}}},
}};

/// A triangle of a wall of a prism: a face of its k-th tetrahedron.
struct WallFace {
  int k;
  int face;
};

/// Over the side without the column at `missing`: below the diagonal and above it.
constexpr std::array<std::array<WallFace, 2>, 3> wall{{
    {{{0, 0}, {1, 0}}},
    {{{0, 1}, {2, 2}}},
    {{{1, 3}, {2, 3}}},
}};

using Order = std::array<std::uint8_t, 3>;

int place_of(const Order& order, int corner) {
  return static_cast<int>(std::find(order.begin(), order.end(), corner) - order.begin());
}

/// A point on a wall: which end of the side it is over, and its level.
struct WallPoint {
  SideEnd end;
  int level;
};

class Assembly {
public:
  Assembly(Recipe recipe, const Progress& progress) : recipe_(std::move(recipe)), progress_(progress) {
    const long long size = 3LL * recipe_.fiber * recipe_.base.triangle_count();
    if (recipe_.fiber < 1) throw PreconditionError("a fiber needs at least one edge");
    if (size > std::numeric_limits<int>::max())
      throw InputError("too many tetrahedra: " + std::to_string(size));
    const auto sides = static_cast<std::size_t>(recipe_.base.side_count());
    if (recipe_.shift.size() != sides || recipe_.value.size() != sides)
      throw PreconditionError("a shift and a value for each side are needed");
    out_.fiber = recipe_.fiber;
    out_.total = Triangulation(static_cast<int>(size));
  }

  CircleBundle run() && {
    out_.order.resize(static_cast<std::size_t>(recipe_.base.triangle_count()));
    for (int t = 0; t < recipe_.base.triangle_count(); ++t) {
      step(t);
      out_.order[t] = order_of(t);
      fill_ring(t);
    }
    for (int k = 0; k < recipe_.base.side_count(); ++k) {
      const Side s(k);
      if (recipe_.base.is_boundary(s) || recipe_.base.mate(s).value < k) continue;
      for (const int upper : {0, 1}) glue_wall(s, upper);
    }
    out_.base = std::move(recipe_.base);
    return std::move(out_);
  }

private:
  /// A ring of prisms takes microseconds.
  void step(int triangle) const {
    if (triangle % 256 == 0)
      progress_.step("piling prisms", static_cast<double>(triangle) / recipe_.base.triangle_count());
  }
  int tet(int triangle, int level, int k) const { return 3 * (recipe_.fiber * triangle + level) + k; }

  Order order_of(int t) const {
    std::array<int, 3> earlier{};
    for (const Side s : sides_of(t)) {
      ++earlier[recipe_.value[s.value] > 0 ? s.previous().corner() : s.next().corner()];
    }
    Order order{};
    for (std::uint8_t c = 0; c < 3; ++c) {
      if (earlier[c] == 1 && earlier[(c + 1) % 3] == 1)
        throw PreconditionError("triangle " + std::to_string(t) + " has three equal values");
      order[earlier[c]] = c;
    }
    return order;
  }

  void fill_ring(int t) {
    const int n = recipe_.fiber;
    for (int j = 0; j < n; ++j) {
      out_.total.glue({tet(t, j, 0), 2}, tet(t, j, 1), Perm4());
      out_.total.glue({tet(t, j, 1), 1}, tet(t, j, 2), Perm4());
      out_.total.glue({tet(t, j, 2), 0}, tet(t, j + 1 < n ? j + 1 : 0, 0), Perm4(3, 0, 1, 2));
    }
  }

  WallPoint point(Side s, PrismCorner at) const {
    const int corner = out_.order[s.triangle()][at.place];
    return {{s, corner == s.next().corner()}, at.above};
  }

  WallPoint beyond(const WallPoint& p) const {
    const int sign = recipe_.base.is_turned(p.end.side) ? -1 : 1;
    return {recipe_.base.across(p.end), sign * p.level + recipe_.shift[p.end.side.value].at(p.end.at_start)};
  }

  /// Glues one of the two triangles of the wall over side s, on all levels. What is found for level 0 is the
  /// same on the others but for the level.
  void glue_wall(Side s, int upper) {
    const auto [k, face] = wall[place_of(out_.order[s.triangle()], s.corner())][upper];
    const Side m = recipe_.base.mate(s);
    std::array<WallPoint, 4> image{};
    for (int v = 0; v < 4; ++v)
      if (v != face) image[v] = beyond(point(s, prism[k][v]));
    for (const int above : {0, 1}) {
      const auto [other, other_face] = wall[place_of(out_.order[m.triangle()], m.corner())][above];
      for (int bottom = lowest(image, face); bottom >= lowest(image, face) - 1; --bottom)
        if (const auto perm = matching(image, face, other, other_face, bottom)) {
          const int step = recipe_.base.is_turned(s) ? -1 : 1;
          for (int j = 0; j < recipe_.fiber; ++j)
            out_.total.glue({tet(s.triangle(), j, k), face},
                            tet(m.triangle(), modulo(bottom + step * j), other), *perm);
          return;
        }
    }
    throw PreconditionError("values and shifts do not fit at side " + std::to_string(s.corner()) +
                            " of triangle " + std::to_string(s.triangle()));
  }

  static int lowest(const std::array<WallPoint, 4>& image, int face) {
    int least = std::numeric_limits<int>::max();
    for (int v = 0; v < 4; ++v)
      if (v != face) least = std::min(least, image[v].level);
    return least;
  }

  /// The map of vertices if the image is face `other_face` of tetrahedron `other` in the prism of level
  /// `bottom`.
  std::optional<Perm4> matching(const std::array<WallPoint, 4>& image, int face, int other, int other_face,
                                int bottom) const {
    std::array<int, 4> to{-1, -1, -1, -1};
    to[face] = other_face;
    const Side m = image[face == 0 ? 1 : 0].end.side;
    for (int v = 0; v < 4; ++v) {
      if (v == face) continue;
      for (int w = 0; w < 4; ++w) {
        if (w == other_face) continue;
        const WallPoint there = point(m, prism[other][w]);
        if (there.end == image[v].end && there.level + bottom == image[v].level) to[v] = w;
      }
      if (to[v] < 0) return std::nullopt;
    }
    return Perm4(to[0], to[1], to[2], to[3]);
  }

  int modulo(int level) const {
    const int rest = level % recipe_.fiber;
    return rest < 0 ? rest + recipe_.fiber : rest;
  }

  Recipe recipe_;
  const Progress& progress_;
  CircleBundle out_;
};

} // namespace

Shift inverse(Shift shift, bool turned) {
  return turned ? shift : Shift{-shift.stop, -shift.start};
}

int CircleBundle::corner(TetVertex v) const {
  return order[static_cast<std::size_t>(triangle(v.tet))][prism[v.tet % 3][v.vertex].place];
}

int CircleBundle::level(TetVertex v) const {
  return v.tet / 3 % fiber + prism[v.tet % 3][v.vertex].above;
}

CircleBundle assemble(Recipe recipe, const Progress& progress) {
  return Assembly(std::move(recipe), progress).run();
}

} // namespace tetrarch::bundle
