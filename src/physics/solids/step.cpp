// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/process.hpp"

namespace tether::fem {
namespace {

constexpr int most_backsteps = 10;
/// Where bodies meet, what is no nearer to balance than this is no equilibrium, however stiff the barrier: a body that
/// nothing holds.
constexpr double unbalanced = 1e-4;

double norm(const std::vector<double>& f) {
  double sum = 0;
  for (const double value : f) sum += value * value;
  return std::sqrt(sum);
}

double largest(const std::vector<double>& f) {
  double size = 0;
  for (const double value : f) size = std::max(size, std::abs(value));
  return size;
}

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

SolidStep::SolidStep(const SolidSystem& system)
    : system_(system),
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
      moved_(system.unknowns()) {
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
  if (contact_) return meet(state, dt, false);
  NewtonReport report;
  for (const NewtonRule& rule : newton_rules) {
    guess(state, dt);
    report = newton(state, dt, rule);
    state.newton_steps += static_cast<long long>(report.residuals.size()) - 1;
    if (report.converged) break;
  }
  if (report.converged) accept(state, dt);
  return report;
}

void SolidStep::begin(const SolidState& state, double dt) {
  find_dead_forces(state.time, dt);
  if (rule_.dynamic) system_.move_supports(state.time + dt, slope_width * dt, moved_);
}

/// Finds where Newton's method starts: with the velocity carried on, or as rigid bodies would move on, whichever leaves
/// the smaller residual.
void SolidStep::guess(const SolidState& state, double dt) {
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

/// M (v1 - v0)/dt + inner + damping - outer with v1 = 2 (q1 - q0)/dt - v0 (17), of supported nodes the velocity that
/// they are given, which that rule would let alternate about its mean for ever; its size over the largest of them,
/// infinite where that is not finite.
double SolidStep::find_residual(const SolidState& state, double dt) {
  std::fill(inertia_.begin(), inertia_.end(), 0.0);
  std::fill(damping_.begin(), damping_.end(), 0.0);
  if (rule_.dynamic) {
    add_damping(dt, state.q);
    for (std::size_t k = 0; k < q1_.size(); ++k) {
      scratch_[k] =
          system_.held[k] ? (moved_[k] - state.v[k]) / dt : 2 / dt * ((q1_[k] - state.q[k]) / dt - state.v[k]);
    }
    system_.multiply_mass(scratch_, inertia_);
  }
  double square = 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    residual_[k] = inertia_[k] + inner_[k] + damping_[k] - outer_[k];
    if (!system_.held[k]) square += residual_[k] * residual_[k];
  }
  scale_ = std::max({norm(inner_), norm(outer_), norm(inertia_)});
  if (!std::isfinite(scale_)) return std::numeric_limits<double>::infinity();
  return scale_ > 0 ? std::sqrt(square) / scale_ : 0;
}

NewtonReport SolidStep::newton(const SolidState& state, double dt, const NewtonRule& rule) {
  NewtonReport report;
  const Seconds from = seconds_now();
  find_forces(state, dt, false);
  report.residuals.push_back(find_residual(state, dt));
  sizes_.assign(1, report.residuals.back() * scale_);
  cost_.assembly += seconds_now() - from;
  for (int k = 0; k < rule.most_iterations; ++k) {
    report.converged = report.residuals.back() <= system_.solids.tolerance && supports_are_there();
    if (report.converged || leads_nowhere() || !correct(state, dt)) return report;
    report.residuals.push_back(
        residual_after_correction(state, dt, rule.most_shortenings, report.residuals.back() * scale_));
    sizes_.push_back(report.residuals.back() * scale_);
    report.converged = stagnates(report.residuals) && report.residuals.back() <= rounding() && supports_are_there() &&
                       (!meets_ || rule_.dynamic || report.residuals.back() <= unbalanced);
    if (report.converged) return report;
  }
  return report;
}

/// Returns whether corrections gain no more. While the residual is large they go on as long as it falls at all.
bool SolidStep::stagnates(const std::vector<double>& residuals) {
  constexpr double large = 1e-6;
  const double last = residuals.back(), before = residuals[residuals.size() - 2];
  return last > (last > large ? 0.9 : 0.5) * before;
}

/// Returns what rounding leaves of the residual over the largest force: the places are known to epsilon, and stiff
/// bodies whose forces nearly cancel answer it with the tangent's largest number.
double SolidStep::rounding() const {
  const double epsilon = std::numeric_limits<double>::epsilon(), n = static_cast<double>(q1_.size());
  return epsilon * std::sqrt(n) * stiffest_ * largest(q1_) / scale_;
}

/// A correction is halved while it turns an element inside out, and `shortenings` times at most where it leads away:
/// where neither the residual is smaller than `before` nor the next correction with the same tangent smaller than this
/// one (P. Deuflhard, Newton Methods for Nonlinear Problems, 2004, 3.3).
double SolidStep::residual_after_correction(const SolidState& state, double dt, int shortenings, double before) {
  const double length = norm(change_);
  for (int back = 0; back < most_backsteps; ++back) {
    find_forces(state, dt, true);
    const double size = find_residual(state, dt);
    if (std::isfinite(size) &&
        (back >= shortenings || size * scale_ <= before || (!meets_ && next_correction() <= length)))
      return size;
    for (std::size_t i = 0; i < q1_.size(); ++i) q1_[i] -= change_[i] *= 0.5;
  }
  return std::numeric_limits<double>::infinity();
}

/// Length of the correction that the tangent of this one would make next.
double SolidStep::next_correction() {
  for (std::size_t k = 0; k < scratch_.size(); ++k) scratch_[k] = system_.held[k] ? 0 : -residual_[k];
  solver_.solve(scratch_, scratch_);
  return norm(scratch_);
}

/// One correction of Newton's method, into change and q1. False where the tangent is singular.
bool SolidStep::correct(const SolidState& state, double dt) {
  const Seconds from = seconds_now();
  const Solids& solids = system_.solids;
  const double share = rule_.mean ? 0.5 : 1, inertia = rule_.dynamic ? 2 / (dt * dt) + solids.alpha / dt : 0;
  K_.set_zero();
  system_.elements->add_tangent(rule_.at, state.q, q1_, inertia / share, system_.pattern, K_);
  system_.add_pressure_tangent(state.time + (rule_.mean ? 1 : rule_.loads_at) * dt, rule_.at, state.q, q1_, -loaded_,
                               K_);
  stiffest_ = 0;
  for (double& value : K_.value) stiffest_ = std::max(stiffest_, value *= share);
  if (rule_.dynamic && solids.beta != 0) {
    for (std::size_t k = 0; k < K_.value.size(); ++k) K_.value[k] += solids.beta / dt * K0_.value[k];
  }
  SparseMatrix met;
  if (meets_) {
    met = contact_->with_slopes(K_, q1_, share);
    lead_supports(met);
    for (const double value : met.value) stiffest_ = std::max(stiffest_, std::abs(value));
  }
  SparseMatrix& K = meets_ ? met : K_;
  hold(K, system_.held, stiffest_);
  for (std::size_t k = 0; k < change_.size(); ++k) change_[k] = system_.held[k] ? 0 : -residual_[k];
  cost_.assembly += seconds_now() - from;
  const Seconds solve_from = seconds_now();
  const bool regular = solver_.factorise(K, system_.has_pressures() ? Definite::general : rule_.tangent);
  if (regular) solver_.solve(change_, change_);
  if (meets_ && regular) stop_before_surfaces();
  cost_.solve += seconds_now() - solve_from;
  cost_.factor_nonzeros = solver_.factor_nonzeros(), cost_.analysis = solver_.analysis();
  for (std::size_t k = 0; k < q1_.size(); ++k) q1_[k] += change_[k];
  return regular && std::isfinite(norm(change_));
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
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k], v1 = system_.held[k] ? moved_[k] : 2 * way / dt - state.v[k];
    const double inertial_way = 0.5 * dt * (state.v[k] + v1);
    loads += outer_[k] * way;
    if (system_.held[k]) supports += inertia_[k] * inertial_way + (inner_[k] + damping_[k] - outer_[k]) * way;
    state.damped += damping_[k] * way;
    state.v[k] = v1;
  }
  state.of_loads += loads, state.of_supports += supports;
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
