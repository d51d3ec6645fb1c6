// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/format/soup.hpp"

#include "tetrarch/format/text.hpp"

#include <algorithm>
#include <cmath>

namespace tetrarch::format {

void Runs::push_back(int value) {
  // Unsigned: a run may end at the greatest int.
  const bool continues =
      !runs_.empty() && static_cast<std::size_t>(static_cast<long long>(value) - runs_.back().value) ==
                            size_ - runs_.back().first;
  if (!continues) runs_.push_back({size_, value});
  ++size_;
}

int Runs::operator[](std::size_t index) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), index,
                                      [](std::size_t i, const Run& run) { return i < run.first; });
  const Run& run = *(after - 1);
  return run.value + static_cast<int>(index - run.first);
}

long long Labels::number(std::int64_t index, int first) const {
  const bool known = index >= 0 && static_cast<std::size_t>(index) < numbers.size();
  return known ? numbers[static_cast<std::size_t>(index)] : index + first;
}

int Labels::line(std::int64_t index) const {
  const bool known = index >= 0 && static_cast<std::size_t>(index) < lines.size();
  return known ? lines[static_cast<std::size_t>(index)] : 0;
}

void require_finite(const Soup& soup) {
  for (std::size_t k = 0; k < soup.points.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::isfinite(soup.points[k][axis])) continue;
      const std::string& source = soup.point_source.empty() ? soup.source : soup.point_source;
      throw InputError(Place{source, soup.point_labels.line(static_cast<std::int64_t>(k))},
                       std::string("coordinate ") + "xyz"[axis] + " of vertex " +
                           std::to_string(point_number(soup, static_cast<int>(k))) + " is " +
                           to_text(soup.points[k][axis]) + ", expected a finite number");
    }
}

} // namespace tetrarch::format
