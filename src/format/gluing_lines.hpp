// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The two lines per tetrahedron that SnapPea files and the Frigerio-Martelli-Petronio census share: the four
/// neighbours, then the four permutations.

#include "gluing_table.hpp"

#include "tetrarch/format/text.hpp"

#include <string>
#include <vector>

namespace tetrarch::format {

/// Reads tetrahedra one by one and remembers where each stood, for a fault that only shows at the end.
class GluingLines {
public:
  explicit GluingLines(TextCursor& in) : in_(in) {}

  /// The neighbours and permutations of the next tetrahedron, of `tetrahedra` in all. Nothing is allocated
  /// for those still to come. Throws InputError.
  void read_one(std::int64_t tetrahedra);
  /// The triangulation of all that was read. Throws InputError, at the line of the tetrahedron at fault,
  /// where the gluings contradict each other.
  Triangulation checked() const;

private:
  TextCursor& in_;
  GluingTable table_;
  std::vector<std::array<std::string_view, 4>> perm_tokens_;
};

/// Both lines of tetrahedron t, which has no boundary face.
std::string gluing_lines_of(const Triangulation& tri, int t);

} // namespace tetrarch::format
