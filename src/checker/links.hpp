// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Why curvatures of dropped edges vanish at a finite vertex.
///
/// The link of a finite vertex is a sphere of spherical triangles, and an end of edge e a cone point of angle
/// 2 pi - K_e in it. Lay the triangles out along a tree: every end of a dropped edge gets a direction x.
/// Where all other curvatures are 0, the turns by -K around these x, one after the other, make up a loop that
/// bounds a disk without cone points: their product is the identity. As unit quaternions it is 1 (not -1 if
/// the sum of |K| is at most 2, for e < 3), and |exp(A) exp(B) ... - 1 - (A + B + ...)| <= a^2 for a = |A| +
/// |B| + ... <= 1. So |sum K x| <= (sum |K|)^2 / 2. With three dropped edges for each such vertex that is
/// regular in K, and leaves K = 0 alone near 0.

#include "gluing.hpp"
#include "tetrahedron.hpp"

#include <vector>

namespace tetrarch::checker {

/// What is known on the box, by tetrahedron or by class of edges.
struct OnBox {
  const std::vector<std::array<FaceGluing, 4>>& gluings;
  const Classes& classes;
  const std::vector<Interval>& lengths;
  const std::vector<Interval>& curvature;
  const std::vector<std::array<Interval, 6>>& angles;
};

/// One line for each cusp, the numbers of ends there; three for each finite vertex, the sums of directions of
/// ends; a column for each of the edges. `most_ends`: of these edges at one finite vertex.
std::vector<std::vector<Interval>> identities(const OnBox& box, const std::vector<int>& edges,
                                              int& most_ends);

/// Whether the curvatures of the classes `dropped` are 0 wherever those of the others are. At cusps their sum
/// over all ends is 0.
bool dropped_vanish(const OnBox& box, const std::vector<int>& dropped);

} // namespace tetrarch::checker
