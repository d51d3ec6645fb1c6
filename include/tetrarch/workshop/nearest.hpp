// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetrarch::workshop {

/// Of the candidates, the one that `word` most likely was meant to be; empty if none is near.
/// O(length of the word times that of all candidates).
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// " (near names: 'm003', 'm004')": up to three, the nearest first; or nothing. The beginning of a name is
/// near to it. The same cost.
std::string near_names(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'info'?)", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace tetrarch::workshop
