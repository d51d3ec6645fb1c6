// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The rectangle with rectangular holes, for `conformal_map`.

#include "tetrarch/workshop/slit.hpp"

namespace tetrarch::workshop {

/// All of the map but the surface. Throws InputError as `slit::ricci_rectangles`, Stopped if the progress
/// says so.
ConformalMap map_to_rectangle(const HoledSurface& surface, const MapOptions& options,
                              const Progress& progress);

} // namespace tetrarch::workshop
