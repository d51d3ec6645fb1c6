// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Isomorphisms that respect marks, and signatures that tell them.
///
/// An isomorphism of marked triangulations takes every edge to one of the same order. So it is a
/// homeomorphism of the pairs of manifold and graph; where all orders are whole numbers, one of orbifolds.

#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/marks.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch {

/// A triangulation and its marks, without fault.
struct MarkedView {
  const Triangulation& tri;
  const Marks& marks;
};

/// Whether an isomorphism takes edges to edges of the same order. O(n).
bool respects_marks(const Isomorphism& iso, const MarkedView& a, const MarkedView& b);

/// All isomorphisms between two connected triangulations that respect marks, ordered as `isomorphisms` does.
/// Throw PreconditionError where `fault_of` finds one, or for a triangulation that is not connected. O(n^2).
std::vector<Isomorphism> marked_isomorphisms(const MarkedView& a, const MarkedView& b);
/// The first, or nothing.
std::optional<Isomorphism> find_marked_isomorphism(const MarkedView& a, const MarkedView& b);

/// A text that two connected marked triangulations share exactly if an isomorphism respects the marks: the
/// signature, and behind "_" the marks of the labeling, among those that give the signature, that lists them
/// first: "cMcabbgig_0-01:0_0-13:0_1-23:0". Without marks the signature alone. O(n) for each automorphism.
std::string marked_signature(const MarkedView& marked);

} // namespace tetrarch
