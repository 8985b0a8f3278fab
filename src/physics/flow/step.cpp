// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/process.hpp"
#include "physics/flow/make_elements.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {
namespace {

constexpr int most_iterations = 25, most_iterations_of_contact = 100;

}  // namespace

FlowStep::FlowStep(const FlowUnknowns& unknowns, const Solids* solids, double gravity, Team& team)
    : unknowns_(unknowns),
      elements_(make_flow_elements(unknowns, team)),
      immersed_(solids ? std::make_unique<ImmersedSolids>(*solids, unknowns, gravity, team) : nullptr),
      forces_(immersed_ ? std::make_unique<ImmersedForces>(*immersed_, unknowns, *elements_, gravity) : nullptr),
      gravity_(gravity),
      pattern_(unknowns.first, clusters_of(unknowns.flow)),
      K_(pattern_.matrix()),
      linear_(unknowns, *elements_, K_, systems_of(unknowns.flow, solids != nullptr)),
      v1_(unknowns.velocity.size()),
      p_(unknowns.pressure.size()),
      f_(unknowns.velocity.size()),
      g_(unknowns.pressure.size()),
      change_(unknowns.count()) {
  viscosity_ = unknowns.flow.viscosity;
  for (const Holder& holder : holders_of(unknowns.flow))
    inflow_.push_back(holder.side >= 0 &&
                      unknowns.flow.sides[static_cast<std::size_t>(holder.side)].boundary == Boundary::inflow);
}

FlowReport FlowStep::advance(FlowState& state, const FlowStepTime& at) {
  begin(state, at);
  FlowReport report;
  report.residuals.push_back(find_residual(state));
  const bool meets = immersed_ && immersed_->meets();
  for (int k = 0; k < (meets ? most_iterations_of_contact : most_iterations); ++k) {
    report.converged = report.residuals.back() <= 1 && !(immersed_ && immersed_->gap_is_open());
    if (report.converged || !std::isfinite(report.residuals.back())) break;
    if (factors_.are_due() && !factorise(state)) break;
    if (!correct(state, report.residuals.back())) break;
    report.residuals.push_back(residual_behind_correction(state, report.residuals.back()));
    ++state.newton_steps;
  }
  if (report.converged) accept(state);
  return report;
}

/// A step so short that inertia and pressure are all there is, without viscosity, which longer steps than the fluid's
/// own time would feel: what is left of the velocities is free of divergence.
FlowReport FlowStep::start(FlowState& state, double dt) {
  constexpr double part = 1e-6;
  state.v_before = state.v;
  if (immersed_) immersed_->start(state, dt), forces_->start(state);
  if (unknowns_.flow.integrator == FlowIntegrator::steady) return {.converged = true, .residuals = {}, .cause = {}};
  FlowState after = state;
  FlowReport report = advance(after, {0, part * dt, 0, true});
  viscosity_ = unknowns_.flow.viscosity;
  state.v = state.v_before = after.v;
  if (immersed_) immersed_->start(state, dt);
  return report;
}

/// Sets what the step is about, and where Newton's method starts: the velocities of the start of the step before with
/// the prescribed ones of this one's end. So the mean velocity goes on as it was, whatever stiff solids make alternate
/// about it.
void FlowStep::begin(const FlowState& state, const FlowStepTime& at) {
  const Flow& flow = unknowns_.flow;
  const bool steady = flow.integrator == FlowIntegrator::steady;
  theta_ = flow.integrator == FlowIntegrator::midpoint && !at.sudden ? 0.5 : 1;
  rate_ = steady ? 0 : 1 / at.dt;
  loads_ = settles() ? (at.start + at.dt) / at.tmax : 1;
  viscosity_ = at.sudden ? 0 : flow.viscosity;
  if (steady && !immersed_) viscosity_ *= at.tmax / (at.start + at.dt);
  // With solids the step before is too far: the first correction by its factors would go the wrong way.
  factors_.begin_step(at.dt != state.linearised.dt || immersed_ != nullptr);
  first_scale_ = {};
  linear_.begin_step();
  at_ = at;
  v1_ = at.sudden || settles() ? state.v : state.v_before, p_ = state.p;
  unknowns_.prescribe(steady ? at.tmax : at.sudden ? at.start : at.start + at.dt, v1_);
  acceleration_ = elements_->accelerations(gravity_, steady ? at.tmax : at.start + theta_ * at.dt);
  if (loads_ != 1) scale_loads();
  unknowns_.copy_to_twins(v1_, 2);
  if (immersed_) begin_bodies(state);
}

