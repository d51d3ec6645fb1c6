// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What the checker says of a certificate, for people and programs.

#include "tetrarch/checker/check.hpp"
#include "tetrarch/workshop/fields.hpp"

namespace tetrarch::workshop {

Rows rows_of(const checker::Report& report);

template <>
const FieldList<checker::Report>& fields_of<checker::Report>();

} // namespace tetrarch::workshop
