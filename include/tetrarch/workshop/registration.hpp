// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Two surfaces with equally many holes, point by point: the second one's shape with the triangles of the
/// first, and the shape halfway between.
///
///     const SurfaceRegistration found = registration(opened(first), opened(second));
///     if (found.verdict() == Verdict::yes) use(found.points.resampled);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/slit/registration.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/openings.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tetrarch::format {
struct MeshDocument;
}

namespace tetrarch::workshop {

struct RegisterOptions {
  std::array<std::string, 2> names{"the first surface", "the second surface"}; ///< what errors call them
  /// The loops of the first surface that become the outer and the inner circle; nothing: those of greatest
  /// modulus.
  std::optional<slit::LoopPair> circles;
  /// Of each loop of the first surface the loop of the second; nothing: searched for.
  std::optional<std::vector<int>> matching;
  bool unflip = false;    ///< move vertices in the disks until no triangle is inverted
  bool as_placed = false; ///< compare and average without moving the second surface to the first
};

/// What corresponds to what. It owns all that it speaks of.
struct SurfaceRegistration {
  HoledSurface first;
  slit::Registration points;
  std::vector<int> matching; ///< of each loop of the first surface, the loop of the second

  /// How the matching was found: by the circles of both, and where these do not decide, by the maps.
  struct Search {
    double distance = 0;                 ///< of the circles
    std::size_t tried = 0;               ///< matchings that fit the circles as well
    std::optional<double> next_distance; ///< by the best matching that fits worse; nothing: there is none
  };
  std::optional<Search> search;
  int unround_disks = 0; ///< disks whose circles did not become round within the budget

  /// Undecided where a circular domain was not found.
  Verdict verdict() const;
  /// What is remarkable in the result, a sentence each.
  std::vector<std::string> remarks() const;
};

/// Of matchings between which circles do not decide the most conformal one is taken, of equal ones that by
/// which the surfaces come closest in space. Throws InputError unless both are spheres with equally many
/// holes, two at least, and a matching given is one to one; Stopped if the progress says so. A circular map
/// of either surface, and one more of the second for each matching tried.
SurfaceRegistration registration(HoledSurface first, const HoledSurface& second,
                                 const RegisterOptions& options = {}, const Progress& progress = {});

Rows rows_of(const SurfaceRegistration& found);

/// The shape that `points` of the first surface's triangles have, such as `found.points.resampled`, with the
/// places of its vertices in the second surface's disk and on the first surface. O(n).
format::MeshDocument document_of(const SurfaceRegistration& found,
                                 const std::vector<std::array<double, 3>>& points);

template <>
const FieldList<SurfaceRegistration>& fields_of<SurfaceRegistration>();

} // namespace tetrarch::workshop