void FlowStep::begin_bodies(const FlowState& state) {
  ImmersedMoment moment{at_.dt, theta_, rate_, viscosity_, at_.sudden, {}};
  if (settles()) moment.dt = at_.settling, moment.rest = LoadsAtRest{at_.tmax, loads_};
  immersed_->begin(state, moment);
  immersed_->move(state.v, v1_);
  settles() ? immersed_->open_gap() : immersed_->stop_guess();
  immersed_->end_correction();
}

/// Scales the loads of a steady flow with bodies that is on the way to the deck's.
void FlowStep::scale_loads() {
  for (std::size_t k = 0; k < v1_.size(); ++k) {
    if (unknowns_.velocity[k] < 0) v1_[k] *= loads_;
  }
  for (double& acceleration : acceleration_) acceleration *= loads_;
}

FlowMoment FlowStep::moment(std::span<const double> v0) const {
  return {v0,
          v1_,
          p_,
          theta_,
          rate_,
          viscosity_,
          acceleration_,
          unknowns_.flow.linearisation,
          unknowns_.flow.fluid_outside ? loads_ * gravity_ : 0};
}

/// (45), (46): the residuals at the unknowns over the largest forces and fluxes and the tolerance; and their size over
/// the forces and fluxes that the step began with, which shows what corrections are worth.
double FlowStep::find_residual(const FlowState& state) {
  const Seconds from = seconds_now();
  std::fill(f_.begin(), f_.end(), 0.0);
  std::fill(g_.begin(), g_.end(), 0.0);
  FlowScale scale = elements_->add_residual(moment(state.v), f_, g_);
  if (immersed_) {
    const FlowScale of_bodies = immersed_->add_forces(p_, f_, g_);
    scale.force = std::max(scale.force, of_bodies.force);
    scale.force_rounding = std::max(scale.force_rounding, of_bodies.force_rounding);
    scale.flux_rounding = std::max(scale.flux_rounding, of_bodies.flux_rounding);
  }
  double force = 0, flux = 0;
  for (std::size_t n = 0; n < p_.size(); ++n) {
    if (static_cast<std::size_t>(unknowns_.flow.twin[n]) != n) continue;
    for (std::size_t i = 0; i < 2; ++i) force += unknowns_.velocity[2 * n + i] < 0 ? 0 : f_[2 * n + i] * f_[2 * n + i];
    flux += unknowns_.pressure[n] < 0 ? 0 : g_[n] * g_[n];
  }
  cost_.assembly += seconds_now() - from;
  const double tolerance = unknowns_.flow.tolerance, tiny = std::numeric_limits<double>::min();
  if (first_scale_.force == 0) first_scale_ = {std::max(scale.force, tiny), std::max(scale.flux, tiny), 0, 0};
  size_ = std::max(std::sqrt(force) / first_scale_.force, std::sqrt(flux) / first_scale_.flux);
  return std::max(std::sqrt(force) / std::max({tolerance * scale.force, scale.force_rounding, tiny}),
                  std::sqrt(flux) / std::max({tolerance * scale.flux, scale.flux_rounding, tiny}));
}

/// Judges the factors by it. What kept factors have made worse is taken back.
double FlowStep::residual_behind_correction(const FlowState& state, double before) {
  const double size_before = size_, after = find_residual(state);
  if (factors_.lead_on(size_ / size_before, after)) return after;
  take_back_correction(state);
  return before;
}

void FlowStep::take_back_correction(const FlowState& state) {
  apply_correction(-corrected_part_);
  if (immersed_) {
    immersed_->move(state.v, v1_);
    immersed_->take_back_correction();
  }
  find_residual(state);
}

bool FlowStep::factorise(FlowState& state) {
  const Seconds from = seconds_now();
  if (immersed_) immersed_->linearise(), update_pattern();
  K_.set_zero();
  elements_->add_tangent(moment(state.v), pattern_, K_);
  if (immersed_) immersed_->add_tangent(unknowns_.flow.mesh.element_count(), pattern_, K_);
  cost_.assembly += seconds_now() - from;
  const Seconds solve_from = seconds_now();
  const bool done = linear_.factorise(K_, linear_.wants_scales() ? scales(state) : FlowScales{});
  cost_.solve += seconds_now() - solve_from;
  factors_.made(done, !linear_.by_krylov());
  if (!linear_.by_krylov()) state.linearised = {at_.start, at_.dt, state.v, v1_, p_, state.q, state.w, state.drift};
  return done;
}

FlowScales FlowStep::scales(const FlowState& state) const {
  return {2 * theta_ * viscosity_ + elements_->mean_lsic(moment(state.v)), unknowns_.flow.density * rate_};
}

