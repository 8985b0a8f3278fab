// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grid/thickness.hpp"
#include "loops/thread_team.hpp"
#include "physics/flow/fields.hpp"
#include "physics/flow/state.hpp"
#include "physics/flow/steady.hpp"
#include "physics/flow/step.hpp"
#include "physics/flow/tracers.hpp"
#include "physics/flow/unknowns.hpp"
#include "physics/solids/body_doubts.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::fem {

/// Incompressible flow by finite elements (2.3). The plan, whose scene has a flow, must outlive the solver.
class FlowSolver final : public Solver {
 public:
  explicit FlowSolver(const Plan& plan, int threads = 1);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  RunCounts counts() const override;
  std::size_t cells_active() const override { return flow_.mesh.element_count(); }
  HistoryLayout history_layout() const override;
  Record record() const override;
  Snapshot points() const override { return tracers_.fields(state_); }
  Snapshot grid() const override;
  Snapshot solids() const override { return fields_.body_fields(state_); }
  std::vector<std::string> take_messages() override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;
  std::vector<CostPart> cost_parts() const override;
  Summary more_summary() const override;
  std::string worst_element() const override;

 private:
  Summary cost_summary() const;
  void start_looking_at_meshes();
  void look_at_bodies();
  void look_at_spacing();
  void look_at_thickness();
  void tell_of_failures(long long before);
  FlowReport advance_by(double part);
  [[noreturn]] void stop(double dt, const FlowReport& report) const;
  [[noreturn]] void stop_steady(double dt, const FlowReport& report, const std::string& fastest) const;
  bool has_light_bodies() const;
  void check_kinetic_energy() const;

  const Plan& plan_;
  const Flow& flow_;
  ThreadTeam team_;
  FlowUnknowns unknowns_;
  FlowStep step_;
  FlowTracers tracers_;
  FlowFields fields_;
  FlowState state_;
  std::optional<SteadyBodies> steady_bodies_;
  std::optional<BodyOverlaps> overlaps_;
  std::optional<BodyDoubts> doubts_;  // of immersed solids
  std::optional<BodyThickness> thickness_;
  bool light_bodies_ = false;  // whose kinetic energy is looked at
  std::vector<std::string> messages_;
};

}  // namespace tether::fem
