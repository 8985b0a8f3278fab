// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "physics/solids/step.hpp"

namespace tether::fem {
// A step of bodies that meet. Places on the way never let a surface through another: the first guess and each
// correction stop before the next one.

NewtonReport SolidStep::meet(SolidState& state, double dt) {
  meets_ = false;
  rule_.at == StressAt::end ? contact_->begin_at_end(state.q, dt, rule_.euler) : contact_->begin(state.q, dt);
  guess(state, dt);
  NewtonReport report;
  if (goes_free(state)) {
    report = find_end(state, dt);
    if (report.converged && goes_free(state)) {
      std::fill(touching_.begin(), touching_.end(), 0.0);
      accept(state, dt);
      return report;
    }
    guess(state, dt);
  }
  meets_ = true;
  approach(state);
  report = newton(state, dt, rule_.euler ? euler_rule : meeting_rule);
  state.newton_steps += static_cast<long long>(report.residuals.size()) - 1;
  if (!report.converged && contact_->rubs()) report = meet_by_easing(state, dt);
  meets_ = false;
  if (report.converged) accept(state, dt);
  return report;
}

/// Returns whether nothing meets anything, neither before nor at q1, nor on the straight way: slender bodies find their
/// places through larger residuals than contact bears.
bool SolidStep::goes_free(const SolidState& state) {
  if (contact_->presses(state.q) || !(system_.elements->shape(q1_).least_seen > 0)) return false;
  for (std::size_t k = 0; k < q1_.size(); ++k) change_[k] = q1_[k] - state.q[k];
  return contact_->part_of_guess(state.q, change_) == 1 && !contact_->presses(q1_);
}

/// Lets friction come up over ways that are longer at first, from each solution to the next. Where the last ones lead
/// nowhere, a way that is up to a hundred times as long does for this step, which is counted.
NewtonReport SolidStep::meet_by_easing(SolidState& state, double dt) {
  constexpr double first = 1e5, shorter = 0.3, enough = 100;
  q1_ = led_;
  if (surroundings_) surroundings_->go_back();
  approach(state);
  NewtonReport report, good;
  std::vector<double> at;
  double eased = first;
  for (double ease = first; ease > 0; ease = ease > 1 ? std::max(1.0, shorter * ease) : 0) {
    contact_->ease_friction(ease);
    report = newton(state, dt, meeting_rule);
    state.newton_steps += static_cast<long long>(report.residuals.size()) - 1;
    if (!report.converged) break;
    at = q1_;
    if (surroundings_) surroundings_->keep();
    good = report;
    if (ease <= 1) return report;
    eased = ease;
  }
  if (!good.converged || eased > enough) return report;
  q1_ = at;
  if (surroundings_) surroundings_->go_back();
  contact_->ease_friction(eased);
  find_forces(state, dt, true);
  find_residual(state, dt);
  ++state.contact.doubts.eased;
  return good;
}

/// Goes from the start to the first guess as far as surfaces let nodes go. Corrections lead on supports that are not
/// there yet.
void SolidStep::approach(const SolidState& state) {
  led_ = q1_;
  for (std::size_t k = 0; k < q1_.size(); ++k) change_[k] = q1_[k] - state.q[k];
  q1_ = state.q;
  shorten_correction(contact_->part_of_guess(q1_, change_));
  for (std::size_t k = 0; k < q1_.size(); ++k)
    q1_[k] = change_[k] == led_[k] - state.q[k] ? led_[k] : q1_[k] + change_[k];
}

/// Returns whether many corrections of bodies that meet have taken little of the residual.
bool SolidStep::leads_nowhere() const {
  constexpr std::size_t many = 10;
  constexpr double little = 0.7;
  return meets_ && !rule_.euler && sizes_.size() > many && !(sizes_.back() < little * sizes_[sizes_.size() - 1 - many]);
}

bool SolidStep::supports_are_there() const {
  if (!meets_) return true;
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    if (system_.held[k] && q1_[k] != led_[k]) return false;
  }
  return true;
}

/// Adds to the residual what the way of supports that are not there yet does to it by the tangent K.
void SolidStep::lead_supports(const SparseMatrix& K) {
  if (supports_are_there()) return;
  for (std::size_t k = 0; k < q1_.size(); ++k) change_[k] = system_.held[k] ? led_[k] - q1_[k] : 0;
  K.multiply(change_, scratch_);
  for (std::size_t k = 0; k < q1_.size(); ++k) residual_[k] += scratch_[k];
}

/// Supports that are not there yet go with a correction, which goes as far as it can.
void SolidStep::stop_before_surfaces() {
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    if (system_.held[k]) change_[k] = led_[k] - q1_[k];
  }
  shorten_correction(contact_->part_of_correction(q1_, change_));
}

/// Shortens a correction to the part before surfaces, and to where no element loses more than four fifths of its least
/// volume: beyond a volume of 0 laws see the mirrored shape.
void SolidStep::shorten_correction(double part) {
  constexpr double most_lost = 0.2;
  constexpr int most_halvings = 30;
  if (part < 1) shorten(part);
  const double least = most_lost * std::min(1.0, system_.elements->shape(q1_).least_seen);
  for (int k = 0; k < most_halvings; ++k) {
    for (std::size_t i = 0; i < q1_.size(); ++i) scratch_[i] = q1_[i] + change_[i];
    if (system_.elements->shape(scratch_).least_seen >= least) {
      return;
    }
    shorten(0.5);
  }
}

void SolidStep::look_at_contact(SolidState& state) {
  if (!contact_) return;
  contact_->begin_at_end(state.q, 0);
  state.contact.last = contact_->numbers(state.q);
}

/// Takes note of what contact stores, and of what friction and damped contact took on the way.
void SolidStep::accept_contact(SolidState& state) {
  double work = 0;
  for (std::size_t k = 0; k < q1_.size(); ++k) work += touching_[k] * (q1_[k] - state.q[k]);
  state.contact.note(contact_->numbers(q1_), work, system_.solids.contact->gap);
}

}  // namespace tether::fem
