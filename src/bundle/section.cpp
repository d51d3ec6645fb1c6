// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/bundle/section.hpp"

#include "tetrarch/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tetrarch::bundle {
namespace {

using surface::Surface;

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

Section short_section(const CircleBundle& bundle, const Fibers& fibers, std::vector<double> place) {
  const Surface& base = bundle.base;
  require_finite(place, base.vertex_count());
  Section section{std::move(place), std::vector<int>(static_cast<std::size_t>(base.side_count()), 0)};
  for (int k = 0; k < base.side_count(); ++k) {
    const Side s(k);
    const Side m = base.mate(s);
    if (m.exists() && m.value < k) continue;
    section.turns[k] =
        static_cast<int>(std::lround(rise_along(bundle, fibers, section.place, s) / bundle.fiber));
    if (m.exists()) section.turns[m.value] = -section.turns[k];
  }
  return section;
}

std::vector<int> indices(const CircleBundle& bundle, const Fibers& fibers, const Section& section) {
  const Surface& base = bundle.base;
  require_finite(section.place, base.vertex_count());
  if (static_cast<int>(section.turns.size()) != base.side_count())
    throw PreconditionError("a number of turns for each side is needed");
  std::vector<int> index(static_cast<std::size_t>(base.triangle_count()));
  for (int t = 0; t < base.triangle_count(); ++t) {
    double rise = 0;
    int turns = 0;
    for (const Side s : sides_of(t)) {
      rise += rise_along(bundle, fibers, section.place, s);
      turns += section.turns[s.value];
    }
    index[t] = static_cast<int>(std::lround(rise / bundle.fiber)) - turns;
  }
  return index;
}

namespace {

/// The triangles in the order in which they are reached from the first of them, which lies on the boundary if
/// there is one, and the side by which each is left towards it.
std::vector<Side> ways_home(const Surface& surface) {
  Side first(0, 0);
  for (int k = surface.side_count(); k-- > 0;)
    if (surface.is_boundary(Side(k))) first = Side(k);
  std::vector<Side> ways{first};
  std::vector<char> seen(static_cast<std::size_t>(surface.triangle_count()), 0);
  seen[first.triangle()] = 1;
  for (std::size_t k = 0; k < ways.size(); ++k)
    for (const Side s : sides_of(ways[k].triangle())) {
      const Side m = surface.mate(s);
      if (!m.exists() || seen[m.triangle()]) continue;
      seen[m.triangle()] = 1;
      ways.push_back(m);
    }
  return ways;
}

} // namespace

Section section_with_indices(const CircleBundle& bundle, const Fibers& fibers, std::vector<double> place,
                             const std::vector<int>& index) {
  const Surface& base = bundle.base;
  if (static_cast<int>(index.size()) != base.triangle_count())
    throw PreconditionError("an index for each triangle is needed");
  Section section = short_section(bundle, fibers, std::move(place));
  std::vector<int> surplus = indices(bundle, fibers, section);
  for (std::size_t t = 0; t < surplus.size(); ++t) surplus[t] -= index[t];
  // Farthest triangles first, each hands what it has too much on towards the first one.
  const std::vector<Side> ways = ways_home(base);
  for (auto way = ways.rbegin(); way != ways.rend(); ++way) {
    const int turns = surplus[way->triangle()];
    const Side m = base.mate(*way);
    const bool is_first = way + 1 == ways.rend();
    if (is_first && m.exists() && turns != 0)
      throw PreconditionError("the indices do not add up to the Euler number, but to " +
                              std::to_string(turns) + " less");
    section.turns[way->value] += turns;
    if (!m.exists() || is_first) continue;
    section.turns[m.value] -= turns;
    surplus[m.triangle()] += turns;
  }
  return section;
}

} // namespace tetrarch::bundle
