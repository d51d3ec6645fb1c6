// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is said of a reason why a manifold is not hyperbolic.

#include "tetrarch/reasons/reason.hpp"
#include "tetrarch/workshop/fields.hpp"

namespace tetrarch::workshop {

/// All that it holds, for programs: kind, text, theorem, and the evidence in the presentation or the normal
/// surface.
Tree tree_of(const reasons::Reason& reason);
/// Of that tree.
Type reason_type();

/// The sentences, and the presentation or the surface in which it is seen.
Rows rows_of(const reasons::Reason& reason);

} // namespace tetrarch::workshop
