// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// How the tetrahedra of a soup are to be oriented: component by component, with the sign of the larger
/// volume.

#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/format/soup.hpp"

#include <vector>

namespace tetrarch::doctor {

/// For each tetrahedron +1 if it is listed as its component is oriented, -1 if two of its vertices are to be
/// exchanged, 0 where that cannot be said: `proper` is 0, or the component is not orientable. `tri` has the
/// gluings of the proper ones. If a component's volume is 0 or no number, its first tetrahedron decides.
/// O(n).
std::vector<int> solid_signs(const format::Soup& soup, const Triangulation& tri,
                             const std::vector<char>& proper);

/// The volume of a proper tetrahedron, rounded.
double rounded_volume(const format::Soup& soup, const std::array<int, 4>& corners);

} // namespace tetrarch::doctor
