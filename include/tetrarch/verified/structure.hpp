// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The proof that a gluing carries a hyperbolic structure, with enclosures of its lengths and its volume.
///
/// A structure is a zero of the edge curvatures K(l). Take a point m near one, an approximate inverse Y of
/// -K'(m), and the box X of all l within r of m. Krawczyk's map sends X into
///
///     m + Y K(m) + (1 + Y K'(X)) (X - m),
///
/// computed in balls. If that lies in the inside of X, K has exactly one zero in X. If moreover every
/// tetrahedron exists on all of X, the zero is a hyperbolic structure with geodesic boundary and cusps.
///
/// At a cusp the horosphere is free, and the curvatures of the edges, each counted once for each end in the
/// cusp, add up to 0 exactly. So for each cusp one length is fixed and one equation dropped: edges e_1 ...
/// e_c such that the matrix (ends of e_j at cusp i) is invertible. Then the dropped equations follow from the
/// others.
///
/// A finite vertex (of a closed manifold) may be any point: three lengths are fixed for each, and three
/// equations dropped. They follow because the link is a sphere: once around all of its cone points is no turn
/// at all. That is not linear in K, but nearly so, and balls bound the rest (src/verified/gauge.hpp has the
/// proof). Sources: Krawczyk 1969; Moore-Kearfott-Cloud 2009, section 8.2; HIKMOT (2016) for cusps.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"
#include "tetrarch/numeric/ball.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::verified {

/// What was proved.
struct StructureProof {
  int bits = 0; ///< of the midpoints and of the arithmetic
  /// Of each edge the ball that holds its length in the one structure near by: an exact midpoint, and the
  /// same radius everywhere. Those of `fixed` are exact; they choose the horospheres and the points.
  hyperbolic::Metric<numeric::Ball> lengths;
  numeric::Ball radius = 0; ///< exact
  /// One edge for each cusp and three for each finite vertex, in increasing order.
  std::vector<EdgeId> fixed;
  numeric::Ball volume = 0; ///< holds the volume
};

/// The ends of an interval that holds the volume, in decimal; rounded outward.
struct VolumeInterval {
  std::string low, high;
};
VolumeInterval volume_interval(const StructureProof& proof);

/// A proof, or the sentence that says what failed. That is no proof that there is no structure.
struct Certification {
  std::optional<StructureProof> proof;
  std::string why_not;
};

/// With so many bits, and where that fails with twice as many, up to `most_bits`.
struct CertifyOptions {
  int bits = 53;
  int most_bits = 212;
  bool volume = true;       ///< enclose the volume, which takes most of the time; else it is 0
  int most_unknowns = 1000; ///< of the lengths; beyond it certification fails at once, with that reason
};

/// Starts from a geometric structure that was found for this triangulation. Throws PreconditionError if it is
/// none, or stale. Per attempt O(E^2) in balls and O(E^3) in doubles; 0.3 ms for four tetrahedra, a second or
/// two for a thousand.
[[nodiscard]] Certification certify(const Triangulation& tri, const Skeleton& skeleton,
                                    const hyperbolic::Hyperbolization<double>& found,
                                    const CertifyOptions& options = {}, const Progress& progress = {});

/// The same with the volume enclosed to `digits` significant digits or more.
[[nodiscard]] Certification certify_to(int digits, const Triangulation& tri, const Skeleton& skeleton,
                                       const hyperbolic::Hyperbolization<double>& found,
                                       const Progress& progress = {});

/// The lengths at which the curvatures of each block of edges add up to 0, where the edges of a block (equal
/// numbers, from 0 on) have equal lengths: balls for the one such metric whose lengths are all within `reach`
/// of the balls' midpoints. On all of that box the tetrahedra exist, and no curvature changes by 1. Nothing
/// where that is not proved, or where there are cusps or finite vertices. Whether the curvatures themselves
/// vanish is another question. In the working precision; O(E^3).
[[nodiscard]] std::optional<hyperbolic::Metric<numeric::Ball>>
solve_merged(const Skeleton& skeleton, const Table<EdgeId, int>& block,
             const hyperbolic::Metric<double>& start, double reach, const Progress& progress = {});

} // namespace tetrarch::verified
