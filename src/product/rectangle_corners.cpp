// SPDX-License-Identifier: GPL-2.0-or-later
#include "rectangle_corners.hpp"

#include "tetrarch/numeric/flat_triangle.hpp"
#include "tetrarch/surface/laplacian.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tetrarch::product {
namespace {

using Complex = std::complex<double>;

/// A loop of the floor, seen in the plane.
struct Rim {
  std::vector<int> vertex;    ///< in the order of walking, the floor to the left
  std::vector<Complex> place; ///< of each
};

/// How far the rim turns to the left within a part of its length on either side of each of its vertices.
std::vector<double> turns(const Rim& rim) {
  const int size = static_cast<int>(rim.vertex.size());
  const auto at = [&](int k) { return rim.place[static_cast<std::size_t>((k + size) % size)]; };
  double length = 0;
  for (int k = 0; k < size; ++k) length += std::abs(at(k + 1) - at(k));
  // Jagged rims turn at each vertex; corners turn on the whole.
  const double near = length / 40;
  std::vector<double> turn;
  turn.reserve(rim.vertex.size());
  for (int k = 0; k < size; ++k) {
    const auto direction = [&](int step) {
      int j = step;
      while (std::abs(j) < size / 4 && std::abs(at(k + j) - at(k)) < near) j += step;
      return at(k + j) - at(k);
    };
    turn.push_back(std::arg(direction(1) / -direction(-1)));
  }
  return turn;
}

/// How far apart, in vertices, the nearest two of four increasing places of a cycle are.
int least_gap(const std::array<int, 4>& places, int size) {
  int gap = places[0] + size - places[3];
  for (int c = 0; c < 3; ++c) gap = std::min(gap, places[c + 1] - places[c]);
  return gap;
}

/// The four places of the rim that turn most to the left, each where it turns more than its neighbours; of
/// equal ones those farthest apart. None where there are no four.
std::optional<std::array<int, 4>> sharp_corners(const Rim& rim) {
  constexpr double least_turn = std::numbers::pi / 6;
  constexpr std::size_t most_candidates = 24; // with more, the rim is jagged
  const std::vector<double> turn = turns(rim);
  const int size = static_cast<int>(turn.size());
  std::vector<int> candidates;
  for (int k = 0; k < size; ++k) {
    const double before = turn[(k + size - 1) % size];
    const double after = turn[(k + 1) % size];
    if (turn[k] > least_turn && turn[k] >= before && turn[k] > after) candidates.push_back(k);
  }
  if (candidates.size() > most_candidates) return std::nullopt;
  const auto gain = [&](int k) { return std::min(turn[candidates[k]], std::numbers::pi / 2); };
  std::optional<std::array<int, 4>> best;
  double best_score = 0;
  const int count = static_cast<int>(candidates.size());
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      for (int c = b + 1; c < count; ++c)
        for (int d = c + 1; d < count; ++d) {
          const std::array<int, 4> corners{candidates[a], candidates[b], candidates[c], candidates[d]};
          const double spread = 4.0 * least_gap(corners, size) / size;
          const double score = gain(a) + gain(b) + gain(c) + gain(d) + spread;
          if (least_gap(corners, size) < 2 || score <= best_score) continue;
          best = corners;
          best_score = score;
        }
  return best;
}

/// The places farthest in the four diagonal directions of a frame whose x axis has direction `x`, if they are
/// apart, else places in equal steps.
std::array<int, 4> extreme_corners(const Rim& rim, Complex x) {
  const int size = static_cast<int>(rim.vertex.size());
  const auto along = [](Complex direction, Complex z) { return (std::conj(direction) * z).real(); };
  std::array<int, 4> corners{};
  for (int d = 0; d < 4; ++d) {
    const Complex way = x * Complex(d == 0 || d == 3 ? -1 : 1, d < 2 ? -1 : 1);
    corners[d] = static_cast<int>(
        std::max_element(rim.place.begin(), rim.place.end(),
                         [&](Complex p, Complex q) { return along(way, p) < along(way, q); }) -
        rim.place.begin());
  }
  std::sort(corners.begin(), corners.end());
  if (least_gap(corners, size) < 2)
    for (int c = 0; c < 4; ++c) corners[c] = c * size / 4;
  return corners;
}

/// The same corners from the one on that lies lowest to the left in that frame.
std::array<int, 4> from_lower_left(std::array<int, 4> corners, const std::vector<Complex>& place, Complex x) {
  const auto height = [&](int v) { return (place[v] * std::conj(x) * Complex(1, -1)).real(); };
  const auto first =
      std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return height(a) < height(b); });
  std::rotate(corners.begin(), first, corners.end());
  return corners;
}

Rim rim_of(const std::vector<int>& vertices, const std::vector<Complex>& place) {
  Rim rim{vertices, {}};
  rim.place.reserve(rim.vertex.size());
  for (const int v : rim.vertex) rim.place.push_back(place[v]);
  return rim;
}

std::array<int, 4> outer_corners(const std::vector<int>& outer, const std::vector<Complex>& place) {
  const Rim rim = rim_of(outer, place);
  std::array<int, 4> corners = sharp_corners(rim).value_or(extreme_corners(rim, 1));
  for (int& c : corners) c = rim.vertex[c];
  return from_lower_left(corners, place, 1);
}