/// One correction of v1 and p by the factors that there are, halved while it turns an element of the solids inside
/// out. False where it is no number or turns one inside out however small.
bool FlowStep::correct(FlowState& state, double residual) {
  constexpr int most_halvings_of_a_correction = 10;
  constexpr double least_volume = 0.05;
  const Seconds from = seconds_now();
  const bool possible = find_correction(residual) && apply_correction(1);
  corrected_part_ = 1;
  cost_.solve += seconds_now() - from;
  count(state);
  if (!immersed_ || !possible) return possible;
  immersed_->close_gap(1);
  immersed_->move(state.v, v1_);
  double part = immersed_->part_before_surfaces();
  if (part < 1) {
    apply_correction(part - 1);
    immersed_->close_gap(part);
    immersed_->move(state.v, v1_);
  }
  for (int k = 0; k < most_halvings_of_a_correction && !(immersed_->least_change_of_volume() > least_volume); ++k) {
    part *= 0.5;
    apply_correction(-part);
    immersed_->close_gap(part);
    immersed_->move(state.v, v1_);
  }
  corrected_part_ = part;
  immersed_->end_correction();
  if (immersed_->gap_is_open() || immersed_->press()) factors_.drop();
  return immersed_->least_change_of_volume() > least_volume;
}

/// GMRES takes off as much as Newton's method does in these steps, or what is left to do. Measured: 1e-2 to 1e-4 and
/// 0.1 to 0.6 of what is left make no difference of more than a tenth; 1e-1 takes twice the corrections.
bool FlowStep::find_correction(double residual) {
  constexpr double least = 1e-3, enough = 0.3;
  const auto& velocity = unknowns_.velocity;
  const auto& pressure = unknowns_.pressure;
  for (std::size_t k = 0; k < velocity.size(); ++k) {
    if (velocity[k] >= 0 && static_cast<std::size_t>(unknowns_.flow.twin[k / 2]) == k / 2)
      change_[static_cast<std::size_t>(velocity[k])] = -f_[k];
  }
  for (std::size_t n = 0; n < pressure.size(); ++n) {
    if (pressure[n] >= 0 && static_cast<std::size_t>(unknowns_.flow.twin[n]) == n)
      change_[static_cast<std::size_t>(pressure[n])] = -g_[n];
  }
  return linear_.solve(change_, change_, std::max(least, enough / residual));
}

void FlowStep::count(FlowState& state) {
  const LinearCounts counts = linear_.take_counts();
  state.factorisations += counts.factorisations;
  state.krylov_iterations += counts.iterations, state.krylov_failures += counts.failures;
  cost_.factor_nonzeros = linear_.factor_nonzeros(), cost_.analysis = linear_.analysis();
}

/// Adds a part of it. False where it is no number.
bool FlowStep::apply_correction(double part) {
  const auto& velocity = unknowns_.velocity;
  const auto& pressure = unknowns_.pressure;
  double sum = 0;
  for (const double change : change_) sum += change * change;
  for (std::size_t k = 0; k < velocity.size(); ++k) {
    if (velocity[k] >= 0) v1_[k] += part * change_[static_cast<std::size_t>(velocity[k])];
  }
  for (std::size_t n = 0; n < pressure.size(); ++n) {
    if (pressure[n] >= 0) p_[n] += part * change_[static_cast<std::size_t>(pressure[n])];
  }
  return std::isfinite(sum);
}

/// The solids' couplings change as they move from cell to cell.
void FlowStep::update_pattern() {
  Lists solid = immersed_->clusters();
  if (solid == solid_clusters_) return;
  Lists all = clusters_of(unknowns_.flow);
  for (std::size_t c = 0; c < solid.size(); ++c) all.add(solid[c]);
  solid_clusters_ = std::move(solid);
  pattern_ = ClusterPattern(unknowns_.first, std::move(all));
  K_ = pattern_.matrix();
}

void FlowStep::resume(const FlowState& state, double tmax) {
  const LinearisedAt& at = state.linearised;
  factors_.drop();
  if (at.dt == 0 || linear_.by_krylov() || settles()) return;
  FlowState then = state;
  then.time = at.time, then.v = then.v_before = at.v0, then.p = at.p, then.q = at.q0, then.w = at.w0;
  then.drift = at.drift;
  begin(then, {at.time, at.dt, tmax});
  v1_ = at.v1;
  if (immersed_) immersed_->move(at.v0, v1_);
  factorise(then);
  count(then);
}

}  // namespace tether::fem
