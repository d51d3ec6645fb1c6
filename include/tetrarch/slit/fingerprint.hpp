// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fingerprints: numbers of a surface with holes that no conformal map changes, and the distance between the
/// fingerprints of two surfaces.
///
/// They are read off the slit ring and the circular domain, both normalized: the outer circle is the unit
/// circle, the inner one is about 0, the first other loop's slit starts at angle 0, and its circle has its
/// center on the positive real axis. Loops are not told apart by their numbers, which go by length and so
/// depend on more than the conformal structure: outer and inner are the two of greatest modulus unless others
/// are asked for, and the other loops come by the radii of their slits, the outermost first. Each surface
/// with n loops has 3n - 6 real invariants (one for n = 2); either domain has them all, once what is 0 is
/// left out.
///
/// Numbers come with an error: the map is computed again on finer triangulations of the same surface (each
/// triangle in four), and extrapolated. Source: Yin, section 2.4.1 and table 2.1, whose vectors [r1, r2, r3,
/// e2, s3, e3] are of the ring with four loops.

#include "tetrarch/slit/circular_map.hpp"
#include "tetrarch/slit/matching.hpp"

#include <optional>

namespace tetrarch::slit {

struct Fingerprint {
  std::vector<int> loops; ///< the outer one, the inner one, then the others from the outermost slit on
  /// The inner radius, then radius, start, end of each slit in that order; angles in radians.
  std::vector<double> ring;
  /// The inner radius, then center (x, y) and radius of each other circle.
  std::vector<double> disk;
  /// Errors of these numbers: the distance of the extrapolation from the finest triangulation, or the last
  /// step if they do not converge evenly. Infinite if the budget allowed no finer triangulation.
  std::vector<double> ring_error;
  std::vector<double> disk_error;
  std::vector<int> triangles; ///< of the triangulations used
  bool found = true;          ///< whether all circular domains were: else `disk` is worth nothing
};

/// Triangulations have at most `most_triangles`, except the first one. Throws as `OneForms` and `slit_map`.
/// Without a pair, `farthest_loops` are the outer and the inner loop.
Fingerprint fingerprint(const surface::TriangleMesh& mesh, std::optional<LoopPair> pair = {},
                        int most_triangles = 500'000, const Progress& progress = {});

/// The circles of the disk: the unit circle, the inner one, and the others in their order.
std::vector<Circle> circles(const Fingerprint& fingerprint);

/// The least distance over all matchings of the loops: see `best_matchings`. Throws InputError unless both
/// have the same number of loops.
double distance(const Fingerprint& a, const Fingerprint& b);

} // namespace tetrarch::slit
