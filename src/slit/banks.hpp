// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Loops put in order on their slits.
///
///           r              A triangle with side pq on a slit lies above the slit or below it, as its apex
///          / \             does, and so tells in which direction pq must run. So the slit turns back where
///     ----p---q            apexes change sides: at vertices, while the harmonic angle turns back between
///     ==========>          them, at one vertex sooner or later. And obtuse angles at the boundary may make
///                          it waver. Here the right vertices become the ends, and the angles between them
///                          the nearest ones (in the mean) that rise on one bank and fall on the other.
///
/// Source: Ayer, Brunk, Ewing, Reid and Silverman, "An empirical distribution function for sampling with
/// incomplete information" (1955), for the pooling.

#include "tetrarch/slit/slit_map.hpp"

#include <map>

namespace tetrarch::slit {

/// By vertex, how far its angle is to be moved. Slits whose apexes change sides more than twice are left as
/// they are. O(size of the loops).
std::map<int, double> shifts_into_order(const OneForms& forms, const SlitMap& map);

} // namespace tetrarch::slit
