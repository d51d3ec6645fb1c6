// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/fingerprint.hpp"

#include "full_turn.hpp"
#include "tetrarch/core/error.hpp"
#include "tetrarch/surface/refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;

/// The numbers on one triangulation.
struct Level {
  std::vector<double> ring;
  std::vector<double> disk;
  bool found = false;
};

/// Outer, inner, then by the radius of the slit.
std::vector<int> loops_in_order(const OneForms& forms, LoopPair pair) {
  SlitMap map = slit_map(forms, pair.outer, pair.inner);
  std::stable_sort(map.slits.begin(), map.slits.end(),
                   [](const Slit& a, const Slit& b) { return a.radius > b.radius; });
  std::vector<int> result{pair.outer, pair.inner};
  for (const Slit& s : map.slits) result.push_back(s.loop);
  return result;
}

/// `vertex` names the loops in their order: they may be numbered otherwise here.
Level level(const OneForms& forms, const std::vector<int>& vertex, const Progress& progress) {
  std::vector<int> loop;
  loop.reserve(vertex.size());
  for (const int v : vertex) loop.push_back(surface::loop_through(forms.loops(), forms.mesh().surface, v));
  const SlitMap map = slit_map(forms, loop[0], loop[1]);
  const CircularDomain domain = circular_domain(slit_ring(map), {}, progress);
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

Fingerprint fingerprint(const surface::TriangleMesh& mesh, std::optional<LoopPair> pair, int most_triangles,
                        const Progress& progress) {
  Fingerprint result;
  std::vector<int> vertex; // of each loop, in the order of the result
  std::vector<Level> levels;
  const double most = std::max(most_triangles, mesh.surface.triangle_count());
  surface::TriangleMesh fine = mesh;
  while (true) {
    progress.step("triangulations", fine.surface.triangle_count() / (2 * most));
    const OneForms forms(fine, progress.silent(), Edges::intrinsic_delaunay);
    if (levels.empty()) {
      result.loops = loops_in_order(forms, pair ? *pair : farthest_loops(forms));
      for (const int k : result.loops) vertex.push_back(mesh.surface.vertex(forms.loops()[k].sides.front()));
    }
    levels.push_back(level(forms, vertex, progress.silent()));
    result.triangles.push_back(fine.surface.triangle_count());
    result.found = result.found && levels.back().found;
    if (4.0 * fine.surface.triangle_count() > most) break;
    fine = surface::refined(fine);
  }
  const auto ring = [](const Level& one) -> const std::vector<double>& { return one.ring; };
  const auto disk = [](const Level& one) -> const std::vector<double>& { return one.disk; };
  extrapolate(levels, ring, result.ring, result.ring_error, true);
  extrapolate(levels, disk, result.disk, result.disk_error, false);
  return result;
}

std::vector<Circle> circles(const Fingerprint& fingerprint) {
  std::vector<Circle> result{{0, 1, 0}, {0, fingerprint.disk.at(0), 0}};
  for (std::size_t k = 1; k < fingerprint.disk.size(); k += 3)
    result.push_back({{fingerprint.disk[k], fingerprint.disk[k + 1]}, fingerprint.disk[k + 2], 0});
  return result;
}

double distance(const Fingerprint& a, const Fingerprint& b) {
  return best_matchings(circles(a), circles(b)).front().distance;
}

} // namespace tetrarch::slit
