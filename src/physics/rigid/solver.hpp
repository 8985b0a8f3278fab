// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "physics/rigid/fields.hpp"
#include "physics/rigid/step.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::fem {

/// A rigid body (2.2) with the mass of a mesh. The plan, whose scene has solids that are rigid, must outlive the
/// solver.
class RigidSolver final : public Solver {
 public:
  explicit RigidSolver(const Plan& plan);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  RunCounts counts() const override;
  std::size_t cells_active() const override { return system_.solids.mesh.element_count(); }
  HistoryLayout history_layout() const override { return columns_.layout(); }
  Record record() const override { return columns_.record(sums_of(state_, system_)); }
  Snapshot points() const override { return {state_.time, {}}; }
  Snapshot grid() const override;
  std::vector<std::string> take_messages() override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;
  Summary more_summary() const override;

 private:
  void step(double dt);
  RigidReport try_step(double dt);
  [[noreturn]] void stop(double dt, const RigidReport& report) const;

  const Plan& plan_;
  RigidSystem system_;
  RigidRunState state_;
  Columns<RigidSums> columns_;
  std::vector<std::string> messages_;
};

}  // namespace tether::fem
