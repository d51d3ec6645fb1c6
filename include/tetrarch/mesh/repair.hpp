// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What can be mended in a soup without asking what was meant.
///
/// A tetrahedron of negative volume gets its last two vertices exchanged; of several tetrahedra on the same
/// four vertices the first is kept; points that no tetrahedron names are removed. Law: of the findings of
/// `validate` on the result, none is repairable, unless an index is out of range; then unused points are
/// kept, as renumbering would make another point of it.

#include "tetrarch/format/soup.hpp"

#include <string>
#include <vector>

namespace tetrarch::mesh {

struct Repaired {
  format::Soup soup;
  std::vector<std::string> done; ///< a sentence for each kind of repair that was needed
};

/// What is left keeps the numbers and lines that it has in the file. O(n log n) in the worst case, in
/// practice linear.
Repaired repair(format::Soup soup);

} // namespace tetrarch::mesh
