// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Triangles too thin to compute on, and how they are taken out of a surface.
///
///     .---------------.    needle: two of its vertices are nearly one; that edge is collapsed
///      `------------'
///     .-------.-------.    cap: a vertex lies on the longest edge, which is flipped into the triangle
///                          behind it; on the boundary the cap is taken away

#include "tetrarch/format/soup.hpp"

#include <array>
#include <cstdint>

namespace tetrarch::doctor {

/// Whether an angle is smaller than 1e-10. One that has no area is thin.
bool is_thin(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c);

struct ThinMended {
  std::int64_t collapsed = 0; ///< edges
  std::int64_t flipped = 0;   ///< edges
  std::int64_t removed = 0;   ///< caps at the boundary
  bool ended_early = false;   ///< twenty steps for each thin triangle were not enough
};

/// Of a soup of triangles that are proper and oriented, with finite points. Nothing is done that changes what
/// the surface is glued like, or turns another triangle over; so a thin triangle may stay. Vertices move by
/// 1e-9 of their edges at most. O(n), and the collapsed edges times the neighbors of their ends.
ThinMended mend_thin_triangles(format::Soup& soup);

} // namespace tetrarch::doctor
