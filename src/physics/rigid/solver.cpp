// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/solver.hpp"

#include <fmt/format.h>
#include <utility>

#include "base/diagnostics.hpp"
#include "physics/step_clock.hpp"
#include "results/summary_keys.hpp"

namespace tether::fem {

RigidSolver::RigidSolver(const Plan& plan)
    : plan_(plan),
      system_(*plan.scene.solids(), *plan.scene.rigid(), plan.scene.gravity),
      columns_(rigid_columns(system_.solids, system_.rigid)) {
  state_.body = system_.start();
}

void RigidSolver::advance(double until, long long most) {
  const double tmax = plan_.scene.clock.tmax;
  while (state_.time < until && state_.time < tmax && most-- > 0)
    step(step_before_end(plan_.step.deck_step, state_.time, tmax));
}

void RigidSolver::step(double dt) {
  clock_step(
      state_, dt, plan_.scene.clock.tmax, [this](double part) { return try_step(part); },
      [this](double part, const RigidReport& report) { stop(part, report); }, messages_);
}

/// The step (35) with the loads of its middle; leaves the body as it was where Newton's method does not converge.
RigidReport RigidSolver::try_step(double dt) {
  const RigidForces loads = system_.loads(state_.time + dt / 2);
  RigidForces all = loads;
  all.add(system_.weight);
  const RigidColumns q0 = state_.body.q;
  const auto one_step = system_.rigid.form == RigidForm::reduced ? rigid_reduced_step : rigid_constrained_step;
  RigidReport report = one_step(system_.body, all, dt, state_.body, {});
  state_.newton_steps += report.iterations;
  if (report.converged) {
    const RigidColumns way = state_.body.q - q0, middle = 0.5 * (state_.body.q + q0);
    state_.work += rigid_generalized_forces(loads, middle).cwiseProduct(way).sum();
  }
  return report;
}

void RigidSolver::stop(double dt, const RigidReport& report) const {
  const std::span<const double> residuals(report.residuals.data(), static_cast<std::size_t>(report.iterations) + 1);
  throw RunError(
      fmt::format(
          "t = {:.9g}, step {}: Newton's method does not converge in a step of {:.3g}, halved {} times; residuals "
          "over the terms of the balance{}; the body turns by {:.3g} in such a step: likely cause, a step too "
          "long for its turning, or loads too large",
          state_.time, state_.steps + 1, dt, most_halvings, residuals_text(residuals),
          dt * rigid_angular_velocity(system_.body, state_.body).norm()),
      Failure::does_not_converge);
}

RunCounts RigidSolver::counts() const {
  RunCounts counts;
  counts.steps = counts.point_steps = state_.steps;  // of one body, however fine its mesh
  counts.points = 1;
  counts.dt_min = state_.dt_min, counts.dt_last = state_.dt_last;
  return counts;
}

Snapshot RigidSolver::grid() const { return node_fields(state_, system_); }

std::vector<std::string> RigidSolver::take_messages() { return std::exchange(messages_, {}); }

SavedState RigidSolver::save() const {
  StateSaver saver;
  RigidRunState state = state_;
  exchange(saver, state);
  return saver.take();
}

void RigidSolver::restore(const SavedState& saved) {
  StateRestorer restorer(saved);
  exchange(restorer, state_);
}

Summary RigidSolver::more_summary() const {
  return {line_of("unknowns", system_.rigid.unknowns()), line_of("newton_iterations", state_.newton_steps),
          line_of("halvings", state_.halvings)};
}

}  // namespace tether::fem
