// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/hyperbolic/cusp.hpp"

#include "tetrarch/numeric/union_find.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace tetrarch::hyperbolic {
namespace {

using Complex = std::complex<double>;
constexpr std::array<int, 3> next_corner{1, 2, 0};

/// The triangles of a cusp's cross-section, or of the torus that covers it twice: each is a sheet, that is, a
/// triangle of the link seen with its corners 0, 1, 2 counterclockwise (side 0) or clockwise (side 1).
struct Unrolled {
  std::vector<int> sheets;                                    ///< in the order in which they were reached
  std::vector<std::optional<std::array<Complex, 3>>> corners; ///< by sheet 2 * triangle + side
  std::vector<std::array<bool, 3>> inside;                    ///< by sheet: the tree passes through this side
};

/// What each triangle of the link measures along its three sides.
std::vector<std::array<double, 3>> sides_of(const Skeleton& skeleton, const Metric<double>& lengths,
                                            const Table<VertexId, VertexType>& types, VertexId v) {
  std::vector<std::array<double, 3>> sides;
  for (const TetVertex at : skeleton.preimages(v)) {
    const auto w = gram_matrix(lengths_at(skeleton, lengths, at.tet), types_at(skeleton, types, at.tet));
    const int i = at.vertex;
    sides.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const int j = face_vertex[i][next_corner[c]];
      const int k = face_vertex[i][next_corner[next_corner[c]]];
      sides.back()[c] = std::sqrt(std::max(squared_horosphere_side(w, i, j, k), 0.0));
    }
  }
  return sides;
}

/// The corner opposite a side of length `base` from a to b, on its left: at distance `from_a` and `from_b`.
Complex apex(Complex a, Complex b, double base, double from_a, double from_b) {
  const double along = (base * base + from_a * from_a - from_b * from_b) / (2 * base);
  const double height = std::sqrt(std::max(from_a * from_a - along * along, 0.0));
  return a + (b - a) / base * Complex(along, height);
}

/// The sheet beyond a side: the neighbor, turned over if the gluing keeps the sense of its corners.
int beyond(const TriangulatedSurface& link, int sheet, int side) {
  const auto& across = link.side(sheet / 2, side);
  const auto& c = across.corner;
  const bool keeps_sense = (c[1] - c[0] + 3) % 3 == 1;
  return 2 * across.triangle + (keeps_sense ? 1 - sheet % 2 : sheet % 2);
}

/// Where the corners of the sheet beyond `side` lie if it is laid against that side.
std::array<Complex, 3> laid_against(const TriangulatedSurface& link, const Unrolled& u, int sheet, int side,
                                    const std::vector<std::array<double, 3>>& sides) {
  const auto& here = *u.corners[static_cast<std::size_t>(sheet)];
  const auto& across = link.side(sheet / 2, side);
  const auto& length = sides[static_cast<std::size_t>(across.triangle)];
  std::array<Complex, 3> there;
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

Unrolled unroll(const TriangulatedSurface& link, const std::vector<std::array<double, 3>>& sides) {
  const std::size_t sheets = 2 * static_cast<std::size_t>(link.size());
  Unrolled u{{0}, {}, {}};
  u.corners.resize(sheets);
  u.inside.resize(sheets);
  const auto& first = sides[0];
  u.corners[0] = {0.0, first[2], apex(0.0, first[2], first[2], first[1], first[0])};
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
struct Translations {
  std::vector<Complex> all;
  std::vector<Complex> generators;
};

Translations translations(const TriangulatedSurface& link, const Unrolled& u,
                          const std::vector<std::array<double, 3>>& sides) {
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
  Translations found;
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
std::array<Complex, 2> reduced(Complex a, Complex b) {
  constexpr int enough = 10'000; // each step makes b shorter by a factor; NaN ends it at once
  for (int step = 0; step < enough; ++step) {
    if (std::norm(b) < std::norm(a)) std::swap(a, b);
    const double times = std::round((b / a).real());
    if (!(std::abs(times) >= 1)) break;
    b -= times * a;
  }
  return {a, b};
}

/// The same up to sign with Im > 0 and -1/2 < Re <= 1/2.
Complex standard(Complex shape) {
  constexpr double rounding = 1e-10; // on the rim of that region, the half with Re >= 0 is taken
  if (shape.imag() < 0) shape = -shape;
  if (shape.real() < -0.5 + rounding) shape += 1.0;
  if (shape.real() < 0 && std::norm(shape) < 1 + rounding)
    shape = -std::conj(shape); // a and b are equally long
  return shape;
}

double distance_to_lattice(Complex z, Complex a, Complex b) {
  const Complex ratio = b / a;
  const double times = std::round((z / a).imag() / ratio.imag());
  const Complex rest = z / a - times * ratio;
  return std::abs(rest - std::round(rest.real()));
}

/// Seen from the cusp, corners 1, 2, 3 at vertex 0 of a positively handed tetrahedron run clockwise.
bool first_triangle_runs_clockwise(TetVertex at, const std::optional<std::vector<int>>& orientation) {
  const bool positive = !orientation || (*orientation)[static_cast<std::size_t>(at.tet)] == (*orientation)[0];
  return positive == (at.vertex % 2 == 0);
}

double area_of(const std::vector<std::array<double, 3>>& sides) {
  double area = 0;
  for (const auto& [a, b, c] : sides) area += apex(0.0, c, c, b, a).imag() * c / 2;
  return area;
}

Cusp cusp(const Triangulation& tri, const Skeleton& skeleton, const Metric<double>& lengths,
          const Table<VertexId, VertexType>& types, const std::optional<std::vector<int>>& orientation,
          VertexId v) {
  const TriangulatedSurface link = vertex_link(tri, skeleton, v);
  const auto sides = sides_of(skeleton, lengths, types, v);
  const Unrolled u = unroll(link, sides);
  const Translations t = translations(link, u, sides);
  Cusp found{v, skeleton.link(v).orientable, {}, area_of(sides), 0};
  const auto [a, b] = reduced(t.generators.at(0), t.generators.at(1));
  const Complex seen =
      first_triangle_runs_clockwise(skeleton.preimages(v)[0], orientation) ? std::conj(b / a) : b / a;
  found.shape = standard(seen);
  for (const Complex z : t.all) found.residual = std::max(found.residual, distance_to_lattice(z, a, b));
  return found;
}

} // namespace

std::vector<Cusp> cusps(const Triangulation& tri, const Skeleton& skeleton, const Metric<double>& lengths) {
  skeleton.require_current(tri);
  const auto types = vertex_types(skeleton);
  const auto handed = orientation(tri);
  std::vector<Cusp> found;
  for (const VertexId v : all<VertexId>(skeleton.vertex_count()))
    if (types[v] == VertexType::ideal) found.push_back(cusp(tri, skeleton, lengths, types, handed, v));
  return found;
}

} // namespace tetrarch::hyperbolic
