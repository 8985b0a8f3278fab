// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/gas_mixing.hpp"
#include "solvers/mpm/leak_watch.hpp"
#include "solvers/mpm/point_laws.hpp"
#include "solvers/mpm/sort.hpp"
#include "solvers/mpm/state.hpp"
#include "solvers/mpm/steps.hpp"
#include "solvers/mpm/stretch_watch.hpp"
#include "solvers/mpm/string_watch.hpp"
#include "solvers/solver.hpp"

namespace tether::mpm {

/// The material point method: the thesis' own (chapters 3 to 5: lumped mass, momentum formulation, linear
/// quadrilaterals, FLIP) or the robust set, by the scene's method; one thread. The plan must outlive the solver.
class MpmSolver final : public Solver {
 public:
  explicit MpmSolver(const Plan& plan);

  double time() const override { return state_.time; }
  void advance(double until) override;
  RunCounts counts() const override;
  HistoryLayout history_layout() const override { return columns_.layout(); }
  Record record() const override { return columns_.record(sums_of(state_, plan_.scene)); }
  Snapshot points() const override;
  Snapshot grid() const override;
  Summary more_summary() const override;
  std::vector<std::string> take_messages() override;
  SavedState save() const override { return mpm::save(state_); }
  void restore(const SavedState& saved) override {
    mpm::restore(state_, plan_.scene, saved);
    messages_.clear();  // of the start: the run has them
  }

 private:
  double next_step();
  void step(double dt);
  void pass_edges(StepWork& work, double dt);
  void finish_step(const StepFindings& found, double dt);
  void sort_where_scattered();
  void look();

  const Plan& plan_;
  StepSet set_;
  State state_;
  CellSort sort_;
  StringWatch strings_;
  StretchWatch stretches_;
  GasMixing mixing_;
  LeakWatch leaks_;
  Columns<PointSums> columns_;
  std::vector<std::string> messages_;
};

}  // namespace tether::mpm
