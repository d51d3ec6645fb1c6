// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/cusp.hpp"

#include "tetrarch/numeric/ball.hpp"
#include "tetrarch/numeric/maximum.hpp"
#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace tetrarch::hyperbolic {
namespace {

constexpr std::array<int, 3> next_corner{1, 2, 0};

/// A point of the plane. (std::complex is for floating-point numbers alone.)
template <class Scalar>
struct Complex {
  Scalar re{}, im{};

  friend Complex operator+(const Complex& x, const Complex& y) { return {x.re + y.re, x.im + y.im}; }
  friend Complex operator-(const Complex& x, const Complex& y) { return {x.re - y.re, x.im - y.im}; }
  friend Complex operator*(const Complex& x, const Complex& y) {
    return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  }
  friend Complex operator*(const Scalar& x, const Complex& y) { return {x * y.re, x * y.im}; }
  friend Complex operator/(const Complex& x, const Scalar& y) { return {x.re / y, x.im / y}; }
  friend Complex operator/(const Complex& x, const Complex& y) { return x * conjugate(y) / square(y); }
  friend Complex conjugate(const Complex& x) { return {x.re, -x.im}; }
  friend Scalar square(const Complex& x) { return x.re * x.re + x.im * x.im; }
};

/// What choices are made by.
double rough(double x) {
  return x;
}
double rough(const numeric::Ball& x) {
  return numeric::to_double(x);
}

/// Rounding may leave a square below 0; a ball that holds such numbers says so by itself.
double root(double square) {
  return std::sqrt(std::max(square, 0.0));
}
numeric::Ball root(const numeric::Ball& square) {
  return sqrt(square);
}

/// What each triangle of a link measures along its three sides.
template <class Scalar>
using Sides = std::vector<std::array<Scalar, 3>>;

/// The triangles of a cusp's cross-section, or of the torus that covers it twice: each is a sheet, that is, a
/// triangle of the link seen with its corners 0, 1, 2 counterclockwise (side 0) or clockwise (side 1).
template <class Scalar>
struct Unrolled {
  std::vector<int> sheets; ///< in the order in which they were reached
  std::vector<std::optional<std::array<Complex<Scalar>, 3>>> corners; ///< by sheet 2 * triangle + side
  std::vector<std::array<bool, 3>> inside; ///< by sheet: the tree passes through this side
};

template <class Scalar>
Sides<Scalar> sides_of(const Skeleton& skeleton, const Metric<Scalar>& lengths,
                       const Table<VertexId, VertexType>& types, VertexId v) {
  Sides<Scalar> sides;
  for (const TetVertex at : skeleton.preimages(v)) {
    const auto w = gram_matrix(lengths_at(skeleton, lengths, at.tet), types_at(skeleton, types, at.tet));
    const int i = at.vertex;
    sides.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const int j = face_vertex[i][next_corner[c]];
      const int k = face_vertex[i][next_corner[next_corner[c]]];
      sides.back()[c] = root(squared_horosphere_side(w, i, j, k));
    }
  }
  return sides;
}

/// The corner opposite a side of length `base` from a to b, on its left: at distance `from_a` and `from_b`.
template <class Scalar>
Complex<Scalar> apex(const Complex<Scalar>& a, const Complex<Scalar>& b, const Scalar& base,
                     const Scalar& from_a, const Scalar& from_b) {
  const Scalar along = (base * base + from_a * from_a - from_b * from_b) / (2 * base);
  const Scalar height = root(from_a * from_a - along * along);
  return a + (b - a) / base * Complex<Scalar>{along, height};
}

/// The sheet beyond a side: the neighbor, turned over if the gluing keeps the sense of its corners.
int beyond(const TriangulatedSurface& link, int sheet, int side) {
  const auto& across = link.side(sheet / 2, side);
  const auto& c = across.corner;
  const bool keeps_sense = (c[1] - c[0] + 3) % 3 == 1;
  return 2 * across.triangle + (keeps_sense ? 1 - sheet % 2 : sheet % 2);
}

/// Where the corners of the sheet beyond `side` lie if it is laid against that side.
template <class Scalar>
std::array<Complex<Scalar>, 3> laid_against(const TriangulatedSurface& link, const Unrolled<Scalar>& u,
                                            int sheet, int side, const Sides<Scalar>& sides) {
  const auto& here = *u.corners[static_cast<std::size_t>(sheet)];
  const auto& across = link.side(sheet / 2, side);
  const auto& length = sides[static_cast<std::size_t>(across.triangle)];
  std::array<Complex<Scalar>, 3> there;
  int p = next_corner[side];
  int q = next_corner[p];
  there[across.corner[p]] = here[p];
  there[across.corner[q]] = here[q];
  if (sheet % 2 == 1) std::swap(p, q); // now this triangle lies on the left of pq, the other of qp
  const int top = across.corner[side];
  const int a = across.corner[q];
  const int b = across.corner[p];
  there[top] = apex(there[a], there[b], length[top], length[b], length[a]);
  return there;
}

