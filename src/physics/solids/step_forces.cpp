// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "physics/solids/step.hpp"

namespace tether::fem {

// The forces that an implicit step balances.

/// Finds the forces of loads and gravity that the shape does not change, where the integrator takes its stress.
void SolidStep::find_dead_forces(double time, double dt) {
  if (!rule_.mean) return system_.external_forces(time + rule_.loads_at * dt, dead_);
  system_.external_forces(time, inner_);
  system_.external_forces(time + dt, dead_);
  for (std::size_t k = 0; k < dead_.size(); ++k) dead_[k] = 0.5 * (dead_[k] + inner_[k]);
}

/// The same with pressures and what surroundings do, between the step's start and q1.
void SolidStep::find_outer_forces(const SolidState& state, double dt) {
  outer_ = dead_;
  if (system_.has_pressures()) add_pressures(state, dt);
  if (surroundings_) surroundings_->add_forces(q1_, outer_);
}

void SolidStep::add_pressures(const SolidState& state, double dt) {
  if (!rule_.mean)
    return system_.add_pressures(state.time + rule_.loads_at * dt, rule_.at, state.q, q1_, outer_, loaded_);
  std::fill(scratch_.begin(), scratch_.end(), 0.0);
  system_.add_pressures(state.time, StressAt::end, state.q, state.q, scratch_);
  system_.add_pressures(state.time + dt, StressAt::end, q1_, q1_, scratch_);
  for (std::size_t k = 0; k < outer_.size(); ++k) outer_[k] += 0.5 * scratch_[k];
}

/// (13) between the step's start and q1, of the trapezoidal rule the mean of both ends; and the outer forces.
void SolidStep::find_forces(const SolidState& state, double dt, bool again) {
  const Elements& elements = *system_.elements;
  find_outer_forces(state, dt);
  std::fill(inner_.begin(), inner_.end(), 0.0);
  if (rule_.mean && !again) {
    std::fill(start_.begin(), start_.end(), 0.0);
    elements.add_forces(StressAt::end, state.q, state.q, start_);
  }
  elements.add_forces(rule_.at, state.q, q1_, inner_);
  if (meets_) {
    std::fill(touching_.begin(), touching_.end(), 0.0);
    contact_->add_forces(q1_, touching_);
    for (std::size_t k = 0; k < inner_.size(); ++k) inner_[k] += touching_[k];
  }
  if (!rule_.mean) return;
  for (std::size_t k = 0; k < inner_.size(); ++k) inner_[k] = 0.5 * (inner_[k] + start_[k]);
}

/// alpha M + beta K of the reference shape, times the mean velocity of the step.
void SolidStep::add_damping(double dt, std::span<const double> q0) {
  const double alpha = system_.solids.alpha, beta = system_.solids.beta;
  std::fill(damping_.begin(), damping_.end(), 0.0);
  if (alpha == 0 && beta == 0) return;
  for (std::size_t k = 0; k < q1_.size(); ++k) scratch_[k] = (q1_[k] - q0[k]) / dt;
  if (beta != 0) K0_.multiply(scratch_, damping_);
  system_.multiply_mass(scratch_, residual_);
  for (std::size_t k = 0; k < q1_.size(); ++k) damping_[k] = beta * damping_[k] + alpha * residual_[k];
}

}  // namespace tether::fem
