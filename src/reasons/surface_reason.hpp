// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Reasons that a normal surface is.

#include "tetrarch/reasons/normal_surface.hpp"
#include "tetrarch/reasons/reason.hpp"

#include <optional>

namespace tetrarch::reasons {

/// What one connected normal surface of an orientable manifold proves.
std::optional<Reason> reason_of_surface(const Triangulation& tri, const Coordinates& coordinates,
                                        const ReasonOptions& options, const Progress& progress);

/// The first vertex surface that proves something.
std::optional<Reason> reason_of_surfaces(const Triangulation& given, const ReasonOptions& options,
                                         const Progress& progress);

} // namespace tetrarch::reasons