template <class Scalar>
Unrolled<Scalar> unroll(const TriangulatedSurface& link, const Sides<Scalar>& sides) {
  const std::size_t sheets = 2 * static_cast<std::size_t>(link.size());
  Unrolled<Scalar> u{{0}, {}, {}};
  u.corners.resize(sheets);
  u.inside.resize(sheets);
  const auto& first = sides[0];
  const Complex<Scalar> start;
  const Complex<Scalar> end{first[2], Scalar(0)};
  u.corners[0] = {start, end, apex(start, end, first[2], first[1], first[0])};
  for (std::size_t k = 0; k < u.sheets.size(); ++k) {
    const int sheet = u.sheets[k];
    for (int side = 0; side < 3; ++side) {
      const int other = beyond(link, sheet, side);
      if (u.corners[static_cast<std::size_t>(other)]) continue;
      u.corners[static_cast<std::size_t>(other)] = laid_against(link, u, sheet, side, sides);
      u.inside[static_cast<std::size_t>(sheet)][side] = true;
      u.inside[static_cast<std::size_t>(other)][link.side(sheet / 2, side).corner[side]] = true;
      u.sheets.push_back(other);
    }
  }
  return u;
}

/// The translations that take what lies beyond a side to where it was laid: one for each side that the tree
/// does not pass through, and the two of them that generate the others.
template <class Scalar>
struct Translations {
  std::vector<Complex<Scalar>> all;
  std::vector<Complex<Scalar>> generators;
};

template <class Scalar>
Translations<Scalar> translations(const TriangulatedSurface& link, const Unrolled<Scalar>& u,
                                  const Sides<Scalar>& sides) {
  std::vector<int> corner_class(3 * u.corners.size());
  std::iota(corner_class.begin(), corner_class.end(), 0);
  const auto corner = [](int sheet, int c) { return 3 * sheet + c; };
  const auto merge = [&](int a, int b) {
    corner_class[numeric::find_root(corner_class, a)] = numeric::find_root(corner_class, b);
  };
  for (const int sheet : u.sheets)
    for (int side = 0; side < 3; ++side)
      for (int c = 0; c < 3; ++c)
        if (c != side)
          merge(corner(sheet, c), corner(beyond(link, sheet, side), link.side(sheet / 2, side).corner[c]));

  // Of the sides outside the tree of triangles, a tree over the corners; the two left over cut a torus open.
  Translations<Scalar> found;
  std::vector<int> joined(corner_class.size());
  std::iota(joined.begin(), joined.end(), 0);
  for (const int sheet : u.sheets)
    for (int side = 0; side < 3; ++side) {
      const int other = beyond(link, sheet, side);
      const int facing = link.side(sheet / 2, side).corner[side];
      if (u.inside[static_cast<std::size_t>(sheet)][side] ||
          std::pair(other, facing) < std::pair(sheet, side))
        continue;
      const int c = next_corner[side];
      const auto laid = laid_against(link, u, sheet, side, sides);
      const int there = link.side(sheet / 2, side).corner[c];
      found.all.push_back(laid[there] - (*u.corners[static_cast<std::size_t>(other)])[there]);
      const int a = numeric::find_root(joined, numeric::find_root(corner_class, corner(sheet, c)));
      const int b =
          numeric::find_root(joined, numeric::find_root(corner_class, corner(sheet, next_corner[c])));
      if (a == b) found.generators.push_back(found.all.back());
      joined[a] = b;
    }
  return found;
}

/// Shortest translations of the lattice that two translations span, the shorter first (Lagrange, Gauss).
template <class Scalar>
std::array<Complex<Scalar>, 2> reduced(Complex<Scalar> a, Complex<Scalar> b) {
  constexpr int enough = 10'000; // each step makes b shorter by a factor; NaN ends it at once
  for (int step = 0; step < enough; ++step) {
    if (rough(square(b)) < rough(square(a))) std::swap(a, b);
    const double times = std::round(rough((b / a).re));
    if (!(std::abs(times) >= 1)) break;
    b = b - Scalar(times) * a;
  }
  return {a, b};
}

