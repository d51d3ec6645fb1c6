// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What closed components of a surface enclose, and which of them are inside out.
///
/// The wall of a cavity is oriented against the surface around it, and rightly so. So only a component whose
/// box lies in the box of no other one is judged.

#include "orient.hpp"

#include "tetrarch/format/soup.hpp"

#include <vector>

namespace tetrarch::doctor {

struct Enclosed {
  std::vector<double> volume; ///< of each part, as most of its triangles are oriented; 0 if it is not closed
  std::vector<char> inside_out; ///< of each part
};

/// `left_out`: triangles that are at fault, whose parts are not judged. O(n + parts^2) for closed parts.
Enclosed enclosed_volumes(const format::Soup& soup, const Surface& surface, const Signs& signs,
                          const std::vector<char>& left_out);
/// The same of triangles that have been turned round already where they are the minority: which parts are
/// inside out.
std::vector<char> oriented_inside_out(const format::Soup& soup, const Surface& surface, const Signs& signs,
                                      const std::vector<char>& left_out);

} // namespace tetrarch::doctor
