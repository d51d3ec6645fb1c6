// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/core/error.hpp"
#include "tetrarch/unfold/unfold.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tetrarch::unfold {
namespace {

using namespace numeric;
using Columns = std::array<Vector, 3>;

Columns jacobian(const Element& element, const std::vector<Point>& points) {
  const Point& origin = points[element.corner[0]];
  Columns j{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector edge = points[element.corner[k + 1]] - origin;
    for (std::size_t c = 0; c < 3; ++c) j[c] = j[c] + element.inverse[k][c] * edge;
  }
  return j;
}

double determinant(const Columns& j) {
  return dot(j[0], cross(j[1], j[2]));
}

/// x^(-1/3) of a positive number, by Newton's method for 1 / y^3 = x: a third of the time of std::cbrt, and
/// as exact but for the last bits.
double inverse_cube_root(double x) {
  if (!(x >= std::numeric_limits<double>::min() && x <= std::numeric_limits<double>::max()))
    return 1 / std::cbrt(x);
  // A third of the exponent, the other way round; within 4 percent.
  constexpr std::uint64_t start = 0x553ef0ff289dd796U;
  auto y = std::bit_cast<double>(start - std::bit_cast<std::uint64_t>(x) / 3);
  for (int k = 0; k < 4; ++k) y *= 4.0 / 3 - 1.0 / 3 * x * y * y * y;
  return y;
}

/// chi without cancellation for D < 0, and its derivative.
struct Chi {
  Chi(double d, double epsilon) {
    const double root = std::sqrt(d * d + epsilon * epsilon); // half the time of hypot
    value = d >= 0 ? (d + root) / 2 : epsilon * epsilon / (root - d) / 2;
    slope = value / root;
  }
  double value = 0;
  double slope = 0;
};

/// An element's energy by its determinant and the square of J's entries, and its derivatives.
struct Density {
  Density(double d, double trace, double theta, double epsilon) {
    const Chi chi(d, epsilon);
    const double inverse_root = inverse_cube_root(chi.value);
    const double scale = inverse_root * inverse_root;
    const double inverse = scale * inverse_root; // of chi
    const double size = theta * (d * d + 1) * inverse;
    value = trace * scale + size;
    by_edge = 2 * scale;
    by_determinant = (-2.0 / 3 * trace * scale - size) * inverse * chi.slope + 2 * theta * d * inverse;
  }
  double value = 0;
  double by_edge = 0; ///< times the entry of J
  double by_determinant = 0;
};

void add_multiples(Vector& to, double s, const Vector& a, double t, const Vector& b) {
  for (std::size_t k = 0; k < 3; ++k) to[k] += s * a[k] + t * b[k];
}

/// The edges along each axis, from the lesser to the greater coordinate.
constexpr std::array<std::array<std::array<int, 2>, 4>, 3> edge_ends{{{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}},
                                                                      {{{0, 3}, {1, 2}, {4, 7}, {5, 6}}},
                                                                      {{{0, 4}, {1, 5}, {3, 7}, {2, 6}}}}};
/// Of each corner the edge there along each axis.
constexpr std::array<std::array<int, 3>, 8> edges_at_corners{
    {{0, 0, 0}, {0, 1, 1}, {1, 1, 3}, {1, 0, 2}, {2, 2, 0}, {2, 3, 1}, {3, 3, 3}, {3, 2, 2}}};

/// A brick's edges in terms of the lengths that they would like to have.
struct ScaledEdges {
  ScaledEdges(const Brick& b, const std::vector<Point>& points) {
    std::array<Point, 8> p{};
    for (std::size_t c = 0; c < 8; ++c) p[c] = points[b.corner[c]];
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 4; ++k)
        of[a][k] = b.inverse[a] * (p[edge_ends[a][k][1]] - p[edge_ends[a][k][0]]);
  }
  std::array<std::array<Vector, 4>, 3> of{};
};

} // namespace

Element element(const std::array<int, 4>& corner, const std::array<Vector, 3>& edges, double weight) {
  const double volume = determinant(edges);
  if (!(volume > 0)) throw PreconditionError("an element must want to have a positive volume");
  Element result{corner, {}, weight};
  for (std::size_t k = 0; k < 3; ++k)
    result.inverse[k] = 1 / volume * cross(edges[(k + 1) % 3], edges[(k + 2) % 3]);
  return result;
}

