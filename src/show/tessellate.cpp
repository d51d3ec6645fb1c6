// SPDX-License-Identifier: GPL-2.0-or-later
#include "tessellate.hpp"
#include "tetrarch/numeric/vector.hpp"

#include "tetrarch/numeric/matrix4.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tetrarch::show {

using namespace scene;

namespace {

using namespace numeric;

using embed::combination;
using embed::inner;
using embed::normalized;
using embed::operator*; // NOLINT(misc-unused-using-decls): clang-tidy 14 misses operators

/// A triangle on its way; side k runs from corner k to corner k+1 along a geodesic, or in the horosphere of
/// the curve with this number.
struct Piece {
  std::array<int, 3> corner;
  std::array<int, 3> curve;
};

class Cutter {
public:
  Cutter(const Patch& patch, const TooCoarse& too_coarse) : too_coarse_(too_coarse), curves_(patch.cusps) {
    const int n = static_cast<int>(patch.corners.size());
    // What lies inside a cusp's patch is curved as its sides are.
    curves_.push_back(patch.kind == Patch::Kind::cusp ? patch.normal : Vector4{});
    mesh_.points = patch.corners;
    const Vector4 middle = embed::centroid(patch.corners);
    mesh_.points.push_back(midpoint(middle, middle, curves_.back()));
    for (int k = 0; k < n; ++k) pieces_.push_back({{k, (k + 1) % n, n}, {k, n, n}});
  }

  /// False if no side was too coarse.
  bool cut_all() {
    std::vector<Piece> next;
    bool any = false;
    for (const Piece& piece : pieces_) any = cut(piece, next) || any;
    pieces_ = std::move(next);
    return any;
  }

  Tessellation take() {
    for (const Piece& piece : pieces_) mesh_.triangles.push_back(piece.corner);
    return std::move(mesh_);
  }

private:
  /// The point that halves the side, or -1.
  int halved(int a, int b, int curve) {
    const auto key = std::minmax(a, b);
    const auto known = middle_.find(key);
    if (known != middle_.end()) return known->second;
    const Vector4& p = mesh_.points[key.first];
    const Vector4& q = mesh_.points[key.second];
    Vector4 m = midpoint(p, q, curves_[curve]);
    if (curve + 1 == static_cast<int>(curves_.size())) m = outside_horoballs(m);
    if (!too_coarse_(p, m, q)) return -1;
    mesh_.points.push_back(m);
    return middle_[key] = static_cast<int>(mesh_.points.size()) - 1;
  }

  /// A horocycle bends into the patch: the geodesic between two points inside may cut across it.
  Vector4 outside_horoballs(const Vector4& m) const {
    for (const Vector4& cusp : curves_)
      if (is_horocycle(cusp) && inner(m, cusp) > -1) return midpoint(m, m, cusp);
    return m;
  }

  /// Into two, three or four, by how many sides are halved.
  bool cut(const Piece& piece, std::vector<Piece>& out) {
    std::array<int, 3> m;
    for (int k = 0; k < 3; ++k) m[k] = halved(piece.corner[k], piece.corner[(k + 1) % 3], piece.curve[k]);
    const int count = (m[0] >= 0) + (m[1] >= 0) + (m[2] >= 0);
    if (count == 0) {
      out.push_back(piece);
      return false;
    }
    // Turned so that a lone halved side, or a lone whole one, is the first.
    int turn = 0;
    while (count < 3 && (m[turn] >= 0) != (count == 1)) ++turn;
    const auto [a, b, c] =
        std::array{piece.corner[turn], piece.corner[(turn + 1) % 3], piece.corner[(turn + 2) % 3]};
    const auto [ab, bc, ca] =
        std::array{piece.curve[turn], piece.curve[(turn + 1) % 3], piece.curve[(turn + 2) % 3]};
    const auto [p, q, r] = std::array{m[turn], m[(turn + 1) % 3], m[(turn + 2) % 3]};
    const int inside = static_cast<int>(curves_.size()) - 1;
    if (count == 1) {
      out.push_back({{a, p, c}, {ab, inside, ca}});
      out.push_back({{p, b, c}, {ab, bc, inside}});
    } else if (count == 2) {
      out.push_back({{q, c, r}, {bc, ca, inside}});
      out.push_back({{a, b, q}, {ab, bc, inside}});
      out.push_back({{a, q, r}, {inside, inside, ca}});
    } else {
      out.push_back({{a, p, r}, {ab, inside, ca}});
      out.push_back({{p, b, q}, {ab, bc, inside}});
      out.push_back({{q, c, r}, {bc, ca, inside}});
      out.push_back({{p, q, r}, {inside, inside, inside}});
    }
    return true;
  }

  const TooCoarse& too_coarse_;
  std::vector<Vector4> curves_; ///< per side of the patch, then that of what lies inside
  Tessellation mesh_;
  std::vector<Piece> pieces_;
  std::map<std::pair<int, int>, int> middle_;
};

void append_between(const Vector4& a, const Vector4& b, const Arc& arc, const TooCoarse& too_coarse,
                    int rounds, std::vector<Vector4>& points) {
  const Vector4 m = midpoint(a, b, arc.cusp);
  if (rounds > 0 && too_coarse(a, m, b)) {
    append_between(a, m, arc, too_coarse, rounds - 1, points);
    append_between(m, b, arc, too_coarse, rounds - 1, points);
  } else {
    points.push_back(b);
  }
}

Vector4 moved(const Matrix4& by, const Vector4& v) {
  return is_horocycle(v) ? by * v : v;
}

} // namespace

double sagitta(const Point& a, const Point& m, const Point& b) {
  const auto along = direction(b - a);
  const Point to_middle = m - a;
  return along ? std::sqrt(dot(cross(*along, to_middle), cross(*along, to_middle)))
               : std::sqrt(dot(to_middle, to_middle));
}

Vector4 midpoint(const Vector4& a, const Vector4& b, const Vector4& cusp) {
  const Vector4 m = normalized(combination(1.0, a, 1.0, b));
  return is_horocycle(cusp) ? embed::onto_horosphere(m, cusp) : m;
}

Tessellation tessellated(const Patch& patch, const TooCoarse& too_coarse, int most_rounds) {
  Cutter cutter(patch, too_coarse);
  for (int round = 0; round < most_rounds && cutter.cut_all(); ++round) {
  }
  return cutter.take();
}

std::vector<Vector4> subdivided(const Arc& arc, const TooCoarse& too_coarse, int most_rounds) {
  std::vector<Vector4> points{arc.from};
  append_between(arc.from, arc.to, arc, too_coarse, most_rounds, points);
  return points;
}

Patch moved(const Matrix4& by, const Patch& patch) {
  Patch image = patch;
  for (Vector4& corner : image.corners) corner = by * corner;
  for (Vector4& cusp : image.cusps) cusp = moved(by, cusp);
  image.normal = by * image.normal;
  if (numeric::determinant(by) < 0) {
    std::reverse(image.corners.begin(), image.corners.end());
    std::reverse(image.cusps.begin(), image.cusps.end() - 1);
  }
  return image;
}

Arc moved(const Matrix4& by, const Arc& arc) {
  Arc image = arc;
  image.from = by * arc.from;
  image.to = by * arc.to;
  image.cusp = moved(by, arc.cusp);
  return image;
}

} // namespace tetrarch::show
