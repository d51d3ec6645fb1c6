// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tetrarch/core/triangulation.hpp"

namespace tetrarch {

/// The orientable double cover of n tetrahedra: tetrahedron t is covered by t and t + n, once in its own
/// handedness and once in the other; a face on the boundary by two. Of an orientable component it is two
/// copies, else connected. O(n).
Triangulation orientable_double_cover(const Triangulation& tri);

} // namespace tetrarch
