// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "physics/points/arrays.hpp"
#include "physics/points/fields.hpp"
#include "physics/points/gas_mixing.hpp"
#include "physics/points/point_laws.hpp"
#include "physics/points/state.hpp"
#include "physics/points/steps.hpp"
#include "physics/points/watches.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether::mpm {

/// Ends the run with a RunError that names point, body, cell, time and likely cause. `dt` is the step that failed.
[[noreturn]] void stop_on_trouble(const State& state, const Plan& plan, const Trouble& trouble, double dt);

/// Ends the run because waves have become so fast that no step is left; `waves` says which, up to their speed.
[[noreturn]] void stop_on_vanishing_step(const State& state, const char* waves, double dt);

/// The material point method: the thesis' own (chapters 3 to 5: lumped mass, momentum formulation, linear
/// quadrilaterals, FLIP) or the robust set, by the scene's method. A strip runs as one row, and what is read are all of
/// its points. The plan must outlive the solver.
class MpmSolver final : public Solver {
 public:
  explicit MpmSolver(const Plan& plan, int threads = 1);
  /// Takes the scene's points apart from it, which are gone then.
  MpmSolver(const Plan& plan, PointSet points, int threads = 1);

  double time() const override { return state_.time; }
  using Solver::advance;
  void advance(double until, long long most) override;
  void expect_reading(double time) override { reading_ = time; }
  bool readable() const override { return readable_; }
  RunCounts counts() const override;
  std::size_t cells_active() const override { return set_.count_cells(state_, scene_); }
  HistoryLayout history_layout() const override { return columns_.layout(); }
  Record record() const override { return columns_.record(sums_of(state_, scene_)); }
  Snapshot points() const override;
  void write_points(const std::function<void(const FieldsInTurn&)>& write) const override;
  Snapshot grid() const override;
  Summary more_summary() const override;
  std::vector<std::string> take_messages() override;
  SavedState save() const override { return mpm::save(state_); }
  void restore(const SavedState& saved) override {
    mpm::restore(state_, scene_, saved);
    set_.list_active(state_);
    messages_.clear();  // of the start: the run has them
    readable_ = true;
  }

 private:
  double next_step();
  void step(double dt, bool records);
  void pass_edges(StepWork& work, double dt);
  void finish_step(const StepFindings& found, double dt);
  void sort_where_scattered();
  void look();

  const Plan& plan_;
  std::unique_ptr<const Scene> row_;  // of the plan's scene, where that runs as one
  const Scene& scene_;                // what runs: the plan's, or its row's
  StepSet set_;
  State state_;
  CellSort sort_;
  StringWatch strings_;
  StretchWatch stretches_;
  GasMixing mixing_;
  LeakWatch leaks_;
  Columns<PointSums> columns_;
  double reading_ = -std::numeric_limits<double>::infinity();  // time before which nothing is read
  bool readable_ = true;
  std::vector<std::string> messages_;
};

}  // namespace tether::mpm
