// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/algebra/integer_matrix.hpp"

#include "tetrarch/core/error.hpp"

#include <string>

namespace tetrarch::algebra {

SparseMatrix::SparseMatrix(int rows, int columns) : columns_(columns) {
  if (rows < 0 || columns < 0)
    throw PreconditionError("a matrix cannot have a negative number of rows or columns");
  rows_.resize(static_cast<std::size_t>(rows));
}

void SparseMatrix::add(int row, int column, const Integer& value) {
  if (row < 0 || row >= rows() || column < 0 || column >= columns_)
    throw PreconditionError("entry (" + std::to_string(row) + ", " + std::to_string(column) +
                            ") lies outside a matrix of " + std::to_string(rows()) + " rows and " +
                            std::to_string(columns_) + " columns");
  rows_[static_cast<std::size_t>(row)].push_back({column, value});
}

} // namespace tetrarch::algebra
