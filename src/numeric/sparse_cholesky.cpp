// SPDX-License-Identifier: GPL-2.0-or-later
#include "tetrarch/numeric/sparse_cholesky.hpp"

#ifdef TETRARCH_HAS_CHOLMOD
#include <cholmod.h>
#include <new>
#else
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#endif

#ifdef TETRARCH_HAS_OPENMP
#include <omp.h>
#endif

#ifdef TETRARCH_HAS_OPENBLAS
extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int threads);
}
#endif

namespace tetrarch::numeric {

#ifdef TETRARCH_HAS_CHOLMOD

namespace {

#ifndef TETRARCH_HAS_OPENBLAS
int openblas_get_num_threads() {
  return 1;
}
void openblas_set_num_threads(int) {}
#endif
#ifndef TETRARCH_HAS_OPENMP
int omp_get_max_active_levels() {
  return 0;
}
void omp_set_max_active_levels(int) {}
#endif

/// While it lives, OpenBLAS and CHOLMOD work in one thread. On meshes that saves time: their fronts are
/// small.
class OneThread {
public:
  OneThread() : blas_threads_(openblas_get_num_threads()), omp_levels_(omp_get_max_active_levels()) {
    openblas_set_num_threads(1);
    // CHOLMOD 3 asks for four threads by itself, whatever omp_set_num_threads says; but not at level 0.
    omp_set_max_active_levels(0);
  }
  ~OneThread() {
    openblas_set_num_threads(blas_threads_);
    omp_set_max_active_levels(omp_levels_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

private:
  int blas_threads_;
  int omp_levels_;
};

/// CHOLMOD's settings, workspace and status.
class Common {
public:
  Common() {
    cholmod_start(&common_);
    common_.print = 0;
    // METIS, which would be tried next on large meshes, costs more time than its better order saves.
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    common_.postorder = 1;
    // Small matrices are not factored by blocks; LDL' would then let indefinite ones pass.
    common_.final_ll = 1;
  }
  ~Common() { cholmod_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  cholmod_common* get() { return &common_; }

  void check() const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (common_.status == CHOLMOD_TOO_LARGE) throw MatrixTooLarge();
  }

private:
  cholmod_common common_{};
};

/// CHOLMOD reads it only.
cholmod_sparse view(const SymmetricMatrix& matrix) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size());
  view.nzmax = matrix.row.size();
  view.p = const_cast<int*>(matrix.first.data());    // NOLINT(cppcoreguidelines-pro-type-const-cast)
  view.i = const_cast<int*>(matrix.row.data());      // NOLINT(cppcoreguidelines-pro-type-const-cast)
  view.x = const_cast<double*>(matrix.value.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast)
  view.stype = -1;                                   // the lower triangle
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense view(std::vector<double>& columns, std::size_t rows) {
  cholmod_dense view{};
  view.nrow = view.d = rows;
  view.ncol = columns.size() / rows;
  view.nzmax = columns.size();
  view.x = columns.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

} // namespace

struct SparseCholesky::Implementation {
  Common common;
  cholmod_factor* factor = nullptr;

  explicit Implementation(const SymmetricMatrix& pattern) {
    cholmod_sparse matrix = view(pattern);
    factor = cholmod_analyze(&matrix, common.get());
    common.check();
  }
  ~Implementation() { cholmod_free_factor(&factor, common.get()); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  bool compute(const SymmetricMatrix& values) {
    const OneThread one_thread;
    cholmod_sparse matrix = view(values);
    cholmod_factorize(&matrix, factor, common.get());
    common.check();
    return common.get()->status == CHOLMOD_OK && factor->minor == factor->n;
  }

  void solve(std::vector<double>& b, std::vector<double>& x) const {
    const OneThread one_thread;
    Common own; // so that several threads may solve at the same time
    cholmod_dense right = view(b, factor->n);
    cholmod_dense left = view(x, factor->n);
    cholmod_dense* solution = &left; // it has the right size, so CHOLMOD writes there
    cholmod_dense* y = nullptr;
    cholmod_dense* e = nullptr;
    cholmod_solve2(CHOLMOD_A, factor, &right, nullptr, &solution, nullptr, &y, &e, own.get());
    cholmod_free_dense(&y, own.get());
    cholmod_free_dense(&e, own.get());
    own.check();
  }
};

#else

struct SparseCholesky::Implementation {
  using Matrix = Eigen::SparseMatrix<double>;
  using View = Eigen::Map<const Matrix>;
  Eigen::SimplicialLDLT<Matrix> solver;

  static View view(const SymmetricMatrix& matrix) {
    return {matrix.size(),       matrix.size(),     static_cast<Eigen::Index>(matrix.row.size()),
            matrix.first.data(), matrix.row.data(), matrix.value.data()};
  }

  explicit Implementation(const SymmetricMatrix& pattern) { solver.analyzePattern(view(pattern)); }

  bool compute(const SymmetricMatrix& values) {
    solver.factorize(view(values));
    return solver.info() == Eigen::Success && solver.vectorD().minCoeff() > 0;
  }

  void solve(std::vector<double>& b, std::vector<double>& x) const {
    const Eigen::Index rows = solver.rows();
    const auto columns = static_cast<Eigen::Index>(b.size()) / rows;
    Eigen::Map<Eigen::MatrixXd>(x.data(), rows, columns) =
        solver.solve(Eigen::Map<const Eigen::MatrixXd>(b.data(), rows, columns));
  }
};

#endif

SparseCholesky::SparseCholesky(const SymmetricMatrix& pattern)
    : implementation_(std::make_unique<Implementation>(pattern)) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factor(const SymmetricMatrix& matrix) {
  return implementation_->compute(matrix);
}

void SparseCholesky::solve(std::vector<double>& b, std::vector<double>& x) const {
  implementation_->solve(b, x);
}

} // namespace tetrarch::numeric
