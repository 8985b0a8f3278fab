// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "physics/solids/step.hpp"

namespace tether::fem {

// The equilibrium that a run starts from.

NewtonReport SolidStep::settle(SolidState& state) {
  constexpr double least = 1.0 / 64;  // part of the loads that is added at a time
  const StepForces own = std::exchange(rule_, equilibrium_forces);
  NewtonReport report;
  double loaded = 0, more = 1;
  while (loaded < 1 && more >= least) {
    report = settle_by(state, loaded + more);
    if (!report.converged) {
      more *= 0.5;
      continue;
    }
    loaded += more;
    if (loaded < 1) more = std::min(more, 1 - loaded);
  }
  if (report.converged) note_hold(state);
  rule_ = own, loaded_ = 1;
  return report;
}

/// The equilibrium with this part of loads and supports, from that of the state.
NewtonReport SolidStep::settle_by(SolidState& state, double part) {
  loaded_ = part;
  system_.external_forces(state.time, dead_);
  for (double& force : dead_) force *= part;
  NewtonReport report;
  for (const NewtonRule& rule : newton_rules) {
    q1_ = state.q;
    system_.place_supports(state.time, q1_);
    for (std::size_t k = 0; k < q1_.size(); ++k) {
      const double x = system_.solids.mesh.x[k];
      if (system_.held[k]) q1_[k] = x + part * (q1_[k] - x);
    }
    if (contact_) {
      contact_->begin_at_end(state.q, 0);
      approach(state);
      meets_ = true;
    }
    report = newton(state, 0, contact_ ? meeting_rule : rule);
    meets_ = false;
    if (report.converged || contact_) break;
  }
  if (report.converged) state.q = q1_;
  return report;
}

}  // namespace tether::fem
