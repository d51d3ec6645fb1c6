// SPDX-License-Identifier: GPL-2.0-or-later
#include "placing.hpp"

#include "full_turn.hpp"

namespace tetrarch::slit {

using surface::Side;
using Complex = std::complex<double>;

void shift_on_cylinder(const surface::Surface& surface, SlitMap& map, const std::vector<Complex>& shift) {
  for (std::size_t v = 0; v < shift.size(); ++v) {
    map.log_radius[v] += shift[v].real();
    map.angle[v] = wrapped(map.angle[v] + shift[v].imag());
  }
  for (int s = 0; s < surface.side_count(); ++s) {
    const Complex change = shift[surface.to(Side(s))] - shift[surface.from(Side(s))];
    map.form.real[s] += change.real();
    map.form.imaginary[s] += change.imag();
  }
}

void move_on_ring(const OneForms& forms, SlitMap& map, const std::vector<Complex>& before,
                  const std::vector<Complex>& now) {
  const surface::Surface& surface = forms.mesh().surface;
  const std::vector<int> loop = surface::loops_of_vertices(forms.loops(), surface);
  std::vector<Complex> shift(now.size(), 0.0);
  for (std::size_t v = 0; v < now.size(); ++v) {
    if (now[v] == before[v]) continue;
    shift[v] = std::log(now[v] / before[v]);
    map.log_radius[v] += loop[v] < 0 ? shift[v].real() : 0;
    map.angle[v] = wrapped(std::arg(now[v]));
  }
  for (int s = 0; s < surface.side_count(); ++s) {
    const int from = surface.from(Side(s));
    const int to = surface.to(Side(s));
    map.form.real[s] = map.log_radius[to] - map.log_radius[from];
    map.form.imaginary[s] += shift[to].imag() - shift[from].imag();
  }
}

} // namespace tetrarch::slit
