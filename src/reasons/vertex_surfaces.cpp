// SPDX-License-Identifier: GPL-2.0-or-later
#include "normal_pieces.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/reasons/normal_surface.hpp"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <numeric>

namespace tetrarch::reasons {
namespace {

constexpr int most_tetrahedra = 18;
constexpr std::int64_t largest_number = 1'000'000;
using Support = std::bitset<std::size_t{7} * most_tetrahedra>;

std::size_t triangle(int tet, int v) {
  return 7 * static_cast<std::size_t>(tet) + static_cast<std::size_t>(v);
}
std::size_t quad(int tet, int i, int j) {
  return triangle(tet, 4 + quad_kind(std::min(i, j), std::max(i, j)));
}

/// The arcs around corner v of one face: triangles at v and quadrilaterals that part v and the opposite
/// corner from the others.
struct Equation {
  std::vector<std::pair<std::size_t, int>> terms;
};

std::vector<Equation> matching_equations(const Triangulation& tri) {
  std::vector<Equation> equations;
  for (int t = 0; t < tri.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      const Gluing g = tri.gluing({t, f});
      if (std::pair(g.tet, g.perm[f]) < std::pair(t, f)) continue;
      for (int v = 0; v < 4; ++v)
        if (v != f)
          equations.push_back({{{triangle(t, v), 1},
                                {quad(t, v, f), 1},
                                {triangle(g.tet, g.perm[v]), -1},
                                {quad(g.tet, g.perm[v], g.perm[f]), -1}}});
    }
  return equations;
}

/// A ray of the cone: small whole numbers without a common divisor, and where they are not 0.
struct Ray {
  std::vector<std::int64_t> at;
  Support support;
};

std::int64_t value(const Equation& equation, const Ray& ray) {
  std::int64_t sum = 0;
  for (const auto& [k, sign] : equation.terms) sum += sign * ray.at[k];
  return sum;
}

/// One kind of quadrilaterals in each tetrahedron at most.
bool is_admissible(const Support& support, int tets) {
  for (int t = 0; t < tets; ++t) {
    int kinds = 0;
    for (int k = 4; k < 7; ++k) kinds += support[triangle(t, k)] ? 1 : 0;
    if (kinds > 1) return false;
  }
  return true;
}

class DoubleDescription {
public:
  DoubleDescription(const Triangulation& tri, long long most_steps, const Progress& progress)
      : tets_(tri.size()), steps_left_(most_steps), progress_(progress) {
    for (int k = 0; k < 7 * tets_; ++k) {
      Ray unit{std::vector<std::int64_t>(static_cast<std::size_t>(7 * tets_), 0), {}};
      unit.at[static_cast<std::size_t>(k)] = 1;
      unit.support.set(static_cast<std::size_t>(k));
      rays_.push_back(std::move(unit));
    }
  }

  /// False where the budget ends.
  bool cut(const Equation& equation) {
    std::vector<std::int64_t> side;
    std::vector<std::size_t> above, below;
    std::vector<Ray> kept;
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      const std::int64_t v = value(equation, rays_[r]);
      side.push_back(v);
      if (v > 0) above.push_back(r);
      if (v < 0) below.push_back(r);
      if (v == 0) kept.push_back(rays_[r]);
    }
    for (const std::size_t a : above) {
      progress_.step("normal surfaces");
      for (const std::size_t b : below) {
        if (--steps_left_ < 0) return false;
        const Support both = rays_[a].support | rays_[b].support;
        if (!is_admissible(both, tets_) || !are_adjacent(a, b, both)) continue;
        Ray sum{std::vector<std::int64_t>(rays_[a].at.size()), {}};
        std::int64_t divisor = 0;
        for (std::size_t k = 0; k < sum.at.size(); ++k) {
          sum.at[k] = side[a] * rays_[b].at[k] - side[b] * rays_[a].at[k];
          divisor = std::gcd(divisor, sum.at[k]);
        }
        for (std::size_t k = 0; k < sum.at.size(); ++k) {
          sum.at[k] /= divisor;
          if (sum.at[k] > largest_number) return false;
          if (sum.at[k] != 0) sum.support.set(k);
        }
        kept.push_back(std::move(sum));
      }
    }
    rays_ = std::move(kept);
    return true;
  }

  const std::vector<Ray>& rays() const { return rays_; }

private:
  /// No third ray lies in the least face that holds both.
  bool are_adjacent(std::size_t a, std::size_t b, const Support& both) {
    for (std::size_t c = 0; c < rays_.size(); ++c) {
      if (c == a || c == b) continue;
      if ((rays_[c].support & ~both).none()) return false;
    }
    steps_left_ -= static_cast<long long>(rays_.size() / 64);
    return true;
  }

  int tets_;
  long long steps_left_;
  const Progress& progress_;
  std::vector<Ray> rays_;
};

bool has_quads(const Coordinates& coordinates) {
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    if (k % 7 >= 4 && coordinates[k] != 0) return true;
  return false;
}

} // namespace

std::optional<std::vector<Coordinates>> vertex_surfaces(const Triangulation& tri, long long most_steps,
                                                        const Progress& progress) {
  if (tri.size() > most_tetrahedra) throw PreconditionError("vertex_surfaces: too many tetrahedra");
  if (Skeleton(tri).has_boundary_faces())
    throw PreconditionError("vertex_surfaces: there are boundary faces");
  DoubleDescription cone(tri, most_steps, progress);
  for (const Equation& equation : matching_equations(tri))
    if (!cone.cut(equation)) return std::nullopt;
  std::vector<Coordinates> surfaces;
  for (const Ray& ray : cone.rays()) {
    Coordinates coordinates(ray.at.begin(), ray.at.end());
    if (has_quads(coordinates)) surfaces.push_back(std::move(coordinates));
  }
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

bool is_normal_surface(const Triangulation& tri, const Coordinates& coordinates) {
  if (coordinates.size() != 7 * static_cast<std::size_t>(tri.size())) return false;
  if (std::any_of(coordinates.begin(), coordinates.end(), [](int x) { return x < 0; })) return false;
  for (int t = 0; t < tri.size(); ++t) {
    int kinds = 0;
    for (int k = 4; k < 7; ++k) kinds += coordinates[triangle(t, k)] > 0 ? 1 : 0;
    if (kinds > 1) return false;
  }
  for (const Equation& equation : matching_equations(tri)) {
    long long sum = 0;
    for (const auto& [k, sign] : equation.terms) sum += static_cast<long long>(sign) * coordinates[k];
    if (sum != 0) return false;
  }
  return true;
}

} // namespace tetrarch::reasons
