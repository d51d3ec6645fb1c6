// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The hyperbolic structure of a manifold: found, measured and described in one call.
///
///     const Structure found = structure(tri);
///     if (found.verdict() == Verdict::yes) use(found.search.structure.volume);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/hyperbolic/cusp.hpp"
#include "tetrarch/hyperbolic/orbifold_search.hpp"
#include "tetrarch/hyperbolic/search.hpp"
#include "tetrarch/reasons/reason.hpp"
#include "tetrarch/verified/structure.hpp"
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

struct StructureOptions {
  hyperbolic::Method method = hyperbolic::Method::newton;
  bool as_given = false;                               ///< solve on the given triangulation and on no other
  int attempts = hyperbolic::SearchOptions{}.attempts; ///< greatest number of triangulations to try
  std::uint64_t seed = 1;
  bool certify = false; ///< prove that the structure exists, and enclose its volume
  int digits = 0;       ///< the same with so many digits of the volume; 0: as they come
  Marks marks;          ///< edges with cone angles or parabolic meridians
};

/// A structure, or why there is none. It owns all that it speaks of.
struct Structure {
  hyperbolic::Search search; ///< the structure and the triangulation that carries it
  Skeleton skeleton;         ///< of that triangulation
  std::vector<hyperbolic::Cusp> cusps;
  std::optional<verified::Certification> certified; ///< if it was asked for
  std::string certificate;                          ///< the file that proves it; empty: there is none
  int digits = 0;                                   ///< of the volume that were asked for
  /// With marked edges, or of a closed manifold: what `search` is filled from.
  std::optional<hyperbolic::OrbifoldSearch> orbifold = {};
  /// Why there is none, where that was found: the manifold is proved not to be hyperbolic.
  std::optional<reasons::Reason> why{};
  /// Of a certified structure, in the order of `cusps`.
  std::vector<hyperbolic::CuspShape<numeric::Ball>> proved_shapes{};
  int shape_bits = 0; ///< of their arithmetic

  /// Yes, of one that was to be certified, only if it was. Undecided where tetrahedra are turned over.
  Verdict verdict() const;
};

/// Throws PreconditionError unless `tri` is a connected manifold of at least one tetrahedron; Stopped if the
/// progress says so, or for marks with a fault. Milliseconds for ten tetrahedra, seconds for a hundred. A
/// closed manifold is sought by the homotopy of orbifold.hpp up to 150 tetrahedra.
Structure structure(const Triangulation& tri, const StructureOptions& options = {},
                    const Progress& progress = {});

/// Why the manifold of a triangulation on which no structure was found is not hyperbolic; nothing if no
/// reason was found.
std::optional<reasons::Reason> proved_no(const Triangulation& tri, std::uint64_t seed,
                                         const Progress& progress = {});

/// A structure, or a reason against one that was met on the way.
struct Searched {
  hyperbolic::Search search;
  std::optional<reasons::Reason> why;
};

/// The search, which ends early where the group of the simplified triangulation tells that there can be no
/// structure: it is asked when a few triangulations carried none, for most of the time of a search in vain
/// goes by after that. Throws as `hyperbolic::find_structure`.
Searched searched(const Triangulation& tri, hyperbolic::SearchOptions options, const Progress& progress = {});

/// What is printed of it: the outcome; the volume, edges, cusps and angles, or the reason.
Rows rows_of(const Structure& found);

/// The triangulation that carries the structure with its metric, as a file keeps it. Lengths of edges that
/// run into a cusp are left out.
format::Document document_of(const Structure& found);

template <>
const FieldList<Structure>& fields_of<Structure>();

} // namespace tetrarch::workshop
