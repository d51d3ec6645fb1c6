// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// The texts of census/fmp*.json, census/cusped.txt and census/graphs.json, compiled into the library by
/// embed.cmake so that an installed program has them.

#include <string_view>
#include <vector>

namespace tetrarch::catalogue::detail {

const std::vector<std::string_view>& embedded_tables();
std::string_view embedded_cusped();
std::string_view embedded_graphs();

} // namespace tetrarch::catalogue::detail
