// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The proof that the canonical decomposition is what `canonize` says: the structure is certified on the
/// triangulation that subdivides the cells (verified/structure.hpp), then the cells from its balls
/// (canonical/certify.hpp), with more bits where few leave a tilt in doubt.

#include "tetrarch/canonical/canonize.hpp"
#include "tetrarch/core/progress.hpp"

namespace tetrarch::catalogue {

/// Fills in `c.proof`: certified, or why not. `c.outcome` must be canonical. About a millisecond for five
/// tetrahedra; more where cells are flat.
void prove_cells(canonical::Canonical& c, const Progress& progress = {});

} // namespace tetrarch::catalogue
