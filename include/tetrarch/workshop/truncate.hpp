// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The mesh of a solid as a few truncated tetrahedra: what came out, and what became of the boundary.
///
///     const Truncation found = truncate(open_triangulation("solid.mesh").triangulation);
///     use(found.triangulation);

#include "tetrarch/moves/truncate.hpp"
#include "tetrarch/workshop/simplify.hpp"

#include <string>
#include <vector>

namespace tetrarch::workshop {

struct TruncateOptions : MoveOptions {
  bool keep_spheres = false; ///< truncate boundary spheres instead of filling them in
};

/// The truncated tetrahedra, and how they were made.
struct Truncation : Simplification {
  std::vector<moves::BoundaryImage> boundary; ///< by component of the input
  std::vector<moves::TruncateStep> steps;
  int finite_vertices = 0;

  /// What is remarkable in the result, a sentence each.
  std::vector<std::string> remarks() const;
};

/// Throws as `simplify`. Near-linear: about 2 microseconds a tetrahedron, but for the signature and the
/// group of the result.
Truncation truncate(const Triangulation& tri, const TruncateOptions& options = {},
                    const Progress& progress = {});

/// Steps and boundary, then `info`; `signature` as of an Info.
Rows rows_of(const Truncation& found, const std::string& signature);

/// What a truncation has besides the fields of its `info`.
template <>
const FieldList<Truncation>& fields_of<Truncation>();
/// The fields of `info`, and these.
template <>
Tree tree_of<Truncation>(const Truncation& found);
template <>
std::vector<FieldNote> notes_of<Truncation>();

} // namespace tetrarch::workshop
