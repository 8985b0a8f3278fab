// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/solver.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics.hpp"
#include "physics/solids/contact_report.hpp"
#include "physics/solids/fields.hpp"
#include "physics/step_clock.hpp"
#include "results/summary_keys.hpp"

namespace tether::fem {
SolidSolver::SolidSolver(const Plan& plan, int threads)
    : plan_(plan),
      team_(threads),
      system_(*plan.scene.solids(), plan.scene.gravity, team_),
      step_(system_),
      columns_(solid_columns(system_.solids)),
      rounding_energy_(rounding_energy(system_.solids)),
      overlaps_(system_.solids),
      doubts_(system_.solids, plan.scene.grid) {
  state_.q = system_.solids.mesh.x;
  state_.v = first_velocities(system_), state_.hold.assign(state_.q.size(), 0.0);
  if (system_.solids.integrator == Integrator::central) state_.a.assign(state_.q.size(), 0.0);
  system_.place_supports(0, state_.q);
  if (system_.solids.integrator != Integrator::equilibrium)
    system_.move_supports(0, slope_width * plan.scene.clock.tstep, state_.v);
  if (system_.solids.from_equilibrium) start();
  step_.look_at_contact(state_);
  tell_of_short_steps();
  std::vector<std::string> told_by_the_deck;
  overlaps_.look(state_.q, 0, state_.overlap, told_by_the_deck);
}

/// As plan and run do of points and bars, whose limit is known without the elements.
void SolidSolver::tell_of_short_steps() {
  const Clock& clock = plan_.scene.clock;
  if (system_.solids.integrator != Integrator::central || clock.cfl == 0) return;
  const double limit = step_.longest_explicit_step(state_.q), dt = clock.cfl * limit;
  if (!(dt < plan_.step.deck_step * (1 - 1e-9))) return;
  messages_.push_back(fmt::format(
      "the deck's step {:.4g} is {:#.3g} times the limit 2/omega = {:.4g} of central differences: steps are "
      "limited to {:.4g}, cfl = {:.3g} of it, {:.0f} in place of {:.0f}",
      plan_.step.deck_step, plan_.step.deck_step / limit, limit, dt, clock.cfl, std::ceil(clock.tmax / dt),
      std::ceil(clock.tmax / plan_.step.deck_step)));
}

void SolidSolver::start() {
  const NewtonReport report = step_.settle(state_);
  state_.newton_steps += static_cast<long long>(report.residuals.size()) - 1;
  if (report.converged) return;
  throw RunError(fmt::format("t = 0: no equilibrium with the loads of the start is found: residuals over the largest "
                             "force{}: likely cause, loads too large for one step",
                             residuals_text(report.residuals)),
                 Failure::does_not_converge);
}

void SolidSolver::advance(double until, long long most) {
  while (state_.time < until && state_.time < plan_.scene.clock.tmax && most-- > 0) {
    const std::vector<double> before = implicit() ? state_.v : std::vector<double>();
    const ContactDoubts doubts = state_.contact.doubts;
    step(next_step());
    if (implicit())
      BodyDoubts::look_at_swings(before, state_.v, system_.lumped, rounding_energy_, state_.time, state_.doubts,
                                 messages_);
    report_contact(doubts, state_.contact.doubts, state_.time, messages_);
    look_at_bodies();
  }
}

/// Explicit steps are many and short: bodies do not go far in some of them.
void SolidSolver::look_at_bodies() {
  constexpr long long explicit_steps = 16;
  if (system_.solids.integrator == Integrator::central && state_.steps % explicit_steps != 0) return;
  overlaps_.look(state_.q, state_.time, state_.overlap, messages_);
  doubts_.look(state_.q, state_.time, state_.doubts, messages_);
}

double SolidSolver::next_step() const {
  double dt = plan_.step.deck_step;
  if (system_.solids.integrator == Integrator::central && plan_.scene.clock.cfl > 0)
    dt = std::min(dt, plan_.scene.clock.cfl * step_.longest_explicit_step(state_.q));
  return step_before_end(dt, state_.time, plan_.scene.clock.tmax);
}

void SolidSolver::step(double dt) {
  clock_step(
      state_, dt, plan_.scene.clock.tmax, [this](double part) { return advanced(part); },
      [this](double part, const NewtonReport& report) { refuse_step(state_, system_.solids, part, report); },
      messages_);
}

/// Explicit steps have nothing to be halved for. A step that cannot be halved again takes backward Euler.
NewtonReport SolidSolver::advanced(double dt) {
  if (state_.time + dt <= state_.time) lose(dt);
  NewtonReport report = step_.advance(state_, dt);
  if (!report.converged && step_.can_take_euler() && dt <= shortest_halved * plan_.step.deck_step)
    report = step_.advance_by_euler(state_, dt);
  if (!report.converged && system_.solids.integrator == Integrator::central) lose(dt);
  if (!report.residuals.empty()) state_.residual = report.residuals.back();
  if (report.converged && system_.solids.integrator == Integrator::equilibrium)
    BodyDoubts::look_at_balance(state_.residual, state_.q, system_.solids.mesh.x, state_.time + dt, state_.doubts,
                                messages_);
  return report;
}

/// An explicit step that ran away, or is lost in the time, leaves nothing to go on with.
void SolidSolver::lose(double dt) const {
  std::size_t k = 0;
  while (k + 1 < state_.v.size() && std::isfinite(state_.v[k])) ++k;
  const auto d = static_cast<std::size_t>(system_.dim());
  const double* place = &system_.solids.mesh.x[k / d * d];
  if (state_.time + dt <= state_.time)
    throw RunError(
        fmt::format("t = {:.9g}, step {}: steps of {:.3g} are lost in the time: likely cause, cfl or damping "
                    "that leaves central differences no step",
                    state_.time, state_.steps + 1, dt));
  throw RunError(
      fmt::format("t = {:.9g}, step {}: node {}, at the start at ({:.6g}, {:.6g}), has no velocity any more: "
                  "likely cause, steps of {:.3g} above the limit {:.3g} of central differences at the start",
                  state_.time, state_.steps + 1, k / d + 1, place[0], place[1], dt,
                  step_.longest_explicit_step(system_.solids.mesh.x)));
}

RunCounts SolidSolver::counts() const {
  RunCounts counts;
  counts.steps = state_.steps;
  counts.points = system_.lumped.size();
  counts.point_steps = state_.steps * static_cast<long long>(counts.points);
  counts.dt_min = state_.dt_min, counts.dt_last = state_.dt_last;
  return counts;
}

Snapshot SolidSolver::grid() const { return node_fields(state_, system_); }

std::vector<std::string> SolidSolver::take_messages() { return std::exchange(messages_, {}); }

SavedState SolidSolver::save() const {
  StateSaver saver;
  SolidState state = state_;
  exchange(saver, state);
  return saver.take();
}

void SolidSolver::restore(const SavedState& saved) {
  StateRestorer restorer(saved);
  exchange(restorer, state_);
  messages_.clear();  // of the start: the run has them
}

std::vector<CostPart> SolidSolver::cost_parts() const {
  const SolidCost& cost = step_.cost();
  return {{"assembly", cost.assembly}, {"solve", cost.solve}, {"analysis", cost.analysis}};
}

Summary SolidSolver::more_summary() const {
  const SolidCost& cost = step_.cost();
  const auto free = std::count(system_.held.begin(), system_.held.end(), 0);
  Summary summary{line_of("unknowns", free), line_of("newton_iterations", state_.newton_steps),
                  line_of("halvings", state_.halvings), line_of("nodes_inside", state_.overlap.most),
                  line_of("factor_nonzeros", cost.factor_nonzeros)};
  if (system_.solids.integrator == Integrator::equilibrium)
    summary.push_back(line_of("equilibrium_residual", state_.residual));
  add_contact_summary(system_.solids, state_.contact.doubts, summary);
  return summary;
}

}  // namespace tether::fem
