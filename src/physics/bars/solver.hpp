// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "model/bars.hpp"
#include "physics/bars/bars.hpp"
#include "physics/bars/fields.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::fem {

/// Strings as two-node bars with lumped mass by central differences: the code that the thesis compares its pendulum
/// with (5.7, Figs. 36 and 37). The plan must outlive the solver.
class BarSolver final : public Solver {
 public:
  explicit BarSolver(const Plan& plan);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  RunCounts counts() const override;
  HistoryLayout history_layout() const override { return columns_.layout(); }
  Record record() const override;
  Snapshot points() const override;
  Snapshot grid() const override { return {state_.time, {}}; }  // bars have none
  SavedState save() const override { return fem::save(state_); }
  void restore(const SavedState& saved) override { fem::restore(state_, saved); }
  std::vector<std::string> take_messages() override;

 private:
  double next_step() const;
  void step(double dt);
  void carry_over(double dt);
  void look_behind_walls();
  [[noreturn]] void stop(double dt) const;

  const Plan& plan_;
  BarMesh mesh_;
  BarArrays bars_;
  BarState state_;
  Columns<BarSums> columns_;
  std::vector<std::string> messages_;
};

}  // namespace tether::fem
