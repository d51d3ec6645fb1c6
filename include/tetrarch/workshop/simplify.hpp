// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Fewer tetrahedra, the same manifold: what came out, and what it took.
///
///     const Simplification found = simplify(tri);
///     use(found.triangulation);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/triangulation.hpp"
#include "tetrarch/moves/simplify.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/info.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tetrarch::workshop {

/// What every conversion by moves takes.
struct MoveOptions {
  std::string name; ///< of the result
  std::uint64_t seed = 1;
  bool keep_log = false; ///< keep all moves
  bool audit = false;    ///< compare with what is computed from nothing, after every 1,000th move; slow
};

struct SimplifyOptions : MoveOptions {
  bool keep_boundary = false; ///< leave the triangles of the real boundary as they are
};

/// A triangulation that moves made of another one. It owns all that it speaks of.
struct Simplification {
  Triangulation triangulation = Triangulation();
  Info info; ///< of the triangulation
  int input_tetrahedra = 0;
  double seconds = 0; ///< of the moves alone
  moves::MoveLog log; ///< if it was asked for
};

/// Throws PreconditionError if `tri` is no manifold with ideal vertices, or if the audit finds a fault;
/// Stopped if the progress says so. Near-linear, but for the signature and the group of the result.
Simplification simplify(const Triangulation& tri, const SimplifyOptions& options = {},
                        const Progress& progress = {});

/// `signature` as of an Info.
Rows rows_of(const Simplification& found, const std::string& signature);

/// What a simplification has besides the fields of its `info`.
template <>
const FieldList<Simplification>& fields_of<Simplification>();
/// The fields of `info`, and these.
template <>
Tree tree_of<Simplification>(const Simplification& found);
template <>
std::vector<FieldNote> notes_of<Simplification>();

} // namespace tetrarch::workshop
