// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The conformal type of a sphere with holes: numbers that no conformal map changes, and how far they are
/// from another's.
///
///     ConformalType own = conformal_type(opened(surface_of(open_mesh("ring.off"))));
///     own.comparison = comparison(own, conformal_type(other));
///     use(own.comparison->distance);

#include "tetrarch/core/progress.hpp"
#include "tetrarch/slit/fingerprint.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/openings.hpp"
#include "tetrarch/workshop/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

struct FingerprintOptions {
  std::string name = "surface"; ///< what errors call it
  /// The loops that become the outer and the inner circle; nothing: those of greatest modulus.
  std::optional<slit::LoopPair> circles;
  int most_triangles = 500'000; ///< of the finer triangulations
};

/// A surface and its fingerprint, compared with another's or not. It owns all that it speaks of.
struct ConformalType {
  HoledSurface surface;
  slit::Fingerprint fingerprint;

  /// By the best matching of the loops.
  struct Comparison {
    double distance = 0;
    std::vector<int> matching; ///< of each loop, the loop of the other surface
    bool mirrored = false;     ///< the other surface
    /// By the next best matching; nothing: there is no other.
    std::optional<double> second_distance;
    bool other_found = true; ///< whether the circular domains of the other surface were
  };
  std::optional<Comparison> comparison;

  /// Undecided where a circular domain was not found.
  Verdict verdict() const;
};

/// Throws InputError unless the surface is a sphere with two holes at least; Stopped if the progress says so.
/// Some maps, of up to as many triangles as are allowed: three seconds for half a million.
ConformalType conformal_type(HoledSurface surface, const FingerprintOptions& options = {},
                             const Progress& progress = {});

/// The least distance over all matchings of the loops. `with_mirror`: the mirror image of the other surface
/// counts, too. Throws InputError unless both have equally many loops. Cost as of `slit::best_matchings`.
ConformalType::Comparison comparison(const ConformalType& own, const ConformalType& other,
                                     bool with_mirror = false);

Rows rows_of(const ConformalType& found);

template <>
const FieldList<ConformalType>& fields_of<ConformalType>();

/// The fields of a map and those of a conformal type, each once.
std::vector<FieldNote> notes_of_maps_and_types();

} // namespace tetrarch::workshop
