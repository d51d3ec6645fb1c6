// SPDX-License-Identifier: GPL-2.0-or-later
#include "polytope.hpp"

#include "tetrarch/numeric/instantiate.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::canonical {
namespace {

/// The functional that vanishes on three vectors: minors with alternating signs.
template <class Scalar>
Vector4<Scalar> functional_through(const Vector4<Scalar>& a, const Vector4<Scalar>& b,
                                   const Vector4<Scalar>& c) {
  Vector4<Scalar> psi;
  for (int i = 0; i < 4; ++i) {
    const auto& [p, q, r] = face_vertex[i];
    const Scalar minor = a[p] * (b[q] * c[r] - b[r] * c[q]) - a[q] * (b[p] * c[r] - b[r] * c[p]) +
                         a[r] * (b[p] * c[q] - b[q] * c[p]);
    psi[i] = i % 2 == 0 ? minor : Scalar(-minor);
  }
  return psi;
}

/// The wall through three corners, its corners not yet in order; nothing if others lie on both sides.
template <class Scalar>
std::optional<PolytopeWall<Scalar>> wall_through(const std::vector<Vector4<Scalar>>& corners,
                                                 const std::array<int, 3>& three, double margin) {
  using std::abs;
  PolytopeWall<Scalar> wall{functional_through(corners[three[0]], corners[three[1]], corners[three[2]]), {}};
  Scalar largest(0);
  std::vector<Scalar> values;
  for (const Vector4<Scalar>& v : corners) {
    values.push_back(dot<Scalar>(wall.psi, v));
    if (abs(values.back()) > abs(largest)) largest = values.back();
  }
  if (largest == 0) return std::nullopt;
  for (Scalar& x : wall.psi) x /= largest;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Scalar value = values[k] / largest;
    if (value < -margin) return std::nullopt;
    if (value <= margin) wall.corners.push_back(static_cast<int>(k));
  }
  return wall;
}

bool contains(const std::vector<int>& set, int x) {
  return std::find(set.begin(), set.end(), x) != set.end();
}

/// Puts the corners of each wall in cyclic order: neighbours have another wall in common. False if some
/// corner has not exactly two neighbours, or the corners are no single cycle.
template <class Scalar>
bool order_corners(std::vector<PolytopeWall<Scalar>>& walls) {
  std::vector<std::vector<int>> cycles;
  for (const auto& wall : walls) {
    const auto joined = [&](int a, int b) {
      return a != b && std::any_of(walls.begin(), walls.end(), [&](const auto& other) {
               return &other != &wall && contains(other.corners, a) && contains(other.corners, b);
             });
    };
    std::vector<int> cycle{wall.corners.front()};
    while (cycle.size() < wall.corners.size()) {
      const auto next = std::find_if(wall.corners.begin(), wall.corners.end(),
                                     [&](int c) { return !contains(cycle, c) && joined(cycle.back(), c); });
      if (next == wall.corners.end()) return false;
      cycle.push_back(*next);
    }
    for (const int a : wall.corners)
      if (std::count_if(wall.corners.begin(), wall.corners.end(), [&](int b) { return joined(a, b); }) != 2)
        return false;
    if (!joined(cycle.back(), cycle.front())) return false;
    cycles.push_back(std::move(cycle));
  }
  for (std::size_t k = 0; k < walls.size(); ++k) walls[k].corners = std::move(cycles[k]);
  return true;
}

template <class Scalar>
bool is_sphere(const std::vector<PolytopeWall<Scalar>>& walls, int corner_count) {
  std::size_t sides = 0;
  std::vector<int> walls_at(static_cast<std::size_t>(corner_count), 0);
  for (const auto& wall : walls) {
    sides += wall.corners.size();
    for (const int c : wall.corners) ++walls_at[c];
  }
  if (std::any_of(walls_at.begin(), walls_at.end(), [](int n) { return n < 3; })) return false;
  return 2 * (corner_count + static_cast<int>(walls.size())) - static_cast<int>(sides) == 4;
}

} // namespace

template <class Scalar>
std::optional<std::vector<PolytopeWall<Scalar>>> polytope_walls(const std::vector<Vector4<Scalar>>& corners,
                                                                double margin) {
  const int n = static_cast<int>(corners.size());
  if (n < 4) return std::nullopt;
  std::vector<PolytopeWall<Scalar>> walls;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const bool known = std::any_of(walls.begin(), walls.end(), [&](const auto& wall) {
          return contains(wall.corners, i) && contains(wall.corners, j) && contains(wall.corners, k);
        });
        if (known) continue;
        if (auto wall = wall_through<Scalar>(corners, {i, j, k}, margin)) walls.push_back(std::move(*wall));
      }
  if (!order_corners(walls) || !is_sphere(walls, n)) return std::nullopt;
  return walls;
}

#define TETRARCH_INSTANTIATE(Scalar)                                                                         \
  template std::optional<std::vector<PolytopeWall<Scalar>>> polytope_walls(                                  \
      const std::vector<Vector4<Scalar>>&, double);
TETRARCH_FOR_EACH_SCALAR(TETRARCH_INSTANTIATE)
#undef TETRARCH_INSTANTIATE

} // namespace tetrarch::canonical
