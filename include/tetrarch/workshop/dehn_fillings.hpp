// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The manifold that a text with Dehn fillings stands for: the filled one.

#include "tetrarch/core/progress.hpp"
#include "tetrarch/format/document.hpp"

#include <string>
#include <string_view>

namespace tetrarch::workshop {

/// `document` was read from `text`. If that is a SnapPea file, its fillings along curves are carried out, and
/// a warning says so. Others stay in the ledger of what was passed over. Throws InputError where a filling
/// cannot be carried out: a Klein bottle cusp, a slope too long. Near-linear.
format::Document with_fillings(format::Document document, std::string_view text, const std::string& source,
                               const Progress& progress = {});

/// Throws InputError if a filling was passed over: the answer would be one about another manifold.
void require_filled(const format::Document& document, const std::string& source);

} // namespace tetrarch::workshop
