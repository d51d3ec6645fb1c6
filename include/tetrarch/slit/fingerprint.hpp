// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fingerprints: numbers of a surface with holes that no conformal map changes, and the distance between the
/// fingerprints of two surfaces.
///
/// They are read off the slit ring and the circular domain, both normalized: the outer circle is the unit
/// circle, the inner one is about 0, the first other loop's slit starts at angle 0, and its circle has its
/// center on the positive real axis. Each surface with n loops has 3n - 6 real invariants (one for n = 2);
/// either domain has them all, once what is 0 is left out.
///
/// Numbers come with an error: the map is computed again on finer triangulations of the same surface (each
/// triangle in four), and extrapolated. Source: Yin, section 2.4.1 and table 2.1, whose vectors [r1, r2, r3,
/// e2, s3, e3] are of the ring with four loops.

#include "tetrarch/slit/circular_map.hpp"

namespace tetrarch::slit {

struct Fingerprint {
  /// The inner radius, then radius, start, end of each slit by number of its loop; angles in radians.
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
Fingerprint fingerprint(const mesh::TriangleMesh& mesh, int outer, int inner, int most_triangles = 500'000,
                        const Progress& progress = {});

/// The square root of the sum of all squared differences between centers and radii in the disk, after the
/// rotation that makes it least. The loops of one correspond to those of the other in their order. Throws
/// InputError unless both have the same number of loops.
double distance(const Fingerprint& a, const Fingerprint& b);

} // namespace tetrarch::slit
