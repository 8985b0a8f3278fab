// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_solver.hpp"

#include <umfpack.h>

#include <algorithm>
#include <vector>

#include "algebra/cholmod_views.hpp"

namespace tether {
namespace {

/// The graph of the nodes whose unknowns stand together in the pattern; of a node without unknowns nothing.
struct NodeGraph {
  std::vector<std::int64_t> start{0}, row;
  std::vector<std::int64_t> first{0};  // unknown of each node, and their number
};

/// `block_start` is for nodes with different numbers of unknowns; where it is empty, each has `block`.
NodeGraph graph_of(const SparseMatrix& A, std::int64_t block, const std::vector<int>& block_start) {
  NodeGraph graph;
  if (block_start.empty()) {
    for (std::int64_t end = block; end <= A.n; end += block) graph.first.push_back(end);
  } else {
    for (const int end : block_start) {
      if (end > graph.first.back()) graph.first.push_back(end);
    }
  }
  std::vector<std::int64_t> node_at(static_cast<std::size_t>(A.n), -1);  // whose first unknown this is
  for (std::size_t k = 0; k + 1 < graph.first.size(); ++k)
    node_at[static_cast<std::size_t>(graph.first[k])] = static_cast<std::int64_t>(k);
  for (std::size_t k = 0; k + 1 < graph.first.size(); ++k) {
    const auto j = static_cast<std::size_t>(graph.first[k]);
    for (auto at = A.start[j]; at < A.start[j + 1]; ++at) {
      const auto node = node_at[static_cast<std::size_t>(A.row[static_cast<std::size_t>(at)])];
      if (node >= 0) graph.row.push_back(node);
    }
    graph.start.push_back(static_cast<std::int64_t>(graph.row.size()));
  }
  return graph;
}

/// An order of elimination with little fill for a pattern whose unknowns come in blocks, those of a node: minimum
/// degree or nested dissection, whichever is better, for the nodes' graph, which takes a part of the
/// time that the unknowns' takes and loses nothing.
std::vector<std::int64_t> order_of_blocks(const SparseMatrix& A, std::int64_t block,
                                          const std::vector<int>& block_start) {
  const NodeGraph nodes = graph_of(A, block, block_start);
  cholmod_common common;
  cholmod_l_start(&common);
  common.print = 0;
  // Both are tried, as by itself CHOLMOD judges whether the second is worth it by the small graph's work.
  common.nmethods = 2, common.method[0].ordering = CHOLMOD_AMD, common.method[1].ordering = CHOLMOD_METIS;
  cholmod_sparse graph = lower_view(nodes.start.size() - 1, nodes.start, nodes.row);
  cholmod_factor* factor = cholmod_l_analyze(&graph, &common);
  std::vector<std::int64_t> order;
  if (factor) {
    const auto* node = static_cast<const SuiteSparse_long*>(factor->Perm);
    for (std::size_t k = 0; k < factor->n; ++k) {
      const auto n = static_cast<std::size_t>(node[k]);
      for (auto unknown = nodes.first[n]; unknown < nodes.first[n + 1]; ++unknown) order.push_back(unknown);
    }
    cholmod_l_free_factor(&factor, &common);
  }
  cholmod_l_finish(&common);
  if (order.empty()) out_of_memory(A);
  return order;
}

/// Cholesky factors by CHOLMOD.
class Cholesky {
 public:
  Cholesky() {
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.nmethods = 1, common_.method[0].ordering = CHOLMOD_GIVEN, common_.postorder = 1;
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
  bool factorise(const SparseMatrix& A, const std::vector<std::int64_t>& order, Seconds& analysis) {
    cholmod_sparse matrix = lower_view(A);
    if (!factor_) {
      const Stopwatch watch(analysis);
      factor_ = cholmod_l_analyze_p(&matrix, as_long(order), nullptr, 0, &common_);
    }
    if (!factor_ || (!cholmod_l_factorize(&matrix, factor_, &common_) && common_.status < CHOLMOD_OK)) out_of_memory(A);
    return common_.status == CHOLMOD_OK;
  }
  void solve(std::span<const double> b, std::span<double> x) { solve_by(factor_, b, x, common_); }
  double nonzeros() const { return common_.lnz; }

 private:
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

/// LU factors by UMFPACK.
class Lu {
 public:
  Lu() {
    umfpack_dl_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // of the pattern
    control_[UMFPACK_IRSTEP] = 0;  // iterations of Newton's method and of GMRES refine what they solve
  }
  ~Lu() { forget(); }
  Lu(const Lu&) = delete;
  Lu& operator=(const Lu&) = delete;

  void forget() {
    umfpack_dl_free_numeric(&numeric_);
    umfpack_dl_free_symbolic(&symbolic_);
  }
  /// False where A is singular.
  bool factorise(const SparseMatrix& A, const std::vector<std::int64_t>& order, Seconds& analysis) {
    const auto n = static_cast<SuiteSparse_long>(A.n);
    if (!symbolic_) {
      const Stopwatch watch(analysis);
      if (umfpack_dl_qsymbolic(n, n, as_long(A.start), as_long(A.row), A.value.data(), as_long(order), &symbolic_,
                               control_, info_) < 0)
        out_of_memory(A);
    }
    umfpack_dl_free_numeric(&numeric_);
    const auto status =
        umfpack_dl_numeric(as_long(A.start), as_long(A.row), A.value.data(), symbolic_, &numeric_, control_, info_);
    if (status < 0) out_of_memory(A);
    nonzeros_ = info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ];
    return status == UMFPACK_OK;
  }
  void solve(std::span<const double> b, std::span<double> x) {
    result_.resize(b.size());
    umfpack_dl_solve(UMFPACK_A, nullptr, nullptr, nullptr, result_.data(), b.data(), numeric_, control_, info_);
    std::copy(result_.begin(), result_.end(), x.begin());
  }
  double nonzeros() const { return nonzeros_; }

 private:
  double control_[UMFPACK_CONTROL] = {}, info_[UMFPACK_INFO] = {};
  void *symbolic_ = nullptr, *numeric_ = nullptr;
  std::vector<double> result_;
  double nonzeros_ = 0;
};

}  // namespace

struct SparseSolver::Parts {
  Cholesky cholesky;
  Lu lu;
  int block = 1;
  std::vector<int> block_start;          // in place of block, or empty
  bool ordered = false;                  // once and for all
  std::vector<std::int64_t> start, row;  // the pattern that the analyses are of
  std::vector<std::int64_t> order;       // of elimination
  bool positive = false;
  Seconds analysis;
};

SparseSolver::SparseSolver(int block) : parts_(std::make_unique<Parts>()) { parts_->block = block; }
SparseSolver::SparseSolver(std::vector<int> block_start) : parts_(std::make_unique<Parts>()) {
  parts_->block_start = std::move(block_start);
}
SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

void SparseSolver::order_by(const SparseMatrix& A) {
  const Stopwatch watch(parts_->analysis);
  parts_->order = order_of_blocks(A, parts_->block, parts_->block_start);
  parts_->ordered = true;
}

bool SparseSolver::factorise(const SparseMatrix& A, Definite definite) {
  if (A.start != parts_->start || A.row != parts_->row) {
    parts_->cholesky.forget(), parts_->lu.forget();
    parts_->start = A.start, parts_->row = A.row;
    if (!parts_->ordered) {
      const Stopwatch watch(parts_->analysis);
      parts_->order = order_of_blocks(A, parts_->block, parts_->block_start);
    }
  }
  Parts& at = *parts_;
  at.positive = definite == Definite::positive && at.cholesky.factorise(A, at.order, at.analysis);
  return at.positive || at.lu.factorise(A, at.order, at.analysis);
}

void SparseSolver::solve(std::span<const double> b, std::span<double> x) {
  parts_->positive ? parts_->cholesky.solve(b, x) : parts_->lu.solve(b, x);
}

double SparseSolver::factor_nonzeros() const {
  return parts_->positive ? parts_->cholesky.nonzeros() : parts_->lu.nonzeros();
}

Seconds SparseSolver::analysis() const { return parts_->analysis; }

std::string SparseSolver::method() const { return parts_->positive ? "cholesky" : "lu"; }

}  // namespace tether
