// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_solver.hpp"

#include <cholmod.h>
#include <umfpack.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/errors.hpp"

namespace tether {
namespace {

[[noreturn]] void out_of_memory(const SparseMatrix& A) {
  throw RunError("the memory does not hold the factors of a matrix of " + std::to_string(A.n) + " unknowns");
}

class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), from_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - from_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point from_;
};

/// The libraries want pointers to what they only read.
SuiteSparse_long* as_long(const std::vector<std::int64_t>& indices) {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  return reinterpret_cast<SuiteSparse_long*>(const_cast<std::int64_t*>(indices.data()));
}

/// Cholesky factors by CHOLMOD.
class Cholesky {
 public:
  Cholesky() {
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_AUTO;
    common_.quick_return_if_not_posdef = 1;
    common_.final_ll = 1;  // L L^T, which says where a matrix is not positive, for small ones, too
  }
  ~Cholesky() {
    forget();
    cholmod_l_finish(&common_);
  }
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;

  void forget() {
    if (factor_) cholmod_l_free_factor(&factor_, &common_);
  }
  /// False where A is not positive definite.
  bool factorise(const SparseMatrix& A, double& analysis_seconds) {
    cholmod_sparse matrix = view(A);
    if (!factor_) {
      const Stopwatch watch(analysis_seconds);
      factor_ = cholmod_l_analyze(&matrix, &common_);
    }
    if (!factor_ || (!cholmod_l_factorize(&matrix, factor_, &common_) && common_.status < CHOLMOD_OK)) out_of_memory(A);
    return common_.status == CHOLMOD_OK;
  }
  void solve(std::span<const double> b, std::span<double> x) {
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = b.size(), right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL, right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_l_solve(CHOLMOD_A, factor_, &right, &common_);
    if (!solution) throw RunError("the memory does not hold a solution of " + std::to_string(b.size()) + " unknowns");
    std::copy_n(static_cast<const double*>(solution->x), x.size(), x.begin());
    cholmod_l_free_dense(&solution, &common_);
  }
  double nonzeros() const { return common_.lnz; }

 private:
  static cholmod_sparse view(const SparseMatrix& A) {
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(A.n), matrix.nzmax = A.row.size();
    matrix.p = as_long(A.start), matrix.i = as_long(A.row), matrix.x = const_cast<double*>(A.value.data());
    matrix.stype = -1, matrix.itype = CHOLMOD_LONG, matrix.xtype = CHOLMOD_REAL, matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    return matrix;
  }
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

/// LU factors by UMFPACK.
class Lu {
 public:
  Lu() { umfpack_dl_defaults(control_); }
  ~Lu() { forget(); }
  Lu(const Lu&) = delete;
  Lu& operator=(const Lu&) = delete;

  void forget() {
    umfpack_dl_free_numeric(&numeric_);
    umfpack_dl_free_symbolic(&symbolic_);
  }
  /// False where A is singular. Of A the solver keeps what its last refinement needs.
  bool factorise(const SparseMatrix& A, double& analysis_seconds) {
    const auto n = static_cast<SuiteSparse_long>(A.n);
    if (!symbolic_) {
      const Stopwatch watch(analysis_seconds);
      if (umfpack_dl_symbolic(n, n, as_long(A.start), as_long(A.row), A.value.data(), &symbolic_, control_, info_) < 0)
        out_of_memory(A);
    }
    umfpack_dl_free_numeric(&numeric_);
    const auto status =
        umfpack_dl_numeric(as_long(A.start), as_long(A.row), A.value.data(), symbolic_, &numeric_, control_, info_);
    if (status < 0) out_of_memory(A);
    nonzeros_ = info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ];
    matrix_ = &A;
    return status == UMFPACK_OK;
  }
  void solve(std::span<const double> b, std::span<double> x) {
    result_.resize(b.size());
    umfpack_dl_solve(UMFPACK_A, as_long(matrix_->start), as_long(matrix_->row), matrix_->value.data(), result_.data(),
                     b.data(), numeric_, control_, info_);
    std::copy(result_.begin(), result_.end(), x.begin());
  }
  double nonzeros() const { return nonzeros_; }

 private:
  double control_[UMFPACK_CONTROL] = {}, info_[UMFPACK_INFO] = {};
  void *symbolic_ = nullptr, *numeric_ = nullptr;
  const SparseMatrix* matrix_ = nullptr;
  std::vector<double> result_;
  double nonzeros_ = 0;
};

}  // namespace

struct SparseSolver::Parts {
  Cholesky cholesky;
  Lu lu;
  std::vector<std::int64_t> start, row;  // the pattern that the analyses are of
  bool positive = false;
  double analysis_seconds = 0;
};

SparseSolver::SparseSolver() : parts_(std::make_unique<Parts>()) {}
SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

bool SparseSolver::factorise(const SparseMatrix& A, Definite definite) {
  if (A.start != parts_->start || A.row != parts_->row) {
    parts_->cholesky.forget(), parts_->lu.forget();
    parts_->start = A.start, parts_->row = A.row;
  }
  parts_->positive = definite == Definite::positive && parts_->cholesky.factorise(A, parts_->analysis_seconds);
  return parts_->positive || parts_->lu.factorise(A, parts_->analysis_seconds);
}

void SparseSolver::solve(std::span<const double> b, std::span<double> x) {
  parts_->positive ? parts_->cholesky.solve(b, x) : parts_->lu.solve(b, x);
}

double SparseSolver::factor_nonzeros() const {
  return parts_->positive ? parts_->cholesky.nonzeros() : parts_->lu.nonzeros();
}

double SparseSolver::analysis_seconds() const { return parts_->analysis_seconds; }

std::string SparseSolver::method() const { return parts_->positive ? "cholesky" : "lu"; }

}  // namespace tether
