// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Which triangles are to be turned so that a surface is oriented, as far as it can be.

#include "tetrarch/surface/surface.hpp"

#include <vector>

namespace tetrarch::doctor {

using surface::Parts;
using surface::Side;
using surface::sides_of;
using surface::Surface;

/// The connected parts, and signs along a tree in each of them: +1 for its first triangle, and mates are
/// turned where signs differ. In an orientable part that holds for all mates, not only those of the tree. The
/// trees are breadth first, for what is left turned in a non-orientable part are the mates at which its
/// branches meet: on paths as short as that, few.
struct Signs {
  Parts parts;
  std::vector<int> sign;
  std::vector<char> orientable; ///< of each part
};

/// O(n).
Signs signs_of(const Surface& surface);

/// For each triangle whether it is to be turned: in orientable parts the lesser number, of two halves the one
/// without the first triangle; in others none. O(n).
std::vector<char> minority(const Signs& signs);

} // namespace tetrarch::doctor
