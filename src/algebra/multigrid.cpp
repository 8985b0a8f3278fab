// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algebra/aggregates.hpp"
#include "algebra/krylov.hpp"
#include "algebra/multigrid_level.hpp"
#include "algebra/sparse_solver.hpp"

namespace tether {
namespace {

constexpr int coarsest = 500;       // unknowns, of which direct factors take little
constexpr double too_few = 0.9;     // of a level's unknowns left on the next: coarser ones do not pay
constexpr double well = 0.25;       // of the residual left by one inner iteration: a second one is not needed
constexpr double definite = 1e-10;  // of the diagonal, added to that of the coarsest matrix, which may be singular

}  // namespace

struct AggregationMultigrid::Parts {
  explicit Parts(Team& with) : team(with) {}
  bool factorise_coarsest();
  void cycle(std::size_t level, std::span<const double> r, std::span<double> z);
  void iterate_twice(std::size_t level);

  Team& team;
  std::vector<MultigridLevel> levels;
  SparseSolver direct;
};

bool AggregationMultigrid::Parts::factorise_coarsest() {
  const MultigridLevel& level = levels.back();
  if (level.A.n == 0) return true;
  SymmetricRows shifted = level.A;
  for (std::size_t i = 0; i < level.inverse.size(); ++i)
    shifted.diagonal[i] = level.inverse[i] > 0 ? (1 + definite) * shifted.diagonal[i] : shifted.scale[i];
  return direct.factorise(columns_of(shifted), Definite::positive);
}

void AggregationMultigrid::Parts::cycle(std::size_t level, std::span<const double> r, std::span<double> z) {
  MultigridLevel& fine = levels[level];
  if (level + 1 == levels.size()) {
    if (fine.A.n > 0) direct.solve(r, z);
    return;
  }
  MultigridLevel& coarse = levels[level + 1];
  fine.sweep_forward(team, r, z);
  fine.restrict_residual(team, z, coarse.r);
  iterate_twice(level + 1);
  fine.add_coarse(team, coarse.z, z);
  fine.sweep_backward(team, r, z);
}

/// z of the level from its r, which is spent: conjugate gradients from 0, the second direction conjugate to the first.
void AggregationMultigrid::Parts::iterate_twice(std::size_t level) {
  MultigridLevel& on = levels[level];
  if (level + 1 == levels.size()) return cycle(level, on.r, on.z);
  std::fill(on.z.begin(), on.z.end(), 0.0);
  cycle(level, on.r, on.p);
  on.A.multiply(team, on.p, on.Ap);
  const double pAp = dot(team, on.p, on.Ap), before = norm(team, on.r);
  if (!(pAp > 0)) return;
  const double step = dot(team, on.p, on.r) / pAp;
  add(team, step, on.p, on.z);
  add(team, -step, on.Ap, on.r);
  if (norm(team, on.r) <= well * before) return;
  cycle(level, on.r, on.q);
  on.A.multiply(team, on.q, on.Aq);
  const double along = dot(team, on.q, on.Ap) / pAp;
  add(team, -along, on.p, on.q);
  const double qAq = dot(team, on.q, on.Aq);  // q has lost its part along p since, which is conjugate to what is left
  if (qAq > 0) add(team, dot(team, on.q, on.r) / qAq, on.q, on.z);
}

AggregationMultigrid::AggregationMultigrid(Team& team) : parts_(std::make_unique<Parts>(team)) {}
AggregationMultigrid::~AggregationMultigrid() = default;
AggregationMultigrid::AggregationMultigrid(AggregationMultigrid&&) noexcept = default;
AggregationMultigrid& AggregationMultigrid::operator=(AggregationMultigrid&&) noexcept = default;

bool AggregationMultigrid::make_levels(SymmetricRows A) {
  auto& levels = parts_->levels;
  levels.clear();
  levels.emplace_back(std::move(A));
  for (const double diagonal : levels.front().A.diagonal) {
    if (!(diagonal > 0) || std::isinf(diagonal)) return false;
  }
  while (levels.back().A.n > coarsest) {
    SymmetricRows coarse;
    Aggregates aggregates = aggregate(levels.back().A, coarse);
    if (aggregates.count > too_few * levels.back().A.n) break;
    levels.back().join(std::move(aggregates));
    levels.emplace_back(std::move(coarse));
  }
  for (std::size_t level = 1; level < levels.size(); ++level) levels[level].prepare_iterations();
  return true;
}

bool AggregationMultigrid::factorise() { return parts_->factorise_coarsest(); }

void AggregationMultigrid::precondition(std::span<const double> r, std::span<double> z) { parts_->cycle(0, r, z); }

int AggregationMultigrid::levels() const { return static_cast<int>(parts_->levels.size()); }

double AggregationMultigrid::complexity() const {
  double all = 0;
  for (const MultigridLevel& level : parts_->levels) all += level.A.nonzeros();
  return all / parts_->levels.front().A.nonzeros();
}

}  // namespace tether
