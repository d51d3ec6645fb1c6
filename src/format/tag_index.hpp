// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// From the number that a file calls a point by, back to its index.

#include "tetrarch/format/soup.hpp"

#include <optional>
#include <vector>

namespace tetrarch::format {

class TagIndex {
public:
  /// O(r log r) for r runs.
  explicit TagIndex(const Runs& numbers);
  /// The index of the point of this number; none if there is none. O(log r).
  std::optional<int> find(long long number) const;
  /// A number that two points have; none if they all differ.
  std::optional<long long> repeated() const { return repeated_; }

private:
  struct Run {
    long long value;
    long long last;
    std::size_t first;
  };
  std::vector<Run> runs_;
  std::optional<long long> repeated_;
};

} // namespace tetrarch::format
