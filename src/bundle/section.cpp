// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/section.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::bundle {
namespace {

using mesh::Surface;

void require_finite(const std::vector<double>& numbers, int count) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (static_cast<int>(numbers.size()) != count || !std::all_of(numbers.begin(), numbers.end(), finite))
    throw PreconditionError("a finite number for each vertex is needed");
}

/// How far the section rises along side s, as the ring of its triangle has it, but for whole turns.
double rise_along(const CircleBundle& bundle, const Fibers& fibers, const std::vector<double>& place,
                  Side s) {
  const Fibers::Reference& r = fibers.reference[s.value];
  const int t = 3 * s.triangle();
  const double before = r.start - place[bundle.base.from(s)];
  const double after = place[bundle.base.to(s)] - r.stop;
  return fibers.up[t + s.next().corner()] * before + r.rise + fibers.up[t + s.previous().corner()] * after;
}

} // namespace

std::vector<int> indices(const CircleBundle& bundle, const Fibers& fibers, const std::vector<double>& place) {
  const Surface& base = bundle.base;
  require_finite(place, base.vertex_count());
  const double n = bundle.fiber;
  // Whole turns are taken off to make the way short, as the side of less number sees it. Its mate sees them
  // with the opposite sign: either it runs the other way, or, where mates are turned, its up is down.
  std::vector<double> rise(static_cast<std::size_t>(base.side_count()));
  for (int k = 0; k < base.side_count(); ++k) {
    const Side s(k);
    const Side m = base.mate(s);
    if (m.exists() && m.value < k) continue;
    const double along = rise_along(bundle, fibers, place, s);
    const double turns = std::round(along / n);
    rise[k] = along - turns * n;
    if (m.exists()) rise[m.value] = rise_along(bundle, fibers, place, m) + turns * n;
  }
  std::vector<int> index(static_cast<std::size_t>(base.triangle_count()));
  for (int t = 0; t < base.triangle_count(); ++t) {
    double sum = 0;
    for (const Side s : sides_of(t)) sum += rise[s.value];
    index[t] = static_cast<int>(std::lround(sum / n));
  }
  return index;
}

} // namespace tetrarch::bundle
