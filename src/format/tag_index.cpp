// SPDX-License-Identifier: GPL-2.0-or-later
#include "tag_index.hpp"

#include <algorithm>

namespace tetrarch::format {

TagIndex::TagIndex(const Runs& numbers) {
  const auto& runs = numbers.runs();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t end = r + 1 < runs.size() ? runs[r + 1].first : numbers.size();
    const long long length = static_cast<long long>(end - runs[r].first);
    runs_.push_back({runs[r].value, runs[r].value + length - 1, runs[r].first});
  }
  std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.value < b.value; });
  for (std::size_t r = 1; r < runs_.size() && !repeated_; ++r)
    if (runs_[r].value <= runs_[r - 1].last) repeated_ = runs_[r].value;
}

std::optional<int> TagIndex::find(long long number) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), number,
                                      [](long long n, const Run& run) { return n < run.value; });
  if (after == runs_.begin()) return std::nullopt;
  const Run& run = *(after - 1);
  if (number > run.last) return std::nullopt;
  return static_cast<int>(run.first) + static_cast<int>(number - run.value);
}

} // namespace tetrarch::format
