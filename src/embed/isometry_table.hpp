// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Which of many isometries is this one?
///
/// A cell is six directions: where M takes the base point and where it takes it back from, each coordinate in
/// units of its distance, cut into 1024ths. Rounding splits equals where a coordinate lies close to a cell's
/// border; then both cells are searched. The grid is shifted, as coordinates that are exactly 0 are common.

#include "tetrarch/embed/lorentz.hpp"

#include <cstdint>
#include <vector>

namespace tetrarch::embed {

/// Isometries that differ by less, relatively, are the same: words of a few hundred letters are good to
/// 1e-12, distinct elements of a discrete group differ by about their smallest displacement.
inline constexpr double same_isometry = 1e-6;

class IsometryTable {
public:
  /// Looks into `isometries`, which grows outside and outlives the table.
  explicit IsometryTable(const std::vector<Matrix4<double>>& isometries);

  /// The index of m, or -1.
  int find(const Matrix4<double>& m);
  /// Enters the last isometry of the list.
  void add_last();

  double largest_duplicate() const { return largest_duplicate_; }
  double closest() const { return closest_; }

private:
  std::uint64_t slot(const std::array<int, 6>& cell) const;
  int find_in(const std::array<int, 6>& cell, const Matrix4<double>& m);
  void enter(int index);

  const std::vector<Matrix4<double>>* isometries_;
  std::vector<int> slots_; ///< open addressing, at most half full; -1: free
  double largest_duplicate_ = 0;
  double closest_ = 2;
};

} // namespace tetrarch::embed