Vector Freedom::allowed(const Vector& motion) const {
  switch (kind) {
  case Kind::free:
    return motion;
  case Kind::plane:
    return motion - dot(direction, motion) * direction;
  case Kind::line:
    return dot(direction, motion) * direction;
  case Kind::fixed:
    break;
  }
  return {};
}

Vector Pull::away(const Point& p) const {
  const Vector whole = p - target;
  return whole - held.allowed(whole);
}

double energy(const std::vector<Element>& elements, const std::vector<Point>& points, double theta,
              double epsilon, std::vector<Vector>* gradient) {
  if (gradient != nullptr) gradient->assign(points.size(), Vector{});
  double sum = 0;
  for (const Element& e : elements) {
    const Columns j = jacobian(e, points);
    const std::array<Vector, 3> cofactor{cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])};
    const double trace = dot(j[0], j[0]) + dot(j[1], j[1]) + dot(j[2], j[2]);
    const Density density(dot(j[0], cofactor[0]), trace, theta, epsilon);
    sum += e.weight * density.value;
    if (gradient == nullptr) continue;
    Columns by_column{};
    for (std::size_t c = 0; c < 3; ++c)
      add_multiples(by_column[c], e.weight * density.by_edge, j[c], e.weight * density.by_determinant,
                    cofactor[c]);
    for (std::size_t k = 0; k < 3; ++k) {
      Vector part{};
      for (std::size_t c = 0; c < 3; ++c) part = part + e.inverse[k][c] * by_column[c];
      Vector& there = (*gradient)[e.corner[k + 1]];
      Vector& here = (*gradient)[e.corner[0]];
      there = there + part;
      here = here - part;
    }
  }
  return sum;
}

Brick brick(const std::array<int, 8>& corner, const std::array<double, 3>& lengths, double weight) {
  Brick result{corner, {}, weight};
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(lengths[a] > 0)) throw PreconditionError("a brick must want to have positive lengths");
    result.inverse[a] = 1 / lengths[a];
  }
  return result;
}

double add_energy(const std::vector<Brick>& bricks, const std::vector<Point>& points, double theta,
                  double epsilon, std::vector<Vector>& gradient) {
  double sum = 0;
  for (const Brick& b : bricks) {
    const ScaledEdges edges(b, points);
    std::array<std::array<double, 4>, 3> square{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 4; ++k) square[a][k] = dot(edges.of[a][k], edges.of[a][k]);
    std::array<std::array<Vector, 4>, 3> by_edge{};
    double here = 0;
    for (const std::array<int, 3>& e : edges_at_corners) {
      const Vector& x = edges.of[0][e[0]];
      const Vector& y = edges.of[1][e[1]];
      const Vector& z = edges.of[2][e[2]];
      const Vector yz = cross(y, z);
      const Density density(dot(x, yz), square[0][e[0]] + square[1][e[1]] + square[2][e[2]], theta, epsilon);
      here += density.value;
      add_multiples(by_edge[0][e[0]], density.by_edge, x, density.by_determinant, yz);
      add_multiples(by_edge[1][e[1]], density.by_edge, y, density.by_determinant, cross(z, x));
      add_multiples(by_edge[2][e[2]], density.by_edge, z, density.by_determinant, cross(x, y));
    }
    sum += b.weight * here;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector part = b.weight * b.inverse[a] * by_edge[a][k];
        Vector& low = gradient[b.corner[edge_ends[a][k][0]]];
        Vector& high = gradient[b.corner[edge_ends[a][k][1]]];
        low = low - part;
        high = high + part;
      }
  }
  return sum;
}

std::vector<double> determinants(const std::vector<Element>& elements, const std::vector<Point>& points) {
  std::vector<double> result;
  result.reserve(elements.size());
  for (const Element& e : elements) result.push_back(determinant(jacobian(e, points)));
  return result;
}

std::vector<double> determinants(const std::vector<Brick>& bricks, const std::vector<Point>& points) {
  std::vector<double> result;
  result.reserve(8 * bricks.size());
  for (const Brick& b : bricks) {
    const ScaledEdges edges(b, points);
    for (const std::array<int, 3>& e : edges_at_corners)
      result.push_back(dot(edges.of[0][e[0]], cross(edges.of[1][e[1]], edges.of[2][e[2]])));
  }
  return result;
}

} // namespace tetrarch::unfold
