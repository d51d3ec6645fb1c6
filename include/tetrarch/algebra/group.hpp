// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The fundamental group of a triangulated manifold, and how presentations become short.
///
/// The presentation of pi_1 is read off the dual 2-skeleton. Stand in tetrahedron 0; a spanning tree of the
/// dual graph leads to every other one. An interior face outside the tree is a generator: walk to its first
/// side along the tree, step through it to its second side, and walk home. An interior edge is a relator: go
/// once round it, turning left, and write down the faces crossed. Ideal vertices are truncated. Source:
/// Seifert and Threlfall, "Lehrbuch der Topologie" (1934), section 46, for the presentation; Havas, Kenne,
/// Richardson and Robertson, "A Tietze transformation program" (1984), for the simplification.

#include "tetrarch/algebra/abelian_group.hpp"
#include "tetrarch/algebra/presentation.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/skeleton.hpp"

#include <string>
#include <vector>

namespace tetrarch::algebra {

/// A presentation of the fundamental group, and where each generator and relator comes from.
struct DualPresentation {
  Presentation presentation;
  /// The face that generator g crosses, from this side to its partner: the first pre-image of its face class.
  /// Interior faces that are nobody's generator form the spanning tree.
  std::vector<TetFace> generator_face;
  /// The edge that a relator goes round.
  std::vector<EdgeId> relator_edge;
};

/// The unsimplified presentation: a relator for each interior edge, not reduced. Throws PreconditionError if
/// the skeleton is stale, or if the triangulation is invalid (the message names the defect), empty or not
/// connected. O(n).
DualPresentation dual_presentation(const Triangulation& tri, const Skeleton& skeleton);

struct TietzeOptions {
  /// Letters that may be looked at in the search for eliminations and common subwords; the linear phases are
  /// free. Bounds the time to about a second per 10^8.
  long long max_letters = 100'000'000;
  /// An elimination that makes the presentation longer is allowed while the total length stays below this
  /// multiple of the length at which only such eliminations are left ...
  double max_growth = 2.0;
  /// ... and below this. Up to a total of 100 letters it is always allowed.
  long long max_length = 20'000;
};

/// A presentation of the same group, with fewer generators and shorter relators. First generators that a
/// relator equates to 1 or to another generator go, in near-linear time; then, until nothing helps or the
/// budget is spent: a generator that occurs once in a relator is expressed by the others (shortest relator
/// first), and a relator of which more than half occurs in another one shortens that. Relators come out
/// cyclically reduced, none empty, none the same as another up to rotation and inversion, ordered by length
/// and then by letters. Deterministic; a spent budget costs quality, never correctness.
/// Throws PreconditionError if a letter names no generator.
Presentation simplified(const Presentation& presentation, const TietzeOptions& options = {},
                        const Progress& progress = {});

/// A presentation of the same group, each of whose generators is one of the given ones.
struct Kept {
  Presentation presentation;
  std::vector<int> generator; ///< of each generator, which of the given ones it is; increasing
};
/// `simplified`, and which generators are left. Those of a `dual_presentation` still cross their faces.
Kept simplified_keeping(const Presentation& presentation, const TietzeOptions& options = {},
                        const Progress& progress = {});

/// The abelianised group. Throws PreconditionError if a letter names no generator.
AbelianGroup abelianized(const Presentation& presentation);

} // namespace tetrarch::algebra
