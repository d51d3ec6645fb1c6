// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/fingerprint.hpp"

#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/mesh/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;

/// The numbers on one triangulation. `vertex` names the loops: they may be numbered otherwise here.
struct Level {
  std::vector<double> ring;
  std::vector<double> disk;
  bool found = false;
};

Level level(const mesh::TriangleMesh& mesh, const std::vector<int>& vertex, int outer, int inner) {
  const OneForms forms(mesh, {}, Edges::intrinsic_delaunay);
  std::vector<int> loop;
  loop.reserve(vertex.size());
  for (const int v : vertex) loop.push_back(mesh::loop_through(forms.loops(), mesh.surface, v));
  const SlitMap map = slit_map(forms, loop[outer], loop[inner]);
  const CircularDomain domain = circular_domain(slit_ring(map));
  Level result{{std::exp(-map.modulus)}, {domain.circles[1].radius}, domain.found};
  double origin = 0;
  Complex turn = 1;
  for (const int k : loop) {
    const auto found =
        std::find_if(map.slits.begin(), map.slits.end(), [&](const Slit& s) { return s.loop == k; });
    if (found == map.slits.end()) continue;
    const Circle& circle = domain.circles[static_cast<std::size_t>(found - map.slits.begin()) + 2];
    if (result.ring.size() == 1) {
      origin = found->start;
      turn = std::conj(circle.center) / std::abs(circle.center);
    }
    const double start = wrapped(found->start - origin);
    const Complex center = circle.center * turn;
    result.ring.insert(result.ring.end(), {found->radius, start, start + (found->end - found->start)});
    result.disk.insert(result.disk.end(), {center.real(), center.imag(), circle.radius});
  }
  return result;
}

/// The last of some values on triangulations each twice as fine, extrapolated. Errors fall by 4 where all is
/// smooth, and by 2 at worst, at corners of the boundary; where they do neither, nothing is extrapolated.
struct Extrapolated {
  double value = 0;
  double error = std::numeric_limits<double>::infinity();
};

Extrapolated extrapolated(const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n < 2) return {values.back()};
  const double step = values[n - 1] - values[n - 2];
  if (n < 3) return {values.back(), std::abs(step)};
  constexpr double slowest = 1.4;
  constexpr double fastest = 8;
  const double factor = (values[n - 2] - values[n - 3]) / step;
  if (!(factor > slowest && factor < fastest)) return {values.back(), std::abs(step)};
  const double rest = step / (std::min(factor, 4.0) - 1);
  return {values.back() + rest, std::abs(rest)};
}

template <class Numbers>
void extrapolate(const std::vector<Level>& levels, const Numbers& numbers, std::vector<double>& value,
                 std::vector<double>& error, bool are_angles) {
  for (std::size_t k = 0; k < numbers(levels[0]).size(); ++k) {
    std::vector<double> values;
    for (const Level& one : levels) {
      const double x = numbers(one)[k];
      // Starts near 0 may come out near 2 pi.
      const bool is_angle = are_angles && k > 0 && k % 3 != 1;
      values.push_back(is_angle && !values.empty() ? values[0] + std::remainder(x - values[0], full_turn)
                                                   : x);
    }
    const Extrapolated best = extrapolated(values);
    value.push_back(best.value);
    error.push_back(best.error);
  }
}

} // namespace

Fingerprint fingerprint(const mesh::TriangleMesh& mesh, int outer, int inner, int most_triangles,
                        const Progress& progress) {
  std::vector<int> vertex;
  for (const auto& loop : mesh::boundary_loops(mesh))
    vertex.push_back(mesh.surface.vertex(loop.sides.front()));
  for (const int loop : {outer, inner})
    if (loop < 0 || loop >= static_cast<int>(vertex.size()))
      throw InputError("there is no loop " + std::to_string(loop));
  Fingerprint result;
  std::vector<Level> levels;
  const double most = std::max(most_triangles, mesh.surface.triangle_count());
  mesh::TriangleMesh fine = mesh;
  while (true) {
    progress.step("triangulations", fine.surface.triangle_count() / (2 * most));
    levels.push_back(level(fine, vertex, outer, inner));
    result.triangles.push_back(fine.surface.triangle_count());
    result.found = result.found && levels.back().found;
    if (4.0 * fine.surface.triangle_count() > most) break;
    fine = mesh::refined(fine);
  }
  const auto ring = [](const Level& one) -> const std::vector<double>& { return one.ring; };
  const auto disk = [](const Level& one) -> const std::vector<double>& { return one.disk; };
  extrapolate(levels, ring, result.ring, result.ring_error, true);
  extrapolate(levels, disk, result.disk, result.disk_error, false);
  return result;
}

double distance(const Fingerprint& a, const Fingerprint& b) {
  if (a.disk.size() != b.disk.size())
    throw InputError("fingerprints of " + std::to_string((a.disk.size() + 5) / 3) + " and " +
                     std::to_string((b.disk.size() + 5) / 3) + " loops cannot be compared");
  const auto center = [](const Fingerprint& f, std::size_t k) { return Complex(f.disk[k], f.disk[k + 1]); };
  Complex product = 0;
  for (std::size_t k = 1; k < a.disk.size(); k += 3) product += std::conj(center(a, k)) * center(b, k);
  const Complex turn = product == 0.0 ? 1.0 : product / std::abs(product);
  double squares = (a.disk[0] - b.disk[0]) * (a.disk[0] - b.disk[0]);
  for (std::size_t k = 1; k < a.disk.size(); k += 3) {
    const double radii = a.disk[k + 2] - b.disk[k + 2];
    squares += std::norm(turn * center(a, k) - center(b, k)) + radii * radii;
  }
  return std::sqrt(squares);
}

} // namespace tetrarch::slit
