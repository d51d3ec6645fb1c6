// SPDX-License-Identifier: GPL-2.0-or-later
#include "folded_part.hpp"

#include "tetrarch/unfold/unfold.hpp"

#include <cmath>

namespace tetrarch::slit {
namespace {

using Complex = std::complex<double>;
using numeric::Point;
using unfold::Freedom;

Freedom freedom_of(const std::optional<Complex>& direction) {
  if (!direction) return {Freedom::Kind::fixed, {}};
  if (*direction == 0.0) return {Freedom::Kind::plane, {0, 0, 1}};
  const Complex unit = *direction / std::abs(*direction);
  return {Freedom::Kind::line, {unit.real(), unit.imag(), 0}};
}

Point above(Complex z, double height) {
  return {z.real(), z.imag(), height};
}

} // namespace

std::vector<Complex> unfolded(const FoldedPart& part, const Progress& progress) {
  double area = 0;
  double wanted = 0;
  for (const PartElement& e : part.elements) {
    const auto& p = part.points;
    area += numeric::cross(p[e.corner[1]] - p[e.corner[0]], p[e.corner[2]] - p[e.corner[0]]);
    wanted += numeric::twice_area(e.wanted);
  }
  if (!(area > 0 && wanted > 0)) return part.points;
  // A mean triangle has the size of the height of d.
  const double scale = std::sqrt(static_cast<double>(part.elements.size()) / area);
  const double wish = std::sqrt(static_cast<double>(part.elements.size()) / wanted);
  unfold::Problem problem;
  std::vector<Point> points;
  for (std::size_t v = 0; v < part.points.size(); ++v) {
    points.push_back(above(scale * part.points[v], 0));
    problem.freedom.push_back(freedom_of(part.freedom[v]));
  }
  for (const PartElement& e : part.elements) {
    const Complex first = wish * (e.wanted[1] - e.wanted[0]);
    const Complex second = wish * (e.wanted[2] - e.wanted[0]);
    if (!(numeric::cross(first, second) > 0))
      return part.points; // no energy asks for a triangle without area
    const int d = static_cast<int>(points.size());
    Point over = points[e.corner[0]];
    over[2] = 1;
    points.push_back(over);
    problem.freedom.push_back({Freedom::Kind::plane, {0, 0, 1}});
    problem.elements.push_back(unfold::element({e.corner[0], e.corner[1], e.corner[2], d},
                                               {above(first, 0), above(second, 0), above(0, 1)}));
  }
  unfold::Options budget;
  budget.most_rounds = 40;
  budget.iterations = 100;
  const unfold::Unfolded done = unfold::unfold(problem, std::move(points), budget, progress);
  std::vector<Complex> result;
  for (std::size_t v = 0; v < part.points.size(); ++v)
    result.push_back(part.freedom[v] ? Complex(done.points[v][0], done.points[v][1]) / scale
                                     : part.points[v]);
  return result;
}

} // namespace tetrarch::slit
