// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Diagrams by name.
///
///     4_1                  the first knot of four crossings in Rolfsen's table, which ends with 10_165
///     K11a1, K11n34        knots of eleven crossings, to K11a367 and K11n185 (KnotInfo's 11n_34 is the same)
///     L6a4, L9n28          links to nine crossings, by Thistlethwaite's names
///     hk5_3                genus two handlebody-knots to six crossings: a graph whose neighborhood it is
///     theta3_1             theta curves to six crossings
///     handcuff4_1          handcuff graphs to six crossings
///
/// Sources of all but the knots stand with their codes (src/diagram/named_graphs.cpp). Each knot is given as
/// the closure of a braid (of eleven crossings by a code that leaves the mirror image open), so that its
/// diagram may have more crossings than the knot needs. The images are Rolfsen's, as the Knot Atlas has them:
/// 3_1 is the left-handed trefoil. Source: Rolfsen, "Knots and Links" (1976), appendix C; Bar-Natan, Morrison
/// and others, "The Knot Atlas" (katlas.org).

#include "tetrarch/diagram/diagram.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::diagram {

/// The knot, link or graph; nothing if no table has the name. "0_1" is the unknot.
std::optional<Diagram> named_diagram(std::string_view name);
/// Its braid: k is generator k, -k the inverse.
std::optional<std::vector<int>> rolfsen_braid(std::string_view name);

/// The names of all knots, in the order of the table.
std::vector<std::string> diagram_names();

/// Of K11a1, ..., K11n185 the code of Dowker and Thistlethwaite as text: "DT[4, 8, ...]"; and their names.
std::optional<std::string> eleven_crossing_code(std::string_view name);
std::vector<std::string> eleven_crossing_names();

/// The same of links and graphs.
std::optional<Diagram> tabulated_diagram(std::string_view name);
std::vector<std::string> tabulated_names();

} // namespace tetrarch::diagram
