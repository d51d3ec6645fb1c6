// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Canonical cells and isometries, from any triangulation: the structure is found, the cells are made, and
/// the answer says what was done on the way.

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/reasons/reason.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {
struct Document;
}

namespace tetrarch::workshop {

struct CanonicalOptions {
  int attempts = hyperbolic::SearchOptions{}.attempts; ///< greatest number of triangulations to try
  std::uint64_t seed = 1;
  bool list_isometries = false; ///< keep all isometries
  bool certify = false;         ///< write the certificate of the structure with its cells
  Marks marks{};                ///< of `cells`: the edges with orders, which are edges of cells then
};

/// The cells of a manifold, or the sentence that says why there are none.
struct Cells {
  std::optional<canonical::Canonical> canonical;
  std::string why_not;                                        ///< empty if the cells were found
  hyperbolic::Outcome outcome = hyperbolic::Outcome::invalid; ///< of the search for a structure
  double volume = 0;
  int filled_spheres = 0; ///< boundary spheres that were filled with balls: the cells are of that manifold
  std::size_t isometry_group_order = 0;
  std::string isometry_group;           ///< its name; empty: it has none of those known
  std::optional<bool> amphichiral;      ///< an isometry reverses orientation; nothing: there is none
  std::vector<Isomorphism> isometries;  ///< of the canonical triangulation, if they were asked for
  std::optional<reasons::Reason> why{}; ///< the manifold is proved not to be hyperbolic
  /// The file that proves the structure on the canonical triangulation and its cells; empty unless it was
  /// asked for, and these are proved.
  std::string certificate{};

  Verdict verdict() const;
};

/// Throws PreconditionError unless `tri` is a connected manifold of at least one tetrahedron; Stopped if the
/// progress says so. Milliseconds for ten tetrahedra.
/// The cells are proved where that succeeds. With marks they are those of the structure whose meridians are
/// parabolic, colored by the orders (canonical: marked_canonize.hpp), and not proved.
Cells cells(const Triangulation& tri, const CanonicalOptions& options = {}, const Progress& progress = {});

Rows rows_of(const Cells& found);
/// The cells as a file keeps them. Throws PreconditionError if they were not found.
format::Document document_of(const Cells& found);

/// What is to be compared, and what the answer calls it.
struct Compared {
  const Triangulation& tri;
  std::string name;
  Marks marks = {};
};

/// Whether two manifolds are isometric, with the isometry or the reason.
struct Isometry {
  canonical::IsometryAnswer answer;
  const char* between =
      "canonical triangulations"; ///< or "triangulations given", "simplified triangulations"
  std::string from;               ///< signature of the first of these
  int filled_spheres = 0;         ///< in each manifold
  std::string x, y;               ///< the names

  Verdict verdict() const;
};

/// Both as for `cells`. Boundaries (spheres count) and first homology are compared first, then the
/// triangulations themselves, then certified volumes, then canonical cells, then the homology of covers.
/// Where only one carries a structure, a reason why the other has none decides.
///
/// With marks the question is whether a homeomorphism takes marked edges to marked edges of the same orders;
/// where these are whole numbers and both are hyperbolic, that is an isometry of orbifolds. A yes is an
/// isomorphism of marked triangulations that moves reach which keep marks. A no is that the orders differ, or
/// how they meet at vertices; the first homology of the orbifold's group or of its covers; or that the
/// exteriors of the marked edges are not homeomorphic, by the above.
Isometry isometry(const Compared& x, const Compared& y, const CanonicalOptions& options = {},
                  const Progress& progress = {});

/// A proved no of the boundaries or of first homology; nothing where these agree.
std::optional<canonical::IsometryAnswer> differ_without_structure(const Triangulation& x,
                                                                  const Triangulation& y);

/// Some lines for people.
std::string text_of(const Isometry& found);

template <>
const FieldList<Cells>& fields_of<Cells>();
template <>
const FieldList<Isometry>& fields_of<Isometry>();

} // namespace tetrarch::workshop
