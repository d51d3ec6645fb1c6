// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Isomorphism signatures as people pass them on: bare, or decorated.
///
///     cPcbbbiht              the triangulation
///     cPcbbbiht_BaCB         SnapPy: and peripheral curves, as small integers in letters
///     cPcbbbiht_BaCB(1,2)    SnapPy: and a Dehn filling for each cusp, (0,0) for none
///     cPcbbbiht_12           the veering census: and a taut angle structure, for each tetrahedron the
///                            number 0, 1, 2 of the pair of opposite edges whose angle is pi
///
/// The triangulation is read and the decoration passed over. Sources: the documentation of SnapPy
/// (`Triangulation.triangulation_isosig`); Giannopoulos, Schleimer, Segerman, "A census of veering
/// structures" (2019).

#include "tetrarch/format/collection.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::format {

/// Whether `read_signature_text` would read the word. O(length).
bool is_signature_text(std::string_view word);

/// The triangulation, its decoration and any filling noted in the ledger. Throws InputError without a place:
/// for a signature as `from_signature` does, for a decoration that is none of the above. O(length).
Document read_signature_text(std::string_view word);

/// A line of such a list, without white space at its ends.
struct ListedLine {
  int number; ///< from 1
  std::string_view text;
};
/// Without empty lines and comments. Lines end with a line feed, a carriage return or both. O(length).
std::vector<ListedLine> listed_lines(std::string_view text);

/// Splits "(1,2)(0,0)" from the end of a word and notes each filling but (0,0). What is left is given back,
/// the whole word if its end is no row of fillings.
std::string_view without_fillings(std::string_view word, Ledger& passed_over);

/// A list: one signature a line, after it on the line a name, if there is one. Blank lines and those that
/// begin with # are passed over in silence. A line that is wrong is an element that says so. O(length).
Collection read_signatures(std::string_view text, const std::string& source);

} // namespace tetrarch::format
