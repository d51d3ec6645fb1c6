// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What kind of group the isometries form, and whether one of them reverses orientation.

#include "tetrarch/core/isomorphism.hpp"
#include "tetrarch/core/triangulation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::canonical {

/// The product of two elements by their numbers; element 0 is the identity.
using MultiplicationTable = std::vector<std::vector<int>>;

/// Of automorphisms of one triangulation that form a group; the identity is put first. O(n^2 log n) for n of
/// them. Throws PreconditionError if they are no group.
MultiplicationTable multiplication_table(std::vector<Isomorphism> group);

/// "trivial", "Z/4", "Z/2 + Z/2", "D4" (dihedral, of order 8), "A4", "S4", "A5", "S5", "Q8", or a product of
/// one of these with a Z/2: "A4 x Z/2". Empty where the group is none of these, or has more than 500
/// elements.
std::string name_of_group(const MultiplicationTable& group);

/// Whether some of these automorphisms reverses the orientation; nothing if there is no orientation.
std::optional<bool> is_amphichiral(const Triangulation& tri, const std::vector<Isomorphism>& automorphisms);

} // namespace tetrarch::canonical