/// The same up to sign with Im > 0 and -1/2 < Re <= 1/2.
template <class Scalar>
Complex<Scalar> standard(Complex<Scalar> shape) {
  constexpr double rounding = 1e-10; // on the rim of that region, the half with Re >= 0 is taken
  if (rough(shape.im) < 0) shape = Complex<Scalar>{} - shape;
  if (rough(shape.re) < -0.5 + rounding) shape.re += 1;
  if (rough(shape.re) < 0 && rough(square(shape)) < 1 + rounding)
    shape = conjugate(Complex<Scalar>{} - shape) / square(shape); // -1/shape: a and b are equally long
  return shape;
}

double distance_to_lattice(const Complex<double>& z, const Complex<double>& a, const Complex<double>& b) {
  const Complex<double> ratio = b / a;
  const double times = std::round((z / a).im / ratio.im);
  const Complex<double> rest = z / a - times * ratio;
  return std::hypot(rest.re - std::round(rest.re), rest.im);
}

/// Seen from the cusp, corners 1, 2, 3 at vertex 0 of a positively handed tetrahedron run clockwise.
bool first_triangle_runs_clockwise(TetVertex at, const std::optional<std::vector<int>>& orientation) {
  const bool positive = !orientation || (*orientation)[static_cast<std::size_t>(at.tet)] == (*orientation)[0];
  return positive == (at.vertex % 2 == 0);
}

double area_of(const Sides<double>& sides) {
  double area = 0;
  for (const auto& [a, b, c] : sides) area += apex<double>({}, {c, 0}, c, b, a).im * c / 2;
  return area;
}

/// A triangulation, with what is the same for all of its cusps.
template <class Scalar>
struct Setting {
  const Triangulation& tri;
  const Skeleton& skeleton;
  const Metric<Scalar>& lengths;
  Table<VertexId, VertexType> types;
  std::optional<std::vector<int>> handed;

  Setting(const Triangulation& t, const Skeleton& s, const Metric<Scalar>& l)
      : tri(t), skeleton(s), lengths(l), types(vertex_types(s)), handed(orientation(t)) {}
};

/// One cusp, unrolled.
template <class Scalar>
struct Measured {
  Sides<Scalar> sides;
  Translations<Scalar> translations;
  std::array<Complex<Scalar>, 2> shortest;
  Complex<Scalar> shape;

  Measured(const Setting<Scalar>& in, VertexId v) : sides(sides_of(in.skeleton, in.lengths, in.types, v)) {
    const TriangulatedSurface link = vertex_link(in.tri, in.skeleton, v);
    translations = hyperbolic::translations(link, unroll(link, sides), sides);
    shortest = reduced(translations.generators.at(0), translations.generators.at(1));
    const Complex<Scalar> ratio = shortest[1] / shortest[0];
    const bool clockwise = first_triangle_runs_clockwise(in.skeleton.preimages(v)[0], in.handed);
    shape = standard(clockwise ? conjugate(ratio) : ratio);
  }
};

Cusp cusp(const Setting<double>& in, VertexId v) {
  const Measured<double> seen(in, v);
  Cusp found{v, in.skeleton.link(v).orientable, {seen.shape.re, seen.shape.im}, area_of(seen.sides), 0};
  for (const auto& z : seen.translations.all)
    found.residual =
        numeric::maximum(found.residual, distance_to_lattice(z, seen.shortest[0], seen.shortest[1]));
  return found;
}

} // namespace

std::vector<Cusp> cusps(const Triangulation& tri, const Skeleton& skeleton, const Metric<double>& lengths) {
  skeleton.require_current(tri);
  const Setting<double> in(tri, skeleton, lengths);
  std::vector<Cusp> found;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (in.types[v] == VertexType::ideal) found.push_back(cusp(in, v));
  return found;
}

template <class Scalar>
std::vector<CuspShape<Scalar>> cusp_shapes(const Triangulation& tri, const Skeleton& skeleton,
                                           const Metric<Scalar>& lengths) {
  skeleton.require_current(tri);
  const Setting<Scalar> in(tri, skeleton, lengths);
  std::vector<CuspShape<Scalar>> found;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count())) {
    if (in.types[v] != VertexType::ideal) continue;
    const Measured<Scalar> seen(in, v);
    found.push_back({v, seen.shape.re, seen.shape.im});
  }
  return found;
}

template std::vector<CuspShape<double>> cusp_shapes(const Triangulation&, const Skeleton&,
                                                    const Metric<double>&);
template std::vector<CuspShape<numeric::Ball>> cusp_shapes(const Triangulation&, const Skeleton&,
                                                           const Metric<numeric::Ball>&);

} // namespace tetrarch::hyperbolic
