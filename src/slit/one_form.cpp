// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/slit/one_form.hpp"

namespace tetrarch::slit {

using surface::Side;

OneForm differential(const surface::Surface& surface, const std::vector<double>& f) {
  OneForm df(static_cast<std::size_t>(surface.side_count()));
  for (int k = 0; k < surface.side_count(); ++k) df[k] = f[surface.to(Side(k))] - f[surface.from(Side(k))];
  return df;
}

double wedge(const surface::Surface& surface, const OneForm& a, const OneForm& b) {
  double sum = 0;
  // Side 0 runs from corner 1 to 2, side 1 from corner 2 to 0.
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const int first = Side(t, 0).value;
    const int second = Side(t, 1).value;
    sum += a[first] * b[second] - a[second] * b[first];
  }
  return sum / 2;
}

double inner_product(const std::vector<double>& weight, const OneForm& a, const OneForm& b) {
  double sum = 0;
  for (std::size_t k = 0; k < weight.size(); ++k) sum += weight[k] * a[k] * b[k];
  return sum;
}

double period(const OneForm& form, const surface::BoundaryLoop& loop) {
  double sum = 0;
  for (const surface::SideEnd e : loop.sides) sum += e.at_start ? form[e.side.value] : -form[e.side.value];
  return sum;
}

} // namespace tetrarch::slit
