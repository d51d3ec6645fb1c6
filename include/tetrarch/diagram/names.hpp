// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Diagrams by name: "4_1" is the first knot of four crossings in Rolfsen's table, which ends with 10_165.
///
/// Each is given as the closure of a braid, so that its diagram may have more crossings than the knot needs.
/// The images are Rolfsen's, as the Knot Atlas has them: 3_1 is the left-handed trefoil. Source: Rolfsen,
/// "Knots and Links" (1976), appendix C; Bar-Natan, Morrison and others, "The Knot Atlas" (katlas.org).

#include "tetrarch/diagram/diagram.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::diagram {

/// The knot; nothing if the table does not have the name. "0_1" is the unknot.
std::optional<Diagram> named_diagram(std::string_view name);
/// Its braid: k is generator k, -k the inverse.
std::optional<std::vector<int>> rolfsen_braid(std::string_view name);

/// All names, in the order of the table.
std::vector<std::string> diagram_names();

} // namespace tetrarch::diagram
