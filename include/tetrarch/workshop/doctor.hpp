// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// What is mended in a mesh before anything is done with it.

#include "tetrarch/format/soup.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tetrarch::workshop {

struct Doctor {
  std::optional<double> weld;   ///< a tolerance
  std::optional<int> component; ///< counted from 0
  bool repair = false;
  bool split_pinches = false; ///< of a surface (doctor/repair.hpp)
};

/// Welds, chooses the component and repairs, in this order, as far as asked for; returns a sentence for each
/// thing that was done. Throws InputError if there is no such component. O(n log n).
std::vector<std::string> mend(format::Soup& soup, const Doctor& doctor);

} // namespace tetrarch::workshop
