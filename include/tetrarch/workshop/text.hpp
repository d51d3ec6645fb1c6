// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Small helpers for the text side of results: "name: value" blocks and fixed decimals, the same in every
/// locale.

#include <string>
#include <utility>
#include <vector>

namespace tetrarch::workshop {

/// Lines "name   value" with the values in one column.
std::string block(const std::vector<std::pair<std::string, std::string>>& rows);

/// x with that many decimals, by std::to_chars.
std::string fixed(double x, int decimals);
/// x in scientific notation with that many decimals.
std::string scientific(double x, int decimals);

/// x with six digits, as short as that can be said.
std::string rounded(double x);

/// "4.0 GB", "12 GB", "350 MB": in the greatest unit of which there is one.
std::string in_bytes(double bytes);

/// Items joined by a separator.
std::string joined(const std::vector<std::string>& items, const std::string& separator);

/// "1 manifold", "8 manifolds", "2 tetrahedra", "3 vertices".
std::string counted(long long n, const std::string& noun);

} // namespace tetrarch::workshop
