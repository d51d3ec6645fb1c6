// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// One gluing of an enumeration, and what it turned out to be.

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/catalogue/manifold.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/skeleton.hpp"
#include "tetrarch/hyperbolic/hyperbolize.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetrarch::catalogue::detail {

/// What was proved of a structure.
struct Proofs {
  int bits = 0;        ///< of the certificate; 0: the structure is not certified
  double width = 0;    ///< of the interval that holds the volume
  std::string cells;   ///< a letter for each cell: T for a tetrahedron, else R, F or B; empty: not proved
  std::string why_not; ///< what is missing; empty: nothing
};

struct Candidate {
  /// On the gluing itself; on another triangulation of the manifold; a proof that there is none; neither.
  enum class Structure { here, elsewhere, none, unknown };
  std::string signature;
  Structure structure = Structure::unknown;
  bool has_cells = false; ///< and so a record
  bool flat = false;      ///< some cell is no tetrahedron
  Proofs proofs;
  std::string reason;   ///< of a no, by its kind; or what is known where nothing is proved
  std::string evidence; ///< of a no: what was found
  Manifold manifold;    ///< without its name; where `has_cells`
};

/// Solves the gluing itself, keeping dihedral angles or not. A structure that is found is certified, its
/// cells are found and proved.
Candidate examine(const std::string& gluing, bool angles, const Progress& progress);
/// What else is tried with a gluing that carries no structure: other triangulations, and reasons why there is
/// none, which are checked at once.
Candidate settle(const std::string& gluing, bool angles, const Progress& progress);

/// Candidates as one line.
std::string unit_text(std::span<const Candidate> unit);
/// Whether a line that `unit_text` wrote has a gluing without structure and without a reason. It is not read.
bool leaves_unknown(const std::string& text);
/// Reads them back; nothing unless they are of just these gluings.
std::optional<std::vector<Candidate>> read_unit(const std::string& text,
                                                std::span<const std::string> signatures);

} // namespace tetrarch::catalogue::detail
