// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Several triangulations in a text, whatever its format: also a list of names, one a line.
///
///     m004
///     4_1     the same manifold
///     cPcbbbihq

#include "tetrarch/format/collection.hpp"

#include <string>
#include <string_view>

namespace tetrarch::workshop {

/// `format::read_all`, where a name that `identify` knows may stand in place of a signature; what stands
/// after it on its line is ignored as of a signature. Throws InputError as that does.
format::Collection collection_in(std::string_view text, const std::string& source);

} // namespace tetrarch::workshop
