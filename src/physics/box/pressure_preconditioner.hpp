// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>

#include "algebra/multigrid.hpp"
#include "algebra/two_level.hpp"

namespace tether::coupled {

/// Preconditioner for the pressures' matrices: multigrid of aggregates for those of a grid; two levels where the flow
/// knows coarse pressures, for those of a mesh, whose couplings have both signs.
class PressurePreconditioner {
 public:
  /// The team shares its loops, and must outlive it.
  explicit PressurePreconditioner(Team& team) : team_(team), multigrid_(team) {}

  /// Lets go of what it had.
  void clear() { multigrid_ = AggregationMultigrid(team_), two_levels_ = {}, rows_ = {}; }
  /// Prepares for A, without BLAS; `coarse` (null: none) must stay until factorise(), after which it is ready. False
  /// where A is not fit.
  bool make_levels(SymmetricRows A, const CoarseUnknowns* coarse) {
    coarse_ = coarse;
    if (coarse == nullptr) return multigrid_.make_levels(std::move(A));
    rows_ = std::move(A);
    return true;
  }
  bool factorise() {
    return coarse_ == nullptr ? multigrid_.factorise() : two_levels_.set_up(std::exchange(rows_, {}), *coarse_);
  }
  void precondition(std::span<const double> r, std::span<double> z) {
    coarse_ == nullptr ? multigrid_.precondition(r, z) : two_levels_.precondition(r, z);
  }

 private:
  Team& team_;
  AggregationMultigrid multigrid_;
  TwoLevelPreconditioner two_levels_;
  const CoarseUnknowns* coarse_ = nullptr;
  SymmetricRows rows_;
};

}  // namespace tether::coupled
