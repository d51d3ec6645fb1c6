// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/polycube/labels.hpp"

#include "cut.hpp"
#include "tetrarch/numeric/vector.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace tetrarch::polycube {
namespace {

using namespace numeric;
using surface::Side;

/// An edge between two triangles, and what it costs between two axes.
struct Seam {
  int first = 0;
  int second = 0;
  double weight = 0;
};

std::vector<Seam> seams_of(const product::Solid& solid, const Facets& facets, double smoothness) {
  constexpr double sharp = 0.25; // deviation from 1 of the normals' product at which edges become cheap
  const surface::Surface& surface = solid.boundary;
  const double length = smoothness * std::sqrt(facets.total);
  std::vector<Seam> result;
  for (int t = 0; t < surface.triangle_count(); ++t)
    for (const Side s : surface::sides_of(t)) {
      const int u = surface.mate(s).triangle();
      if (u <= t) continue;
      const double bend = (dot(facets.normal[t], facets.normal[u]) - 1) / sharp;
      const double size =
          distance(solid.point(solid.vertex[surface.from(s)]), solid.point(solid.vertex[surface.to(s)]));
      result.push_back({t, u, length * size * std::exp(-bend * bend / 2)});
    }
  return result;
}

/// Between two labels: a metric, as alpha expansion asks.
double apart(Label a, Label b) {
  return a == b ? 0 : are_opposite(a, b) ? 2 : 1;
}

} // namespace

Vector direction_of(Label label) {
  Vector result{};
  result[axis_of(label)] = sign_of(label);
  return result;
}

Facets::Facets(const product::Solid& solid) {
  for (int t = 0; t < solid.boundary.triangle_count(); ++t) {
    const Point& p = solid.point(solid.corner(t, 0));
    const Vector twice = cross(solid.point(solid.corner(t, 1)) - p, solid.point(solid.corner(t, 2)) - p);
    normal.push_back(direction(twice).value_or(Vector{}));
    area.push_back(length(twice) / 2);
    total += area.back();
  }
}

std::vector<Label> labeled(const product::Solid& solid, const Facets& facets, double smoothness,
                           const Progress& progress) {
  const std::vector<Seam> seams = seams_of(solid, facets, smoothness);
  const std::size_t count = facets.area.size();
  const double mean = facets.total / static_cast<double>(count);
  const auto cost = [&](std::size_t t, Label label) {
    return facets.area[t] * (1 - dot(facets.normal[t], direction_of(label)));
  };
  std::vector<Label> label(count, 0);
  for (std::size_t t = 0; t < count; ++t)
    for (Label other = 1; other < labels; ++other)
      if (cost(t, other) < cost(t, label[t])) label[t] = other;
  // Each label in turn takes what it wants, until none wants anything for a whole round.
  constexpr int most_rounds = 20;
  int content = 0;
  for (int k = 0; content < labels && k < most_rounds * labels; ++k) {
    progress.step("labels");
    const Label taking = k % labels;
    Cut cut(count);
    for (std::size_t t = 0; t < count; ++t)
      cut.add(static_cast<int>(t), (cost(t, taking) - cost(t, label[t])) / mean);
    for (const Seam& s : seams) {
      const Label a = label[s.first];
      const Label b = label[s.second];
      const double both = apart(a, b);        // stay
      const double second = apart(a, taking); // the second alone becomes `taking`
      const double first = apart(taking, b);
      const double weight = s.weight / mean;
      cut.add(s.first, weight * (first - both));
      cut.add(s.second, -weight * first);
      cut.add(s.first, s.second, weight * (second + first - both));
    }
    const std::vector<char> takes = cut.solve();
    bool is_changed = false;
    for (std::size_t t = 0; t < count; ++t)
      if (takes[t] != 0 && label[t] != taking) {
        label[t] = taking;
        is_changed = true;
      }
    content = is_changed ? 0 : content + 1;
  }
  return label;
}

} // namespace tetrarch::polycube
