// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/product/polycube_pullback.hpp"

#include "hexahedron.hpp"
#include "polycube_sheets.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/numeric/predicates.hpp"
#include "tetrarch/numeric/sparse_cholesky.hpp"
#include "tetrarch/numeric/vector.hpp"
#include "tetrarch/solid/edge_weights.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tetrarch::product {
namespace {

using namespace numeric;
using LatticePoint = std::array<int, 3>;
using Weights = std::array<double, 4>;

/// A point with a weight below is outside of a tetrahedron by more than rounding.
constexpr double outside = -1e-6;
/// Weights nearer to 0 are 0, so that points on faces and at vertices are exactly there.
constexpr double rounded_to_zero = 1e-13;

bool is_finite(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

double determinant(const Point& o, const Point& a, const Point& b, const Point& c) {
  return dot(a - o, cross(b - o, c - o));
}

struct LatticeHash {
  std::size_t operator()(const LatticePoint& at) const {
    std::uint64_t h = 0;
    for (const int x : at) h = (h ^ static_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15U;
    return h ^ (h >> 32U);
  }
};

/// The points of the cubes by their place in the lattice.
class Nodes {
public:
  Nodes(const std::vector<Point>& points, double edge) : edge_(edge) {
    number_.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      LatticePoint at{};
      for (std::size_t a = 0; a < 3; ++a) at[a] = static_cast<int>(std::lround(points[k][a] / edge));
      number_.emplace(at, static_cast<int>(k));
    }
  }
  /// The numbers of those in the bounding box of some points.
  template <class Visit>
  void visit(const std::array<Point, 4>& corners, const Visit& visit) const {
    LatticePoint low{};
    LatticePoint high{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto less = [a](const Point& p, const Point& q) { return p[a] < q[a]; };
      const auto [least, most] = std::minmax_element(corners.begin(), corners.end(), less);
      low[a] = static_cast<int>(std::ceil((*least)[a] / edge_ - margin));
      high[a] = static_cast<int>(std::floor((*most)[a] / edge_ + margin));
    }
    LatticePoint at{};
    for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
        for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
          if (const auto found = number_.find(at); found != number_.end()) visit(found->second);
  }

private:
  static constexpr double margin = 1e-6;

  double edge_;
  std::unordered_map<LatticePoint, int, LatticeHash> number_;
};

/// Where a point of the cubes is in M: in the tetrahedron in which it is deepest.
struct Place {
  int tet = -1;
  double depth = outside;
  Weights weight{};
};

std::vector<Place> places(const Solid& solid, const std::vector<Point>& image,
                          const std::vector<Point>& points, double edge, const Progress& progress) {
  std::vector<Place> result(points.size());
  const Nodes nodes(points, edge);
  std::int64_t visits = 0;
  for (int t = 0; t < solid.size(); ++t) {
    std::array<Point, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = image[solid.corners(t)[k]];
    const double whole = determinant(p[0], p[1], p[2], p[3]);
    nodes.visit(p, [&](int node) {
      if (visits++ % 65536 == 0) progress.step("hexahedra", t / static_cast<double>(solid.size()));
      const Point& x = points[node];
      const Weights weight{determinant(x, p[1], p[2], p[3]) / whole, determinant(p[0], x, p[2], p[3]) / whole,
                           determinant(p[0], p[1], x, p[3]) / whole,
                           determinant(p[0], p[1], p[2], x) / whole};
      const double depth = *std::min_element(weight.begin(), weight.end());
      if (depth > result[node].depth) result[node] = {t, depth, weight};
    });
  }
  return result;
}

Point image_of(const Solid& solid, Place place) {
  double sum = 0;
  for (double& x : place.weight) {
    if (x < rounded_to_zero) x = 0;
    sum += x;
  }
  Point p{};
  for (std::size_t k = 0; k < 4; ++k)
    p = p + place.weight[k] / sum * solid.point(solid.corners(place.tet)[k]);
  return p;
}

/// Points of squares that belong to one cube only.
std::vector<char> on_surface(const HexMesh& cubes) {
  std::vector<char> result(cubes.points.size(), 0);
  for (const auto& square : surface_squares(cubes))
    for (const int v : square) result[v] = 1;
  return result;
}

/// The equations of the vertices inside, one for each, and the number of each vertex among them.
struct Inside {
  std::vector<int> number; ///< -1 on the boundary
  SymmetricMatrix matrix;
  std::vector<double> right; ///< three columns
};

Inside inside_equations(const Solid& solid, const std::vector<solid::WeightedEdge>& edges,
                        const std::vector<Point>& image) {
  Inside s;
  s.number.assign(image.size(), -1);
  int size = 0;
  std::vector<char> used(image.size(), 0); // files have points that belong to nothing
  for (const solid::WeightedEdge& e : edges) used[e.from] = used[e.to] = 1;
  for (std::size_t v = 0; v < image.size(); ++v)
    if (solid.on_boundary[v] < 0 && used[v] != 0) s.number[v] = size++;
  std::vector<double> diagonal(static_cast<std::size_t>(size), 0.0);
  std::vector<std::vector<std::pair<int, double>>> below(static_cast<std::size_t>(size));
  s.right.assign(3 * static_cast<std::size_t>(size), 0.0);
  const auto add = [&](int here, int there, double weight) {
    const int row = s.number[here];
    if (row < 0) return;
    diagonal[row] += weight;
    if (s.number[there] < 0)
      for (int a = 0; a < 3; ++a) s.right[a * size + row] += weight * image[there][a];
    else if (s.number[there] > row)
      below[row].emplace_back(s.number[there], -weight);
  };
  for (const solid::WeightedEdge& e : edges) {
    add(e.from, e.to, e.weight);
    add(e.to, e.from, e.weight);
  }
  s.matrix.first.push_back(0);
  for (int column = 0; column < size; ++column) {
    s.matrix.row.push_back(column);
    s.matrix.value.push_back(diagonal[column]);
    std::sort(below[column].begin(), below[column].end());
    for (const auto& [row, value] : below[column]) {
      s.matrix.row.push_back(row);
      s.matrix.value.push_back(value);
    }
    s.matrix.first.push_back(static_cast<int>(s.matrix.row.size()));
  }
  return s;
}

} // namespace

std::optional<std::vector<Point>> harmonic_image(const Solid& solid, const std::vector<Point>& boundary_image,
                                                 bool clamped) {
  if (boundary_image.size() != solid.vertex.size())
    throw PreconditionError("harmonic_image: each vertex of the boundary needs an image");
  std::vector<Point> image(solid.mesh.points.size(), Point{});
  for (std::size_t b = 0; b < boundary_image.size(); ++b) image[solid.vertex[b]] = boundary_image[b];
  std::vector<solid::WeightedEdge> edges = solid::edge_weights(solid.mesh);
  for (solid::WeightedEdge& e : edges)
    if (clamped) e.weight = std::max(e.weight, 0.0);
  Inside inside = inside_equations(solid, edges, image);
  const int size = inside.matrix.size();
  if (size == 0) return image;
  SparseCholesky solver(inside.matrix);
  if (!solver.factor(inside.matrix)) return {};
  std::vector<double> x(inside.right.size());
  solver.solve(inside.right, x);
  for (std::size_t v = 0; v < image.size(); ++v)
    for (int a = 0; a < 3 && inside.number[v] >= 0; ++a) {
      image[v][a] = x[a * size + inside.number[v]];
      if (!std::isfinite(image[v][a])) return {};
    }
  return image;
}

std::vector<int> folded(const Solid& solid, const std::vector<Point>& image) {
  std::vector<int> result;
  for (int t = 0; t < solid.size(); ++t) {
    const auto& v = solid.corners(t);
    if (!std::all_of(v.begin(), v.end(), [&](int k) { return is_finite(image[k]); }) ||
        volume_sign(image[v[0]], image[v[1]], image[v[2]], image[v[3]]) != Sign::positive)
      result.push_back(t);
  }
  return result;
}

std::optional<std::vector<Point>> unfolded_image(const Solid& solid, const std::vector<Point>& image,
                                                 const Progress& progress) {
  for (const int t : folded(solid, image)) {
    const auto& v = solid.corners(t);
    if (std::all_of(v.begin(), v.end(), [&](int k) { return solid.on_boundary[k] >= 0; })) return {};
  }
  double before = 0;
  double after = 0;
  for (const auto& [a, b, c, d] : solid.mesh.tetrahedra) {
    before += determinant(solid.point(a), solid.point(b), solid.point(c), solid.point(d));
    after += determinant(image[a], image[b], image[c], image[d]);
  }
  if (!(after > 0)) return {}; // the boundary alone decides this
  const double scale = std::cbrt(after / before);
  unfold::Problem problem;
  for (const auto& v : solid.mesh.tetrahedra) {
    std::array<Vector, 3> edges{};
    for (std::size_t k = 0; k < 3; ++k) edges[k] = scale * (solid.point(v[k + 1]) - solid.point(v[0]));
    const double volume = dot(edges[0], cross(edges[1], edges[2]));
    if (!(volume > 0)) return {}; // positive, but not after rounding
    problem.elements.push_back(unfold::element(v, edges, volume));
  }
  for (const int b : solid.on_boundary)
    problem.freedom.push_back({b >= 0 ? unfold::Freedom::Kind::fixed : unfold::Freedom::Kind::free, {}});
  unfold::Unfolded done = unfold::unfold(problem, image, {}, progress);
  if (!folded(solid, done.points).empty()) return {};
  return std::move(done.points);
}

PolycubeHexahedra pulled_back(const Solid& solid, const std::vector<Point>& image,
                              const PolycubeOptions& options, const Progress& progress) {
  if (image.size() != solid.mesh.points.size())
    throw PreconditionError("pulled_back: each vertex of the solid needs an image");
  if (!folded(solid, image).empty())
    throw PreconditionError("pulled_back: the map turns tetrahedra over, so it has no inverse");
  progress.step("polycube");
  std::vector<Point> on_boundary;
  on_boundary.reserve(solid.vertex.size());
  for (const int v : solid.vertex) on_boundary.push_back(image[v]);
  PolycubeHexahedra result;
  const Polycube filled = filled_polycube(solid.boundary, on_boundary, options.step, options.cells);
  result.cubes = hexahedra(filled);

  const std::vector<Place> at = places(solid, image, result.cubes.points, filled.edge, progress);
  const std::vector<char> outer = on_surface(result.cubes);
  std::vector<int> number(at.size(), -1);
  for (std::size_t node = 0; node < at.size(); ++node) {
    if (at[node].tet < 0) {
      result.solid.stuck.push_back({static_cast<int>(node), 0, FiberEnd::stuck, result.cubes.points[node]});
      continue;
    }
    number[node] = static_cast<int>(result.solid.mesh.points.size());
    result.solid.mesh.points.push_back(image_of(solid, at[node]));
    result.solid.on_boundary.push_back(outer[node]);
  }
  add_whole_cubes(result, number);
  return result;
}

} // namespace tetrarch::product
