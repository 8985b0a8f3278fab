// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algebra/aggregates.hpp"
#include "algebra/krylov.hpp"
#include "algebra/sparse_solver.hpp"

namespace tether {
namespace {

constexpr int coarsest = 500;       // unknowns, of which direct factors take little
constexpr double too_few = 0.9;     // of a level's unknowns left on the next: coarser ones do not pay
constexpr double well = 0.25;       // of the residual left by one inner iteration: a second one is not needed
constexpr double definite = 1e-10;  // of the diagonal, added to that of the coarsest matrix, which may be singular

std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }

/// y += factor x
void add(double factor, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += factor * x[i];
}

struct Level {
  explicit Level(SymmetricRows matrix) : A(std::move(matrix)), inverse(at(A.n)) {
    for (std::size_t i = 0; i < inverse.size(); ++i) inverse[i] = A.positive(i) ? 1 / A.diagonal[i] : 0;
    for (auto* room : {&r, &z, &p, &Ap, &q, &Aq}) room->resize(at(A.n));
  }

  /// z = (D + L)^-1 r
  void sweep_forward(std::span<const double> right, std::span<double> x) const {
    for (std::size_t i = 0; i < inverse.size(); ++i) {
      double sum = right[i];
      for (auto k = at(A.start[i]); k < at(A.middle[i]); ++k) sum -= A.value[k] * x[at(A.column[k])];
      x[i] = sum * inverse[i];
    }
  }
  /// x becomes x + (D + U)^-1 (r - A x). The entry that was computed last is taken last, so that none waits for it.
  void sweep_backward(std::span<const double> right, std::span<double> x) const {
    for (std::size_t i = inverse.size(); i-- > 0;) {
      double sum = right[i];
      for (auto k = at(A.start[i]); k < at(A.middle[i]); ++k) sum -= A.value[k] * x[at(A.column[k])];
      for (auto k = at(A.start[i + 1]); k-- > at(A.middle[i]);) sum -= A.value[k] * x[at(A.column[k])];
      x[i] = sum * inverse[i];
    }
  }
  /// The residual after a forward sweep from 0, which is -U x, summed over aggregates.
  void restrict_residual(std::span<const double> x, std::vector<double>& to) const {
    std::fill(to.begin(), to.end(), 0.0);
    for (std::size_t i = 0; i < inverse.size(); ++i) {
      if (aggregates.of[i] < 0) continue;
      double sum = 0;
      for (auto k = at(A.middle[i]); k < at(A.start[i + 1]); ++k) sum += A.value[k] * x[at(A.column[k])];
      to[at(aggregates.of[i])] -= sum;
    }
  }
  void add_coarse(std::span<const double> coarse, std::span<double> x) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (aggregates.of[i] >= 0) x[i] += coarse[at(aggregates.of[i])];
    }
  }

  SymmetricRows A;
  std::vector<double> inverse;       // of the diagonal
  Aggregates aggregates;             // none on the coarsest level
  std::vector<double> r, z;          // the level's right side and solution
  std::vector<double> p, Ap, q, Aq;  // directions of its two iterations
};

}  // namespace

struct AggregationMultigrid::Parts {
  bool factorise_coarsest();
  void cycle(std::size_t level, std::span<const double> r, std::span<double> z);
  void iterate_twice(std::size_t level);

  std::vector<Level> levels;
  SparseSolver direct;
};

bool AggregationMultigrid::Parts::factorise_coarsest() {
  const Level& level = levels.back();
  if (level.A.n == 0) return true;
  SymmetricRows shifted = level.A;
  for (std::size_t i = 0; i < level.inverse.size(); ++i)
    shifted.diagonal[i] = level.inverse[i] > 0 ? (1 + definite) * shifted.diagonal[i] : shifted.scale[i];
  return direct.factorise(columns_of(shifted), Definite::positive);
}

void AggregationMultigrid::Parts::cycle(std::size_t level, std::span<const double> r, std::span<double> z) {
  const Level& fine = levels[level];
  if (level + 1 == levels.size()) {
    if (fine.A.n > 0) direct.solve(r, z);
    return;
  }
  Level& coarse = levels[level + 1];
  fine.sweep_forward(r, z);
  fine.restrict_residual(z, coarse.r);
  iterate_twice(level + 1);
  fine.add_coarse(coarse.z, z);
  fine.sweep_backward(r, z);
}

/// z of the level from its r, which is spent: conjugate gradients from 0, the second direction conjugate to the first.
void AggregationMultigrid::Parts::iterate_twice(std::size_t level) {
  Level& on = levels[level];
  if (level + 1 == levels.size()) return cycle(level, on.r, on.z);
  std::fill(on.z.begin(), on.z.end(), 0.0);
  cycle(level, on.r, on.p);
  on.A.multiply(on.p, on.Ap);
  const double pAp = dot(on.p, on.Ap), before = norm(on.r);
  if (!(pAp > 0)) return;
  const double step = dot(on.p, on.r) / pAp;
  add(step, on.p, on.z);
  add(-step, on.Ap, on.r);
  if (norm(on.r) <= well * before) return;
  cycle(level, on.r, on.q);
  on.A.multiply(on.q, on.Aq);
  const double along = dot(on.q, on.Ap) / pAp;
  add(-along, on.p, on.q);
  const double qAq = dot(on.q, on.Aq);  // q has lost its part along p since, which is conjugate to what is left
  if (qAq > 0) add(dot(on.q, on.r) / qAq, on.q, on.z);
}

AggregationMultigrid::AggregationMultigrid() : parts_(std::make_unique<Parts>()) {}
AggregationMultigrid::~AggregationMultigrid() = default;
AggregationMultigrid::AggregationMultigrid(AggregationMultigrid&&) noexcept = default;
AggregationMultigrid& AggregationMultigrid::operator=(AggregationMultigrid&&) noexcept = default;

bool AggregationMultigrid::set_up(const SparseMatrix& A) {
  auto& levels = parts_->levels;
  levels.clear();
  levels.emplace_back(rows_of(A));
  for (const double diagonal : levels.front().A.diagonal) {
    if (!(diagonal > 0) || std::isinf(diagonal)) return false;
  }
  while (levels.back().A.n > coarsest) {
    SymmetricRows coarse;
    Aggregates aggregates = aggregate(levels.back().A, coarse);
    if (aggregates.count > too_few * levels.back().A.n) break;
    levels.back().aggregates = std::move(aggregates);
    levels.emplace_back(std::move(coarse));
  }
  return parts_->factorise_coarsest();
}

void AggregationMultigrid::precondition(std::span<const double> r, std::span<double> z) { parts_->cycle(0, r, z); }

int AggregationMultigrid::levels() const { return static_cast<int>(parts_->levels.size()); }

double AggregationMultigrid::complexity() const {
  double all = 0;
  for (const Level& level : parts_->levels) all += level.A.nonzeros();
  return all / parts_->levels.front().A.nonzeros();
}

}  // namespace tether
