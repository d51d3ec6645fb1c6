// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The circle bundle over a surface: planned, glued, proved and described in one call.
///
///     const SurfaceBundle found = circle_bundle(surface_of(open_mesh("torus.off")));
///     if (found.verdict() == Verdict::yes) use(found.made->bundle.total);

#include "tetrarch/bundle/plan.hpp"
#include "tetrarch/bundle/proof.hpp"
#include "tetrarch/core/progress.hpp"
#include "tetrarch/core/surface.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/info.hpp"
#include "tetrarch/workshop/surface.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tetrarch::format {
struct Document;
}

namespace tetrarch::workshop {

struct BundleOptions {
  bundle::PlanOptions plan;
  /// A constant vector to be projected to the surface; nothing: a direction at random at each vertex.
  std::optional<std::array<double, 3>> field;
  std::uint64_t seed = 1;
  double most_bytes = std::numeric_limits<double>::infinity(); ///< that the work may take
  double bytes_a_tetrahedron = 0; ///< that come on top, of what is made of the bundle afterwards
};

/// The bundle, or why there is none. It owns all that it speaks of.
struct SurfaceBundle {
  SurfaceType surface; ///< what was given
  int triangles = 0;   ///< of it
  bool field_given = false;

  /// What was made; a proof without failure belongs to it.
  struct Made {
    bundle::Plan plan;
    bundle::CircleBundle bundle;
    bundle::Proof proof;
    Info info;                ///< of the total space; brief beyond 2,000 tetrahedra
    std::vector<int> field;   ///< of each triangle, the index of a field of directions on the surface
    std::vector<int> section; ///< and that of a section of the bundle at random
  };
  std::optional<Made> made;

  /// A part of a surface with boundary on which the boundary values allow no pattern.
  struct Obstructed {
    int forbidding = 0;               ///< the value, +1 or -1, that all its boundary edges have
    std::vector<long long> triangles; ///< by their numbers in the file
    format::Soup mesh;                ///< these triangles
  };
  std::optional<Obstructed> obstruction;

  /// Bytes that the work would take, where these are more than was allowed.
  std::optional<double> bytes_needed;

  /// A proved no if there is an obstruction; undecided where memory does not suffice.
  Verdict verdict() const;
};

/// Throws PreconditionError if the surface is not connected or the options do not fit it (see
/// bundle/plan.hpp); Stopped if the progress says so. Near-linear in the tetrahedra, of which there are
/// 3 * fiber to a triangle of the refined surface, but for the group and the signature of a small one.
SurfaceBundle circle_bundle(const NumberedSurface& surface, const BundleOptions& options = {},
                            const Progress& progress = {});

/// The surface, the cut, the fibers, then `info` without a long signature. Throws PreconditionError unless
/// the bundle was made.
Rows rows_of(const SurfaceBundle& found);
/// The same as text, or the sentence that says why there is none.
std::string text_of(const SurfaceBundle& found);

/// The total space with its projection, as a file keeps it. Throws PreconditionError unless it was made.
format::Document document_of(const SurfaceBundle& found);

/// What a bundle has besides the fields of its `info`.
template <>
const FieldList<SurfaceBundle>& fields_of<SurfaceBundle>();
/// The fields of `info`, and these.
template <>
Tree tree_of<SurfaceBundle>(const SurfaceBundle& found);
template <>
std::vector<FieldNote> notes_of<SurfaceBundle>();

} // namespace tetrarch::workshop
