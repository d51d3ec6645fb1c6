// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

/// Sparse Cholesky factorization, A = L L': CHOLMOD's where the library was built with it, else Eigen's.
///
/// The order of elimination is the library's: approximate minimum degree. The pattern is analyzed once;
/// matrices that share it are factored one after the other, in the same memory. With either library the
/// results depend on the matrix alone: CHOLMOD and OpenBLAS use one thread, because more threads could change
/// the order of sums. The two libraries agree up to rounding.

#include <memory>
#include <stdexcept>
#include <vector>

namespace tetrarch::numeric {

/// A matrix has more entries than CHOLMOD can count.
struct MatrixTooLarge : std::length_error {
  MatrixTooLarge() : std::length_error("the mesh is too large to be factored") {}
};

/// The lower triangle of a symmetric matrix by columns: entries first[j] .. first[j+1]-1 are in column j, in
/// increasing rows, the one on the diagonal, which must be there, first.
struct SymmetricMatrix {
  std::vector<int> first;
  std::vector<int> row;
  std::vector<double> value;

  int size() const { return static_cast<int>(first.size()) - 1; }
};

/// The Cholesky factorization of a sparse symmetric matrix.
class SparseCholesky {
public:
  /// Analyzes the pattern, whatever the values. Throws MatrixTooLarge.
  explicit SparseCholesky(const SymmetricMatrix& pattern);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// False if the matrix, which must have the pattern, is not positive definite.
  [[nodiscard]] bool factor(const SymmetricMatrix& matrix);

  /// x with A x = b, for any number of columns, one after the other in memory. `x` has the size of b.
  void solve(std::vector<double>& b, std::vector<double>& x) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace tetrarch::numeric
