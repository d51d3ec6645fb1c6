// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Which loop of one surface is which of another: by their circles, as the lengths of loops are not
/// conformal.
///
///      .-------.       .-------.     Circular domains of one surface differ by a Moebius map. Take any
///     /  o   O  \  ~  /  O  o   \    two circles of B to the unit circle and to one about 0, turn a third
///     \    (.)  /     \   (.)   /    one to where a certain circle of A is, and give each circle the
///      '-------'       '-------'     nearest one (in the mean square). The best of all is the matching.
///
/// No numbering of loops enters, so a surface turned, scaled, inverted in a sphere, renumbered or subdivided
/// is found to be itself. A surface with symmetries has several best matchings.

#include "tetrarch/slit/circular_domain.hpp"

#include <cstddef>
#include <vector>

namespace tetrarch::slit {

struct Matching {
  std::vector<int> to; ///< for each circle of A, in its order, the circle of B
  bool mirrored = false;
  /// The square root of the sum of all squared differences between centers and radii in A's disk, B's domain
  /// moved there and turned to where it is least.
  double distance = 0;
};

struct MatchingOptions {
  bool with_mirror_images = false; ///< whether B's mirror image counts as B
  std::size_t most = 8;            ///< matchings that are returned
};

/// The circles of a circular domain once circle `outer` is the unit circle, the domain inside it, and circle
/// `inner` is about 0: these two first, then the others in their order. Circle 0 of those given is the unit
/// circle, the domain inside. O(n).
std::vector<Circle> normalised(std::vector<Circle> circles, std::size_t outer, std::size_t inner);

/// The best matchings, from the least distance on; all have other values of `to`, or of `mirrored`. Circle 0
/// of either is the unit circle, circle 1 one about 0. Throws InputError unless both have equally many
/// circles, at least two. O(n^5) for n circles at worst; beyond 25 circles only the pairs of B whose moduli
/// come nearest to A's are tried as outer and inner circle, 600 and fewer.
std::vector<Matching> best_matchings(const std::vector<Circle>& a, const std::vector<Circle>& b,
                                     const MatchingOptions& options = {});

} // namespace tetrarch::slit
