// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Sparse matrices of integers of any size.
///
/// Entries are collected row by row; entries given twice for the same place add up, so a boundary map can be
/// written down one incidence at a time. There is no arithmetic here: the matrix is the input of Smith's
/// normal form.

#include <boost/multiprecision/gmp.hpp>

#include <vector>

namespace tetrarch::algebra {

using Integer = boost::multiprecision::mpz_int;

/// A matrix of integers of any size, of which the entries other than 0 are kept.
class SparseMatrix {
public:
  struct Entry {
    int column;
    Integer value;
  };

  SparseMatrix(int rows, int columns);

  int rows() const { return static_cast<int>(rows_.size()); }
  int columns() const { return columns_; }

  /// Adds `value` to the entry at (row, column). Throws PreconditionError if the place lies outside. O(1)
  /// amortised.
  void add(int row, int column, const Integer& value);
  /// The entries of a row as they were added: in any order, a column possibly more than once.
  const std::vector<Entry>& row(int row) const { return rows_[static_cast<std::size_t>(row)]; }

private:
  std::vector<std::vector<Entry>> rows_;
  int columns_;
};

} // namespace tetrarch::algebra
