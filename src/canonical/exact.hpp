// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Flat cells by exact algebra (certify.hpp, E).

#include "tetrarch/canonical/certify.hpp"
#include "tetrarch/canonical/decorated.hpp"

#include <functional>
#include <optional>
#include <string>

namespace tetrarch::canonical {

/// The polynomial of the field in which all faces marked `flat` are proved to be so; nothing where no field
/// is seen, where there are cusps beside geodesic boundary, or where the proof fails. `still_wanted` is
/// called now and then, and may throw to end the search.
std::optional<std::string> prove_flat_exactly(const Triangulation& tri, const Skeleton& skeleton,
                                              const FlatFaces& flat, const PreciseSolver& solver,
                                              const std::function<void()>& still_wanted = {});

} // namespace tetrarch::canonical
