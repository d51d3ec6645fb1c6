// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From the loops of a circular domain to all vertices, in logs.
///
///     z = exp(log r + i theta + f),   f = log(z / z_concentric) on the loops, harmonic inside
///
/// z itself spans e^-modulus, and an extension of it would have an error against 1 everywhere. log r + i
/// theta is the ring's own map and f is smooth and of order 1 throughout, so the error is relative to |z|. It
/// is not relative to the distance from a circle that hangs on a long branch aside: such circles have logs of
/// their own, about their own centers, and the maps are blended, each where it is the best one.

#include "tetrarch/slit/circular_map.hpp"

namespace tetrarch::slit {

/// The places of all vertices when the curves of the ring, `from`, go to `onto`, sample by sample; `loop` is
/// that of each curve. Two right-hand sides.
std::vector<std::complex<double>> extended_in_logs(const OneForms& forms, const SlitMap& map,
                                                   const std::vector<int>& loop, const LogCurves& from,
                                                   const LogCurves& onto);

/// Puts vertices near small circles right, sixteen circles at most: those smallest against their distance to
/// the nearest other circle. Two right-hand sides and a slit map for each.
void refine_branches(const OneForms& forms, const SlitMap& map, CircularMap& circular);

} // namespace tetrarch::slit
