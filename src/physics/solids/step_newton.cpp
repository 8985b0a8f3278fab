// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/krylov.hpp"
#include "base/process.hpp"
#include "physics/solids/step.hpp"

namespace tether::fem {

// Newton's method for the places at a step's end.

namespace {

constexpr int most_backsteps = 10;
/// Times the tolerance that does where corrections of bodies that meet gain no more.
constexpr double where_it_ends = 100;

double largest(const std::vector<double>& f) {
  double size = 0;
  for (const double value : f) size = std::max(size, std::abs(value));
  return size;
}

}  // namespace

/// M (v1 - v0)/dt + inner + damping - outer with v1 of velocity_at_end(), of supported nodes the velocity that they are
/// given, which (17) would let alternate about its mean for ever; its size over the largest of them, infinite where
/// that is not finite.
double SolidStep::find_residual(const SolidState& state, double dt) {
  std::fill(inertia_.begin(), inertia_.end(), 0.0);
  std::fill(damping_.begin(), damping_.end(), 0.0);
  if (rule_.dynamic) {
    add_damping(dt, state.q);
    for (std::size_t k = 0; k < q1_.size(); ++k) {
      scratch_[k] = system_.held[k] ? (moved_[k] - state.v[k]) / dt
                                    : end_per_mean() / dt * ((q1_[k] - state.q[k]) / dt - state.v[k]);
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
  sizes_.assign(1, left_over(report.residuals.back()));
  cost_.assembly += seconds_now() - from;
  for (int k = 0; k < rule.most_iterations; ++k) {
    const bool ends = leads_nowhere();
    report.converged = does_for_now() ||
                       (report.residuals.back() <= (ends ? where_it_ends : 1) * system_.solids.tolerance && is_whole());
    if (report.converged || ends || !correct(state, dt)) return report;
    report.residuals.push_back(residual_after_correction(state, dt, rule.most_shortenings, sizes_.back()));
    sizes_.push_back(left_over(report.residuals.back()));
    report.converged = stagnates(report.residuals) && is_rounding() && is_whole();
    if (report.converged && nothing_acts()) report.residuals.back() = 0;
    if (report.converged) return report;
  }
  return report;
}

/// Returns what a residual and the surroundings' own equations leave over [force].
double SolidStep::left_over(double residual) const {
  return residual * scale_ + (surroundings_ ? surroundings_->left_over(q1_) : 0);
}

/// Returns whether corrections left so little that a step which will be found again needs no more.
bool SolidStep::does_for_now() const {
  return !ended_.empty() && sizes_.size() > 1 && sizes_.back() <= left_ * sizes_.front();
}

/// Returns whether supports are where they lead, and what surrounds bodies has its due.
bool SolidStep::is_whole() const { return supports_are_there() && (!surroundings_ || surroundings_->settled(q1_)); }

double SolidStep::terms_size(std::span<const double> w) const {
  double size = 0;
  for (std::size_t k = 0; k < w.size(); ++k)
    size +=
        std::abs(w[k]) * (std::abs(inertia_[k]) + std::abs(inner_[k]) + std::abs(damping_[k]) + std::abs(outer_[k]));
  return size;
}

/// Returns whether corrections gain no more. While the residual is large they go on as long as it falls at all.
bool SolidStep::stagnates(const std::vector<double>& residuals) {
  constexpr double large = 1e-6;
  const double last = residuals.back(), before = residuals[residuals.size() - 2];
  return last > (last > large ? 0.9 : 0.5) * before;
}

/// Returns whether the residual is what rounding leaves: the places are known to epsilon, and stiff bodies whose forces
/// nearly cancel answer it with the tangent's largest number; each unknown with that of its own row, as a stiff contact
/// says nothing of a soft body's inside.
bool SolidStep::is_rounding() const {
  const double known = known_places();
  double square = 0, stiffest = 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    stiffest = std::max(stiffest, stiffness_[k]);
    if (system_.held[k]) continue;
    if (!(std::abs(residual_[k]) <= known * stiffness_[k])) return false;
    square += residual_[k] * residual_[k];
  }
  return std::sqrt(square) <= known * stiffest;
}

/// To what places are known, in sums over all of them [length].
double SolidStep::known_places() const {
  return std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(q1_.size())) * largest(q1_);
}

/// Returns whether all forces are no more than rounding: bodies that move as rigid ones, and that nothing loads.
bool SolidStep::nothing_acts() const {
  constexpr double few = 10;
  return scale_ <= few * known_places() * largest(stiffness_);
}

void SolidStep::note_stiffness(const SparseMatrix& K) {
  std::fill(stiffness_.begin(), stiffness_.end(), 0.0);
  for (std::size_t k = 0; k < K.value.size(); ++k) {
    double& most = stiffness_[static_cast<std::size_t>(K.row[k])];
    most = std::max(most, std::abs(K.value[k]));
  }
}

/// A correction is halved while it turns an element inside out, and `shortenings` times at most where it leads away:
/// where neither what is left over is less than `before` nor the next correction with the same tangent smaller than
/// this one (P. Deuflhard, Newton Methods for Nonlinear Problems, 2004, 3.3).
double SolidStep::residual_after_correction(const SolidState& state, double dt, int shortenings, double before) {
  if (rule_.euler) return residual_downhill(state, dt, shortenings, before);
  const double length = norm(change_);
  for (int back = 0; back < most_backsteps; ++back) {
    find_forces(state, dt, true);
    const double size = find_residual(state, dt);
    if (std::isfinite(size) && (back >= shortenings || left_over(size) <= before ||
                                (!meets_ && !surroundings_ && next_correction() <= length)))
      return size;
    for (std::size_t i = 0; i < q1_.size(); ++i) q1_[i] -= change_[i];
    shorten(0.5);
    go_on();
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
  const double share = rule_.mean ? 0.5 : 1;
  const double inertia = rule_.dynamic ? end_per_mean() / (dt * dt) + solids.alpha / dt : 0;
  K_.set_zero();
  if (rule_.euler) {
    system_.elements->add_stiffness(q1_, true, system_.pattern, K_);
    system_.add_mass(inertia, K_);
  } else {
    system_.elements->add_tangent(rule_.at, state.q, q1_, inertia / share, system_.pattern, K_);
    system_.add_pressure_tangent(state.time + (rule_.mean ? 1 : rule_.loads_at) * dt, rule_.at, state.q, q1_, -loaded_,
                                 K_);
  }
  for (double& value : K_.value) value *= share;
  note_stiffness(K_);
  if (rule_.dynamic && solids.beta != 0) {
    for (std::size_t k = 0; k < K_.value.size(); ++k) K_.value[k] += solids.beta / dt * K0_.value[k];
  }
  SparseMatrix met;
  if (meets_) {
    met = contact_->with_slopes(K_, q1_, share);
    lead_supports(met);
    note_stiffness(met);
  }
  cost_.assembly += seconds_now() - from;
  if (!solve(meets_ ? met : K_)) return false;
  go_on();
  return std::isfinite(norm(change_));
}

/// Finds the correction, into change, and shortens it where surfaces ask for that. False where the tangent is singular.
bool SolidStep::solve(SparseMatrix& K) {
  const Stopwatch watch(cost_.solve);
  hold(K, system_.held, largest(stiffness_));
  part_ = 1;
  for (std::size_t k = 0; k < change_.size(); ++k) change_[k] = system_.held[k] ? 0 : -residual_[k];
  if (surroundings_) {
    scratch_ = change_;
    for (std::size_t k = 0; k < change_.size(); ++k) change_[k] = meets_ && system_.held[k] ? led_[k] - q1_[k] : 0;
    if (!surroundings_->correct(K, scratch_, q1_, change_)) return false;
  } else {
    if (!solver_.factorise(K, system_.has_pressures() && !rule_.euler ? Definite::general : rule_.tangent))
      return false;
    solver_.solve(change_, change_);
    cost_.factor_nonzeros = solver_.factor_nonzeros(), cost_.analysis = solver_.analysis();
  }
  if (meets_) stop_before_surfaces();
  return true;
}

/// Takes the correction.
void SolidStep::go_on() {
  for (std::size_t k = 0; k < q1_.size(); ++k) q1_[k] += change_[k];
  if (surroundings_) surroundings_->go(part_);
}

void SolidStep::shorten(double part) {
  for (double& change : change_) change *= part;
  part_ *= part;
}

}  // namespace tether::fem
