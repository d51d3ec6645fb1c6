// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How vertices of a slit map are moved, so that all that the map says stays true.

#include "tetrarch/slit/slit_map.hpp"

#include <complex>
#include <vector>

namespace tetrarch::slit {

/// By a shift of w = log_radius + i angle of each vertex.
void shift_on_cylinder(const surface::Surface& surface, SlitMap& map,
                       const std::vector<std::complex<double>>& shift);

/// From `before` to `now`, places in the ring. Those of loops keep their radius.
void move_on_ring(const OneForms& forms, SlitMap& map, const std::vector<std::complex<double>>& before,
                  const std::vector<std::complex<double>>& now);

} // namespace tetrarch::slit
