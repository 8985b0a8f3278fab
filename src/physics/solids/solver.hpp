// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "loops/thread_team.hpp"
#include "physics/solids/body_doubts.hpp"
#include "physics/solids/fields.hpp"
#include "physics/solids/step.hpp"
#include "physics/solids/system.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::fem {

/// Elastic bodies by finite elements (2.1). The plan, whose scene has solids, must outlive the solver.
class SolidSolver final : public Solver {
 public:
  /// Throws RunError where the start wants an equilibrium that Newton's method does not find.
  explicit SolidSolver(const Plan& plan, int threads = 1);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  RunCounts counts() const override;
  std::size_t cells_active() const override { return system_.solids.mesh.element_count(); }
  HistoryLayout history_layout() const override {
    HistoryLayout layout = columns_.layout();
    layout.rounding_energy = rounding_energy_;
    return layout;
  }
  Record record() const override { return columns_.record(sums_of(state_, system_)); }
  Snapshot points() const override { return {state_.time, {}}; }
  Snapshot grid() const override;
  std::vector<std::string> take_messages() override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;
  std::vector<CostPart> cost_parts() const override;
  Summary more_summary() const override;
  bool watched_each_step() const override { return system_.solids.integrator != Integrator::central; }
  std::string worst_element() const override { return fem::worst_element(system_, state_.q); }

 private:
  bool implicit() const {
    return system_.solids.integrator != Integrator::central && system_.solids.integrator != Integrator::equilibrium;
  }
  void start();
  void tell_of_short_steps();
  void look_at_bodies();
  double next_step() const;
  void step(double dt);
  NewtonReport advanced(double dt);
  [[noreturn]] void lose(double dt) const;

  const Plan& plan_;
  ThreadTeam team_;
  SolidSystem system_;
  SolidStep step_;
  SolidState state_;
  Columns<SolidSums> columns_;
  double rounding_energy_;
  BodyOverlaps overlaps_;
  BodyDoubts doubts_;
  std::vector<std::string> messages_;
};

}  // namespace tether::fem
