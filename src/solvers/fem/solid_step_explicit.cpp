// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "solvers/fem/solid_step.hpp"

// Central differences, whose masses are lumped.

namespace tether::fem {

void SolidStep::find_accelerations(std::span<const double> q, std::span<const double> v, double time,
                                   std::span<double> a) {
  system_.external_forces(time, outer_);
  std::fill(inner_.begin(), inner_.end(), 0.0);
  system_.elements->add_forces(StressAt::end, q, q, inner_);
  std::fill(damping_.begin(), damping_.end(), 0.0);
  if (system_.solids.beta != 0) K0_.multiply(v, damping_);
  const auto d = static_cast<std::size_t>(system_.dim());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double m = system_.lumped[k / d];
    damping_[k] = system_.solids.beta * damping_[k] + system_.solids.alpha * m * v[k];
    residual_[k] = outer_[k] - inner_[k] - damping_[k];
    a[k] = system_.held[k] ? 0 : residual_[k] / m;
  }
}

/// Central differences by half steps of the velocity; damping acts with the velocity of the half step.
void SolidStep::explicit_step(SolidState& state, double dt) {
  if (state.steps == 0) find_accelerations(state.q, state.v, state.time, state.a);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    state.v[k] += 0.5 * dt * state.a[k];
    q1_[k] = state.q[k] + dt * state.v[k];
  }
  system_.place_supports(state.time + dt, q1_);
  system_.external_forces(state.time, start_);
  find_accelerations(q1_, state.v, state.time + dt, state.a);
  double outside = system_.gravity_energy(q1_) - system_.gravity_energy(state.q);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k];
    outside += (0.5 * (start_[k] + outer_[k]) - (system_.held[k] ? residual_[k] : 0)) * way;
    state.damped += damping_[k] * way;
    state.v[k] = system_.held[k] ? way / dt : state.v[k] + 0.5 * dt * state.a[k];
    state.q[k] = q1_[k];
  }
  state.work += outside;
}

/// 2/omega, less where damping of the ratio xi acts with the velocity of half a step before (T. Belytschko, W. K. Liu,
/// B. Moran, Nonlinear Finite Elements for Continua and Structures, 2000, 6.2).
double SolidStep::longest_explicit_step(std::span<const double> q) const {
  const double omega = system_.elements->frequency_bound(q, system_.lumped);
  const double xi = (system_.solids.alpha / omega + system_.solids.beta * omega) / 2;
  return 2 / omega * (std::sqrt(1 + xi * xi) - xi);
}

}  // namespace tether::fem
