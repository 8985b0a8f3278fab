// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/krylov.hpp"
#include "physics/solids/step.hpp"

namespace tether::fem {

// A step of backward Euler for bodies that meet, where none that keeps the energy leads on. Without friction it makes
// an energy least (Li et al., ACM Trans. Graph. 39 (2020) 49, section 3): with tangents made positive definite, all
// corrections lead down.

NewtonReport SolidStep::advance_by_euler(SolidState& state, double dt) {
  const StepForces own = std::exchange(rule_, euler_forces);
  begin(state, dt);
  const NewtonReport report = meet(state, dt);
  if (report.converged) ++state.contact.doubts.euler_steps;
  rule_ = own;
  return report;
}

NewtonReport SolidStep::advance_calmly(SolidState& state, double dt) {
  const StepForces own = rule_;
  rule_.ends_as_mean = true;
  const NewtonReport report = advance(state, dt);
  rule_ = own;
  return report;
}

/// The forces along the correction [energy].
double SolidStep::along_correction() const {
  double along = 0;
  for (std::size_t k = 0; k < change_.size(); ++k) along += system_.held[k] ? 0 : change_[k] * residual_[k];
  return along;
}

/// A correction is halved while the forces push back along it by more than 0.9 of what they pulled with at its start
/// (H. Matthies and G. Strang, Int. J. Numer. Methods Engrg 14 (1979) 1613-1626): what is left over may well grow.
double SolidStep::residual_downhill(const SolidState& state, double dt, int shortenings, double before) {
  constexpr double most_back = 0.9;
  double pulled = -along_correction();
  for (int back = 0; back < shortenings; ++back, pulled *= 0.5) {
    find_forces(state, dt, true);
    const double size = find_residual(state, dt);
    if (std::isfinite(size) && (along_correction() <= most_back * pulled || left_over(size) <= before)) return size;
    for (std::size_t k = 0; k < q1_.size(); ++k) q1_[k] -= change_[k];
    shorten(0.5);
    go_on();
  }
  return std::numeric_limits<double>::infinity();
}

/// What the step takes from motion and elements, with q1 its end [energy].
double SolidStep::lost_by_ending_as_mean(const SolidState& state, double dt) const {
  const Elements& elements = *system_.elements;
  double lost = elements.strain_energy(state.q) - elements.strain_energy(q1_);
  for (std::size_t k = 0; k < q1_.size(); ++k) {
    const double way = q1_[k] - state.q[k];
    lost += (inner_[k] - touching_[k]) * way;
    if (!system_.held[k]) lost += inertia_[k] * (way - 0.5 * dt * (state.v[k] + way / dt));
  }
  return lost;
}

}  // namespace tether::fem
