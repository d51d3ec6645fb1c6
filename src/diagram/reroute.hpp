// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Strands that pass over (or under) all that they cross, laid along a shorter way.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/diagram/diagram.hpp"

#include <optional>

namespace tetrarch::diagram {

/// With the first strand that has a shorter way; nothing if there is none.
std::optional<Diagram> with_shorter_strand(const Diagram& diagram, const Progress& progress);

} // namespace tetrarch::diagram
