// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/krylov.hpp"

namespace tether::fem {
namespace {

StepForces forces_of(Integrator integrator) {
  switch (integrator) {
    case Integrator::energy:
      return {.at = StressAt::gradient, .dynamic = true, .loads_at = 0.5, .tangent = Definite::general};
    case Integrator::midpoint:
      return {.at = StressAt::middle, .dynamic = true, .loads_at = 0.5};
    case Integrator::trapezoid:
      return {.at = StressAt::end, .dynamic = true, .mean = true};
    case Integrator::central:
    case Integrator::equilibrium:
      break;
  }
  return equilibrium_forces;
}

}  // namespace

SolidStep::SolidStep(const SolidSystem& system, Surroundings* surroundings)
    : system_(system),
      surroundings_(surroundings),
      rule_(forces_of(system.solids.integrator)),
      rigid_guess_(system.solids.mesh, system.weights, system.held),
      solver_(system.dim()),
      contact_(),
      K_(system.pattern.matrix()),
      q1_(system.unknowns()),
      start_(system.unknowns()),
      inner_(system.unknowns()),
      outer_(system.unknowns()),
      dead_(system.unknowns()),
      inertia_(system.unknowns()),
      damping_(system.unknowns()),
      residual_(system.unknowns()),
      change_(system.unknowns()),
      scratch_(system.unknowns()),
      touching_(system.unknowns(), 0.0),
      led_(system.unknowns()),
      moved_(system.unknowns()),
      stiffness_(system.unknowns(), 0.0) {
  if (system.solids.contact) contact_.emplace(system.solids, system.gravity(), system.team());
  if (system.solids.beta == 0) return;
  K0_ = system.pattern.matrix();
  system.elements->add_tangent(StressAt::end, system.solids.mesh.x, system.solids.mesh.x, 0, system.pattern, K0_);
}

NewtonReport SolidStep::advance(SolidState& state, double dt) {
  if (system_.solids.integrator == Integrator::central) {
    explicit_step(state, dt);
    return {std::isfinite(norm(state.v)), {}};
  }
  begin(state, dt);
  if (contact_) return meet(state, dt);
  NewtonReport report = find_end(state, dt);
  if (report.converged) accept(state, dt);
  return report;
}

/// Finds the places at the step's end where nothing meets.
NewtonReport SolidStep::find_end(SolidState& state, double dt) {
  NewtonReport report;
  for (const NewtonRule& rule : newton_rules) {
    guess(state, dt);
    report = newton(state, dt, rule);
    state.newton_steps += static_cast<long long>(report.residuals.size()) - 1;
    if (report.converged) break;
  }
  return report;
}

void SolidStep::begin(const SolidState& state, double dt) {
  if (!std::exchange(again_, false)) ended_.clear();
  find_dead_forces(state.time, dt);
  if (rule_.dynamic) system_.move_supports(state.time + dt, slope_width * dt, moved_);
}

/// Finds where Newton's method starts: with the velocity carried on, or as rigid bodies would move on, whichever leaves
/// the smaller residual.
void SolidStep::guess(const SolidState& state, double dt) {
  if (surroundings_) surroundings_->go_back();
  if (!ended_.empty()) {
    q1_ = ended_;
    return;
  }
  if (!rule_.dynamic) {
    q1_ = state.q;
    return system_.place_supports(state.time + dt, q1_);
  }
  rigid_guess_.find(state.q, state.v, dt, change_);
  system_.place_supports(state.time + dt, change_);
  q1_ = change_;
  find_forces(state, dt, false);
  const double rigid = find_residual(state, dt) * scale_;
  for (std::size_t k = 0; k < q1_.size(); ++k) q1_[k] = state.q[k] + dt * state.v[k];
  system_.place_supports(state.time + dt, q1_);
  find_forces(state, dt, true);
  if (!(find_residual(state, dt) * scale_ <= rigid)) q1_ = change_;
}

void SolidStep::accept(SolidState& state, double dt) {
  const double falling = system_.gravity_energy(q1_) - system_.gravity_energy(state.q);  // outer_ has it, too
  if (rule_.dynamic) {
    accept_motion(state, dt, falling);
  } else {
    accept_equilibrium(state);
    state.of_loads += falling;
  }
  note_hold(state);
  if (contact_) accept_contact(state);
  state.q = q1_;
}

/// Keeps what balances the unknowns that supports hold.
void SolidStep::note_hold(SolidState& state) const {
  state.hold = residual_;
  for (std::size_t k = 0; k < residual_.size(); ++k) {
    if (!system_.held[k]) state.hold[k] = 0;
  }
}

/// Work of loads, of supports, and of damping, and the new velocity. In (17) the mean velocity does the work; that of a
/// supported node need not be its way over the step, and its inertia works along the mean. `falling` is the change of
/// gravity's energy, which takes gravity out of the loads' work.
void SolidStep::accept_motion(SolidState& state, double dt, double falling) {
  double loads = falling, supports = 0;
  const double lost = rule_.ends_as_mean ? lost_by_ending_as_mean(state, dt) : 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k], v1 = system_.held[k] ? moved_[k] : velocity_at_end(way / dt, state.v[k]);
    const double inertial_way = 0.5 * dt * (state.v[k] + v1);
    loads += outer_[k] * way;
    if (system_.held[k]) supports += inertia_[k] * inertial_way + (inner_[k] + damping_[k] - outer_[k]) * way;
    state.damped += damping_[k] * way;
    state.v[k] = v1;
  }
  state.of_loads += loads, state.of_supports += supports, state.damped += lost;
}

/// From equilibrium to equilibrium loads and the forces of supports work with the mean of both ends: exactly where the
/// body answers linearly, and with the square of the step else.
void SolidStep::accept_equilibrium(SolidState& state) {
  system_.external_forces(state.time, start_);
  system_.add_pressures(state.time, StressAt::end, state.q, state.q, start_);
  std::fill(scratch_.begin(), scratch_.end(), 0.0);
  system_.elements->add_forces(StressAt::end, state.q, state.q, scratch_);
  double loads = 0, supports = 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k], load = 0.5 * (start_[k] + outer_[k]);
    loads += load * way;
    if (system_.held[k]) supports += (0.5 * (scratch_[k] + inner_[k]) - load) * way;
    state.v[k] = 0;
  }
  state.of_loads += loads, state.of_supports += supports;
}

}  // namespace tether::fem