/// A rectangle without regard to the holes: x is harmonic between the left and the right side, y between the
/// lower and the upper one, and nothing flows out anywhere else.
std::array<std::vector<double>, 2> rough_rectangle(const surface::TriangleMesh& floor,
                                                   const std::vector<int>& rim,
                                                   const std::array<int, 4>& corners) {
  const std::vector<double> weight = surface::half_cotangents(floor);
  const auto harmonic = [&](int low, int high) { // sides: 0 is the lower one, from corner 0 to corner 1
    std::vector<char> held(floor.points.size(), 0);
    std::vector<double> data(floor.points.size(), 0.0);
    for (const int side : {low, high}) {
      auto k = std::find(rim.begin(), rim.end(), corners[side]);
      for (bool last = false; !last;) {
        held[*k] = 1;
        data[*k] = side == high ? 1 : 0;
        last = *k == corners[(side + 1) % 4];
        if (++k == rim.end()) k = rim.begin();
      }
    }
    return surface::LaplaceSolver(floor.surface, weight, held).solve({data}).front();
  };
  return {harmonic(3, 1), harmonic(0, 2)};
}

/// Of a function that is linear on a triangle with corners at p, as x + iy.
Complex gradient(const std::array<Complex, 3>& p, const std::array<double, 3>& f) {
  Complex sum = 0;
  for (int c = 0; c < 3; ++c) sum += f[c] * (p[(c + 2) % 3] - p[(c + 1) % 3]);
  return Complex(0, 1) * sum / numeric::twice_area(p);
}

/// The direction in which x grows around a loop: the mean over its triangles, of y turned back, too.
Complex frame_at(const surface::TriangleMesh& floor, const std::vector<int>& loop,
                 const std::vector<Complex>& place, const std::array<std::vector<double>, 2>& rough) {
  std::vector<char> on_loop(floor.points.size(), 0);
  for (const int v : loop) on_loop[v] = 1;
  Complex sum = 0;
  for (const auto& corners : floor.surface.triangles()) {
    if (!on_loop[corners[0]] && !on_loop[corners[1]] && !on_loop[corners[2]]) continue;
    std::array<Complex, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = place[corners[c]];
    const double area = std::abs((std::conj(p[1] - p[0]) * (p[2] - p[0])).imag());
    for (int k = 0; k < 2; ++k) {
      const std::vector<double>& f = rough[k];
      const Complex g = gradient(p, {f[corners[0]], f[corners[1]], f[corners[2]]});
      if (std::isfinite(std::abs(g)) && std::abs(g) > 0)
        sum += area * g / std::abs(g) * (k == 0 ? Complex(1) : Complex(0, -1));
    }
  }
  return std::abs(sum) > 0 ? sum / std::abs(sum) : Complex(1);
}

} // namespace

std::optional<std::vector<Complex>> shadow(const surface::TriangleMesh& floor, const std::vector<int>& rim) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double area = 0;
  const auto point = [&](int v) -> Eigen::Vector3d { return Eigen::Vector3d::Map(floor.points[v].data()); };
  for (const auto& c : floor.surface.triangles()) {
    const Eigen::Vector3d twice = (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0]));
    normal += twice;
    area += twice.norm();
  }
  if (normal.norm() < 0.5 * area) return std::nullopt;
  normal.normalize();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int v : rim) mean += point(v) / static_cast<double>(rim.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const int v : rim) {
    const Eigen::Vector3d d = point(v) - mean;
    const Eigen::Vector3d flat = d - normal * normal.dot(d);
    spread += flat * flat.transpose();
  }
  const Eigen::Vector3d x = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  const Eigen::Vector3d y = normal.cross(x);
  std::vector<Complex> places;
  places.reserve(floor.points.size());
  for (int v = 0; v < static_cast<int>(floor.points.size()); ++v)
    places.emplace_back((point(v) - mean).dot(x), (point(v) - mean).dot(y));
  return places;
}

std::vector<CornerHints> corner_guesses(const surface::TriangleMesh& floor,
                                        const std::vector<std::vector<int>>& rims,
                                        const std::vector<Complex>& place,
                                        const std::optional<std::array<int, 4>>& given) {
  const CornerHints start{given ? *given : outer_corners(rims.front(), place)};
  if (rims.size() == 1) return {start};
  const auto rough = rough_rectangle(floor, rims.front(), start.front());
  std::vector<Complex> image;
  image.reserve(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) image.emplace_back(rough[0][v], rough[1][v]);

  std::vector<CornerHints> hints(2, start);
  const auto add = [&](CornerHints& list, const std::vector<int>& rim, const std::vector<Complex>& at,
                       Complex x) {
    std::array<int, 4> corners = extreme_corners(rim_of(rim, at), x);
    for (int& c : corners) c = rim[c];
    list.push_back(from_lower_left(corners, at, x));
  };
  for (std::size_t wall = 1; wall < rims.size(); ++wall) {
    add(hints[0], rims[wall], place, frame_at(floor, rims[wall], place, rough));
    add(hints[1], rims[wall], image, 1);
  }
  return hints;
}

} // namespace tetrarch::product
