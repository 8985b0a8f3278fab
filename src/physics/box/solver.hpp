// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loops/thread_team.hpp"
#include "physics/box/fields.hpp"
#include "physics/box/step.hpp"
#include "physics/solids/body_doubts.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::coupled {

/// An incompressible fluid and deformable solids, solved together. The plan, whose scene is coupled, must outlive the
/// solver; so many threads share its work.
class CoupledSolver final : public Solver {
 public:
  explicit CoupledSolver(const Plan& plan, int threads = 1);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  RunCounts counts() const override;
  std::size_t cells_active() const override;
  HistoryLayout history_layout() const override { return fields_.history_layout(); }
  Record record() const override { return fields_.record(state_); }
  Snapshot points() const override { return step_.flow().particle_fields(state_); }
  Snapshot grid() const override { return step_.flow().cell_fields(state_); }
  Snapshot solids() const override { return fields_.solid_fields(state_); }
  Snapshot surface() const override { return step_.flow().surface_fields(state_); }
  Snapshot flow_cells() const override { return step_.flow().mesh_fields(state_); }
  std::vector<std::string> take_messages() override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;
  std::vector<CostPart> cost_parts() const override;
  Summary more_summary() const override;
  bool watched_each_step() const override { return true; }
  std::string worst_element() const override;

 private:
  fem::NewtonReport advanced(double h);
  [[noreturn]] void refuse_step(double h, const fem::NewtonReport& report) const;
  void look_for_overlaps();

  const Plan& plan_;
  Solids none_;  // of a scene without any
  ThreadTeam team_;
  CoupledStep step_;
  CoupledFields fields_;
  CoupledState state_;
  fem::BodyOverlaps overlaps_;
  std::vector<std::string> messages_;
  std::optional<double> ratio_;  // of added mass at the start, by which splitting holds or fails
};

}  // namespace tether::coupled
