// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What a search for a manifold's name found.

#include "tetrarch/identify/identify.hpp"
#include "tetrarch/workshop/fields.hpp"
#include "tetrarch/workshop/verdict.hpp"

namespace tetrarch::workshop {

/// Undecided where no name was found: the tables do not hold every manifold.
Verdict verdict_of(const identify::Identification& found);

Rows rows_of(const identify::Identification& found);

template <>
const FieldList<identify::Identification>& fields_of<identify::Identification>();

} // namespace tetrarch::workshop
