// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "physics/solids/step.hpp"

namespace tether::fem {

// Central differences, whose masses are lumped.

void SolidStep::find_accelerations(std::span<const double> q, std::span<const double> v, double time,
                                   std::span<double> a) {
  system_.external_forces(time, outer_);
  system_.add_pressures(time, StressAt::end, q, q, outer_);
  std::fill(inner_.begin(), inner_.end(), 0.0);
  system_.elements->add_forces(StressAt::end, q, q, inner_);
  std::fill(damping_.begin(), damping_.end(), 0.0);
  if (system_.solids.beta != 0) K0_.multiply(v, damping_);
  const auto d = static_cast<std::size_t>(system_.dim());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double m = system_.lumped[k / d];
    damping_[k] = system_.solids.beta * damping_[k] + system_.solids.alpha * m * v[k];
    residual_[k] = outer_[k] - inner_[k] - damping_[k];
    a[k] = residual_[k] / m;
  }
}

/// Central differences by half steps of the velocity; damping acts with the velocity of the half step. Supported nodes
/// go where they are led; what they would be accelerated by without, a, is what the supports hold against.
void SolidStep::explicit_step(SolidState& state, double dt) {
  if (state.steps == 0) find_accelerations(state.q, state.v, state.time, state.a);
  scratch_ = state.v, change_ = state.a;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    state.v[k] += 0.5 * dt * state.a[k];
    q1_[k] = state.q[k] + dt * state.v[k];
  }
  system_.place_supports(state.time + dt, q1_);
  system_.move_supports(state.time + dt, slope_width * dt, moved_);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    if (system_.held[k]) state.v[k] = (q1_[k] - state.q[k]) / dt;
  }
  system_.external_forces(state.time, start_);
  system_.add_pressures(state.time, StressAt::end, state.q, state.q, start_);
  find_accelerations(q1_, state.v, state.time + dt, state.a);
  double loads = system_.gravity_energy(q1_) - system_.gravity_energy(state.q);  // which start_ and outer_ have, too
  double supports = 0;
  const auto d = static_cast<std::size_t>(system_.dim());
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k], m = system_.lumped[k / d];
    loads += 0.5 * (start_[k] + outer_[k]) * way;
    if (system_.held[k])
      supports += 0.5 * m * (moved_[k] * moved_[k] - scratch_[k] * scratch_[k] - (change_[k] + state.a[k]) * way);
    state.damped += damping_[k] * way;
    state.hold[k] = system_.held[k] ? m * ((moved_[k] - scratch_[k]) / dt - state.a[k]) : 0;
    state.v[k] = system_.held[k] ? moved_[k] : state.v[k] + 0.5 * dt * state.a[k];
    state.q[k] = q1_[k];
  }
  state.of_loads += loads, state.of_supports += supports;
}

/// 2/omega, less where damping of the ratio xi acts with the velocity of half a step before (T. Belytschko, W. K. Liu,
/// B. Moran, Nonlinear Finite Elements for Continua and Structures, 2000, 6.2).
double SolidStep::longest_explicit_step(std::span<const double> q) const {
  const double omega = system_.elements->frequency_bound(q, system_.lumped);
  const double xi = (system_.solids.alpha / omega + system_.solids.beta * omega) / 2;
  return 2 / (omega * (std::hypot(1, xi) + xi));
}

}  // namespace tether::fem
