// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// A connected cover of a space, or a transitive action of its group; how to find them is in covers.hpp.

#include <vector>

namespace tetrarch::algebra {

/// A connected cover by what the generators do with its sheets.
struct Cover {
  int degree = 1;
  std::vector<std::vector<int>> sheet; ///< sheet[g][p]: where generator g leads from p

  friend bool operator==(const Cover&, const Cover&) = default;
};

} // namespace tetrarch::algebra
