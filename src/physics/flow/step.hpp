// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "physics/flow/elements.hpp"
#include "physics/flow/immersed/forces.hpp"
#include "physics/flow/immersed/solids.hpp"
#include "physics/flow/kept_factors.hpp"
#include "physics/flow/linear.hpp"
#include "physics/flow/state.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {

/// How Newton's method went in a step: of each iteration the residual over what is measured against, 1 and less where
/// the tolerance is met.
struct FlowReport {
  bool converged = false;
  std::vector<double> residuals;
  std::string cause;  ///< what else is known of where it did not converge
};

/// What the steps have cost; the symbolic analysis is a part of the solution.
struct FlowCost {
  Seconds assembly, solve, analysis;
  double factor_nonzeros = 0;
};

/// Numbers of a step that the deck's clock decides.
struct FlowStepTime {
  double start = 0, dt = 0;  ///< [time]
  double tmax = 0;           ///< of steady flows, whose viscosity is mu tmax/(start + dt), or with bodies their loads'
                             ///< part (start + dt)/tmax [time]
  bool sudden = false;       ///< the boundary's velocities are those of the start, which v0 has not followed yet
  double settling = 0;       ///< of steady flows with bodies: how long these go with the fluid's velocity [time]
};

/// One step of a flow from v0 at t to v1 at t + dt (47), or one steady flow.
class FlowStep {
 public:
  /// `gravity` acts along y [length/time2]; `solids` are immersed in the flow, or null; the team shares
  /// its loops. All must outlive it.
  FlowStep(const FlowUnknowns& unknowns, const Solids* solids, double gravity, Team& team);

  /// Makes the velocities of the start incompressible, as walls and inflows that set in at once would do it, and puts
  /// solids to their places; `dt` is that of the steps to come [time].
  FlowReport start(FlowState& state, double dt);
  /// Advances the state by dt, its time apart, or leaves it as it was where Newton's method does not converge.
  FlowReport advance(FlowState& state, const FlowStepTime& at);
  /// Finds the factors again that a saved state went on with.
  void resume(const FlowState& state, double tmax);

  /// Null where there are none.
  ImmersedSolids* immersed() const { return immersed_.get(); }
  const FlowElements& elements() const { return *elements_; }
  /// That of the last step [stress time].
  double viscosity() const { return viscosity_; }
  const FlowCost& cost() const { return cost_; }
  bool by_krylov() const { return linear_.by_krylov(); }

 private:
  void begin(const FlowState& state, const FlowStepTime& at);
  void begin_bodies(const FlowState& state);
  void scale_loads();
  bool settles() const { return immersed_ && unknowns_.flow.integrator == FlowIntegrator::steady; }
  FlowMoment moment(std::span<const double> v0) const;
  double find_residual(const FlowState& state);
  bool factorise(FlowState& state);
  bool correct(FlowState& state, double residual);
  bool find_correction(double residual);
  FlowScales scales(const FlowState& state) const;
  void count(FlowState& state);
  bool apply_correction(double part);
  void update_pattern();
  void accept(FlowState& state);
  void add_exchange(FlowState& state);
  double residual_behind_correction(const FlowState& state, double before);
  void take_back_correction(const FlowState& state);

  const FlowUnknowns& unknowns_;
  std::unique_ptr<FlowElements> elements_;
  std::unique_ptr<ImmersedSolids> immersed_;
  std::unique_ptr<ImmersedForces> forces_;  // of these
  double gravity_;
  std::vector<bool> inflow_;  // of each node, whether an inflow prescribes its velocity
  ClusterPattern pattern_;
  SparseMatrix K_;
  FlowLinear linear_;
  KeptFactors factors_;                   // of K
  double size_ = 0, corrected_part_ = 0;  // of the residual; of the last correction what was applied
  FlowScale first_scale_;
  // The step: velocities and pressure at its end, residuals of momentum and incompressibility, right side, correction.
  FlowStepTime at_;
  double theta_ = 0.5, rate_ = 0, viscosity_ = 0, loads_ = 1;  // loads_: the part of them that acts
  std::vector<double> v1_, p_, f_, g_, acceleration_, change_;
  Lists solid_clusters_;  // those of the pattern that are of immersed solids
  FlowCost cost_;
};

}  // namespace tether::fem
