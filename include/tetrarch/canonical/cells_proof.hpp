// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is known of the proof that cells are the canonical ones; certify.hpp makes it.

#include <string>
#include <vector>

namespace tetrarch::canonical {

/// Which argument proved a cell.
enum class Criterion {
  tetrahedron, ///< nothing to prove
  orbits,      ///< R
  one_line,    ///< F
  blocks,      ///< B
  exact,       ///< E
  relations,   ///< L
};
/// "tetrahedron", "R", "F", "B", "E", "L".
const char* to_string(Criterion criterion);

/// Whether cells were proved, and how.
struct CellsProof {
  bool certified = false;
  std::string why_not;             ///< what is in doubt; empty if nothing is
  std::vector<Criterion> criteria; ///< of each cell, by its first tetrahedron; of those proved
  std::string field;               ///< of E, the polynomial whose root gives all inner products; else empty
  int bits = 0;                    ///< of the certified lengths that it rests on
  double least_tilt = 0; ///< of the faces between cells, which is certainly positive; its nearest double
};

} // namespace tetrarch::canonical
