// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/workshop/fields.hpp"

#include <algorithm>
#include <string_view>

namespace tetrarch::workshop {

std::vector<FieldNote> each_once(const std::vector<FieldNote>& notes) {
  std::vector<FieldNote> kept;
  for (const FieldNote& note : notes)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const FieldNote& k) { return std::string_view(k.name) == note.name; }))
      kept.push_back(note);
  return kept;
}

} // namespace tetrarch::workshop
