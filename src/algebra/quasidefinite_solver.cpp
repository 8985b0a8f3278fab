// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/quasidefinite_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/cholmod_views.hpp"

namespace tether {
namespace {

constexpr double too_many = 1.2;  // times the nonzeros that the order gave when it was found: a new one is due
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();  // in a residual that needs no refinement

/// The lower triangle of K with its diagonal.
void take_lower(const SparseMatrix& K, SparseMatrix& lower) {
  lower.n = K.n;
  lower.start.assign(1, 0), lower.row.clear(), lower.value.clear();
  for (std::int64_t j = 0; j < K.n; ++j) {
    const auto end = static_cast<std::size_t>(K.start[static_cast<std::size_t>(j) + 1]);
    for (auto at = static_cast<std::size_t>(K.start[static_cast<std::size_t>(j)]); at < end; ++at) {
      if (K.row[at] >= j) lower.row.push_back(K.row[at]), lower.value.push_back(K.value[at]);
    }
    lower.start.push_back(static_cast<std::int64_t>(lower.row.size()));
  }
}

/// r = b - K x, and in `size` the sum of the moduli of its terms, by the lower triangle of K.
void residual(const SparseMatrix& lower, std::span<const double> b, std::span<const double> x, std::span<double> r,
              std::span<double> size) {
  for (std::size_t i = 0; i < b.size(); ++i) r[i] = b[i], size[i] = std::abs(b[i]);
  const auto take = [&](std::size_t i, double term) { r[i] -= term, size[i] += std::abs(term); };
  for (std::size_t j = 0; j < b.size(); ++j) {
    for (auto at = static_cast<std::size_t>(lower.start[j]); at < static_cast<std::size_t>(lower.start[j + 1]); ++at) {
      const auto i = static_cast<std::size_t>(lower.row[at]);
      take(i, lower.value[at] * x[j]);
      if (i != j) take(j, lower.value[at] * x[i]);
    }
  }
}

}  // namespace

struct QuasidefiniteSolver::Parts {
  Parts() {
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SIMPLICIAL;  // which alone has factors L D L^T
    common.final_ll = 0;
    common.postorder = 1;
  }
  ~Parts() {
    forget();
    cholmod_l_finish(&common);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  void forget() {
    if (factor) cholmod_l_free_factor(&factor, &common);
  }
  void analyse();
  void find_order(cholmod_sparse& matrix);
  bool count_pivots();

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  SparseMatrix lower, next;  // the matrix factorised last; room for the next one
  EliminationOrder order;
  double nonzeros = 0;
  std::int64_t negative = 0;
  int analyses = 0, orders = 0;
  std::vector<double> right, r, size;
};

/// The order of least fill, and the symbolic factor by it.
void QuasidefiniteSolver::Parts::find_order(cholmod_sparse& matrix) {
  forget();
  common.nmethods = 2, common.method[0].ordering = CHOLMOD_AMD, common.method[1].ordering = CHOLMOD_METIS;
  factor = cholmod_l_analyze(&matrix, &common);
  if (!factor) out_of_memory(lower);
  const auto* found = static_cast<const SuiteSparse_long*>(factor->Perm);
  order.unknowns.assign(found, found + lower.n);
  order.nonzeros = common.lnz;
  ++orders;
}

/// A symbolic factor for the pattern of `lower`, by the order that is there unless that has become too bad.
void QuasidefiniteSolver::Parts::analyse() {
  cholmod_sparse matrix = lower_view(lower);
  forget();
  ++analyses;
  if (order.unknowns.size() == static_cast<std::size_t>(lower.n)) {
    common.nmethods = 1, common.method[0].ordering = CHOLMOD_GIVEN;
    factor = cholmod_l_analyze_p(&matrix, as_long(order.unknowns), nullptr, 0, &common);
    if (!factor) out_of_memory(lower);
    if (common.lnz > too_many * order.nonzeros) find_order(matrix);
  } else {
    find_order(matrix);
  }
  nonzeros = common.lnz;
}

/// False where a pivot is 0 or no number.
bool QuasidefiniteSolver::Parts::count_pivots() {
  const auto* value = static_cast<const double*>(factor->x);
  const auto* start = static_cast<const SuiteSparse_long*>(factor->p);
  negative = 0;
  for (std::size_t j = 0; j < factor->n; ++j) {
    const double pivot = value[start[j]];
    if (pivot == 0 || !std::isfinite(pivot)) return false;
    negative += pivot < 0;
  }
  return true;
}

QuasidefiniteSolver::QuasidefiniteSolver() : parts_(std::make_unique<Parts>()) {}
QuasidefiniteSolver::~QuasidefiniteSolver() = default;
QuasidefiniteSolver::QuasidefiniteSolver(QuasidefiniteSolver&&) noexcept = default;
QuasidefiniteSolver& QuasidefiniteSolver::operator=(QuasidefiniteSolver&&) noexcept = default;

bool QuasidefiniteSolver::factorise(const SparseMatrix& K) {
  Parts& at = *parts_;
  take_lower(K, at.next);
  const bool same = at.factor && at.next.start == at.lower.start && at.next.row == at.lower.row;
  std::swap(at.next, at.lower);
  if (K.n == 0) {
    at.forget();
    at.nonzeros = 0, at.negative = 0;
    return true;
  }
  if (!same) at.analyse();
  cholmod_sparse matrix = lower_view(at.lower);
  if (!cholmod_l_factorize(&matrix, at.factor, &at.common) && at.common.status < CHOLMOD_OK) out_of_memory(K);
  return at.factor->minor == at.factor->n && at.count_pivots();
}

void QuasidefiniteSolver::solve(std::span<const double> b, std::span<double> x) {
  if (b.empty()) return;
  Parts& at = *parts_;
  at.r.resize(b.size());
  at.size.resize(b.size());
  at.right.assign(b.begin(), b.end());  // b may be x
  const std::span<const double> right = at.right;
  solve_by(at.factor, right, x, at.common);
  residual(at.lower, right, x, at.r, at.size);
  bool enough = true;
  for (std::size_t i = 0; i < right.size(); ++i) enough = enough && !(std::abs(at.r[i]) > rounding * at.size[i]);
  if (enough) return;
  solve_by(at.factor, at.r, at.r, at.common);
  for (std::size_t i = 0; i < right.size(); ++i) x[i] += at.r[i];
}

const EliminationOrder& QuasidefiniteSolver::order() const { return parts_->order; }

void QuasidefiniteSolver::keep_order(EliminationOrder order) {
  parts_->forget();
  parts_->order = std::move(order);
}

std::int64_t QuasidefiniteSolver::negative_pivots() const { return parts_->negative; }
double QuasidefiniteSolver::factor_nonzeros() const { return parts_->nonzeros; }
int QuasidefiniteSolver::analyses() const { return parts_->analyses; }
int QuasidefiniteSolver::orders() const { return parts_->orders; }

}  // namespace tether
