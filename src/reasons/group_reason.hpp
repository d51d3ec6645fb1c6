// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Reasons that are seen in a presentation of the group.

#include "tetrarch/reasons/reason.hpp"

#include <optional>

namespace tetrarch::reasons {

/// What the group must be like besides, for `relations` to apply.
struct Setting {
  bool orientable = true;
  bool has_cusps = false;
};

/// From the presentation as it is read off a triangulation and simplified.
std::optional<Reason> reason_of_group(const algebra::Presentation& group, const Setting& setting,
                                      const ReasonOptions& options, const Progress& progress);

} // namespace tetrarch::reasons
