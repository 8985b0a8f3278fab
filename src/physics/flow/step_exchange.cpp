// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/step.hpp"

namespace tether::fem {

// The end of a step: the new state, and what was exchanged on the way to it.

/// The new state, and what was exchanged over the step. A steady flow exchanges over no time.
void FlowStep::accept(FlowState& state) {
  for (std::size_t k = 0; k < v1_.size(); ++k) state.force[k] = unknowns_.velocity[k] < 0 ? f_[k] : 0;
  if (rate_ > 0) add_exchange(state);
  if (forces_) forces_->record(moment(state.v), state);
  state.v_before = state.v;
  state.v = v1_, state.p = p_;
  if (immersed_) immersed_->accept(state);
}

/// Forces of walls and inflows work on the fluid with the velocity of the middle. The convective term takes what open
/// sides and inflows carry out; what else it takes, rho/2 |v|^2 div v, the method has lost. Backward Euler loses the
/// kinetic energy of the change of velocity.
void FlowStep::add_exchange(FlowState& state) {
  const FlowPower power = elements_->power(moment(state.v));
  double of_walls = 0, of_inflows = 0;
  for (std::size_t k = 0; k < v1_.size(); ++k) {
    if (unknowns_.velocity[k] >= 0) continue;
    (inflow_[k / 2] ? of_inflows : of_walls) += f_[k] * ((1 - theta_) * state.v[k] + theta_ * v1_[k]);
  }
  const double dt = at_.dt;
  FlowExchange& all = state.exchanged;
  all.walls += dt * of_walls;
  all.inflows += dt * (of_inflows - power.carried_by_inflows);
  all.open += dt * (power.open_traction - power.carried_by_open);
  all.body_forces += dt * power.body;
  all.viscosity += dt * power.dissipated;
  all.stabilised += dt * power.stabilised;
  if (immersed_) all.immersed += dt * power.expansion;  // which the bodies' own, in accept(), all but undoes
  all.advected += dt * (power.convected - power.carried_by_open - power.carried_by_inflows);
  if (theta_ == 0.5) return;
  std::vector<double> change(v1_.size());
  for (std::size_t k = 0; k < change.size(); ++k) change[k] = v1_[k] - state.v[k];
  all.stepped += (2 * theta_ - 1) * elements_->kinetic_energy(change);
}

}  // namespace tether::fem
