// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/solver.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "physics/solids/contact_report.hpp"
#include "physics/solids/fields.hpp"
#include "physics/step_clock.hpp"
#include "results/summary_keys.hpp"

namespace tether::fem {

FlowSolver::FlowSolver(const Plan& plan, int threads)
    : plan_(plan),
      flow_(*plan.scene.flow()),
      team_(threads),
      unknowns_(flow_),
      step_(unknowns_, plan.scene.solids(), plan.scene.gravity, team_),
      tracers_(flow_),
      fields_(flow_, step_, tracers_),
      light_bodies_(has_light_bodies()) {
  const Mesh& mesh = flow_.mesh;
  state_.v.resize(2 * mesh.node_count()), state_.p.resize(mesh.node_count());
  state_.force.resize(2 * mesh.node_count());
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const auto v = flow_.start.at(mesh.x[2 * n], mesh.x[2 * n + 1], 0);
    state_.v[2 * n] = v[0], state_.v[2 * n + 1] = v[1];
  }
  unknowns_.prescribe(0, state_.v);
  unknowns_.copy_to_twins(state_.v, 2);
  const FlowReport report = step_.start(state_, plan.step.deck_step);
  if (!report.converged)
    throw RunError(fmt::format("t = 0: no incompressible velocities are found for the start: residuals over the "
                               "tolerance's{}: likely cause, a velocity at the start that its sides contradict",
                               residuals_text(report.residuals)),
                   Failure::does_not_converge);
  tracers_.start(plan.scene.solids(), state_);
  if (step_.immersed() && flow_.integrator == FlowIntegrator::steady) steady_bodies_.emplace(step_, flow_);
  if (step_.immersed()) overlaps_.emplace(step_.immersed()->solids());
  if (step_.immersed()) doubts_.emplace(step_.immersed()->solids(), plan.scene.grid);
  if (step_.immersed()) start_looking_at_meshes();
  std::vector<std::string> told_by_the_deck;
  if (overlaps_) overlaps_->look(state_.q, 0, state_.overlap, told_by_the_deck);
}

/// How the bodies' meshes suit the fluid's at the start, of which the plan reports.
void FlowSolver::start_looking_at_meshes() {
  state_.doubts.spacing = step_.immersed()->carried().coarsest();
  thickness_.emplace(flow_.mesh, step_.immersed()->solids().mesh);
  state_.doubts.thinnest = thickness_->thinnest(state_.q).cells;
}

void FlowSolver::look_at_bodies() {
  if (!overlaps_) return;
  overlaps_->look(state_.q, state_.time, state_.overlap, messages_);
  doubts_->look_at_turns(state_.q, state_.time, state_.doubts, messages_);
  look_at_spacing();
  look_at_thickness();
}

/// Reports once what the plan says of the start, as the bodies move over other cells.
void FlowSolver::look_at_spacing() {
  const double now = step_.immersed()->carried().coarsest();
  if (now > coarse_spacing && state_.doubts.spacing <= coarse_spacing)
    messages_.push_back(fmt::format(
        "t = {:.6g}: the bodies have come where their nodes stand {:.3g} times as far apart as the fluid's: "
        "the fluid goes through between them and they move too little; elements half as long, or less, "
        "stop it",
        state_.time, now));
  state_.doubts.spacing = std::max(state_.doubts.spacing, now);
}

/// Does the same for cells across them.
void FlowSolver::look_at_thickness() {
  const ThinBody thin = thickness_->thinnest(state_.q);
  if (thin.region < 0) return;
  const int order = order_of(flow_.mesh.kind);
  const double least = least_cells_across(order);
  if (thin.cells < least && state_.doubts.thinnest >= least)
    messages_.push_back(fmt::format("t = {:.6g}: {} has come where it is {:.3g} cells of the fluid thick: {}",
                                    state_.time, step_.immersed()->solids().regions[at(thin.region)].name, thin.cells,
                                    thin_body_advice(order)));
  state_.doubts.thinnest = std::min(state_.doubts.thinnest, thin.cells);
}

FlowReport FlowSolver::advance_by(double part) {
  const FlowStepTime at{.start = state_.time, .dt = part, .tmax = plan_.scene.clock.tmax};
  FlowReport report = steady_bodies_ ? steady_bodies_->advance(state_, at) : step_.advance(state_, at);
  if (!report.residuals.empty()) state_.residual = flow_.tolerance * report.residuals.back();
  if (report.converged) tracers_.advance(team_, state_, part);
  return report;
}

void FlowSolver::advance(double until, long long most) {
  const double tmax = plan_.scene.clock.tmax;
  while (state_.time < until && state_.time < tmax && most-- > 0) {
    const long long failures = state_.krylov_failures;
    const ContactDoubts doubts = state_.contact.doubts;
    clock_step(
        state_, step_before_end(plan_.step.deck_step, state_.time, tmax), tmax,
        [&](double part) { return advance_by(part); },
        [this](double part, const FlowReport& report) { stop(part, report); }, messages_);
    tell_of_failures(failures);
    report_contact(doubts, state_.contact.doubts, state_.time, messages_);
    look_at_bodies();
    if (light_bodies_) check_kinetic_energy();
  }
}

/// Reports the first time that GMRES does not do.
void FlowSolver::tell_of_failures(long long before) {
  if (before > 0 || state_.krylov_failures == 0) return;
  messages_.push_back(
      fmt::format("t = {:.6g}: GMRES does not solve a system of the flow: the rest of the step is solved directly, as "
                  "later ones will be where that happens again; solver='direct' of $flow saves the attempts",
                  state_.time));
}

/// Returns whether bodies take mass from the fluid. One that supports move says nothing of it: the fluid does not go
/// with it.
bool FlowSolver::has_light_bodies() const {
  if (!step_.immersed()) return false;
  const Solids& solids = step_.immersed()->solids();
  const auto moves = [](const Support& support) { return support.displacement != Vec<3>{}; };
  return std::ranges::none_of(solids.supports, moves) &&
         std::ranges::any_of(solids.regions, [&](const auto& region) { return region.density < flow_.density; });
}

/// The mass that light bodies take from the fluid is theirs by their own functions: where these are coarser than the
/// fluid's it is more than some of its velocities have, and such velocities grow at no cost.
void FlowSolver::check_kinetic_energy() const {
  constexpr double rounding = 1e-6;
  const double fluid = step_.elements().kinetic_energy(state_.v);
  const double both = fluid + step_.immersed()->kinetic_energy(state_);
  if (both >= -rounding * fluid) return;
  throw RunError(
      fmt::format("t = {:.9g}, step {}: the kinetic energy is negative, {:.4g}: likely cause, bodies lighter than the "
                  "fluid whose elements are too coarse beside the fluid's: they take more mass from it than there is",
                  state_.time, state_.steps, both),
      Failure::contradicts_energy);
}

void FlowSolver::stop(double dt, const FlowReport& report) const {
  std::size_t worst = 0;
  double fastest = 0;
  for (std::size_t n = 0; n < state_.p.size(); ++n) {
    const double speed = std::hypot(state_.v[2 * n], state_.v[2 * n + 1]);
    if (speed > fastest) fastest = speed, worst = n;
  }
  const double* place = &flow_.mesh.x[2 * worst];
  const std::string there =
      fmt::format("node {} at ({:.6g}, {:.6g}) with {:.4g}", worst + 1, place[0], place[1], fastest);
  const std::string residuals = residuals_text(report.residuals);
  if (flow_.integrator == FlowIntegrator::steady) stop_steady(dt, report, there);
  throw RunError(
      fmt::format("t = {:.9g}, step {}: Newton's method does not converge in a step of {:.3g}, halved {} times; "
                  "residuals over the tolerance's{}; fastest is {}: likely cause, {}steps too long for the flow",
                  state_.time, state_.steps + 1, dt, most_halvings, residuals, there,
                  light_bodies_
                      ? "bodies lighter than the fluid, whose elements are to be no coarser than the fluid's and which "
                        "are to be stiff enough for the mass that they take from it, or "
                      : ""),
      Failure::does_not_converge);
}

/// Names the last Reynolds number, or with bodies the last part of the loads, that was reached.
void FlowSolver::stop_steady(double dt, const FlowReport& report, const std::string& fastest) const {
  const double tmax = plan_.scene.clock.tmax, density = flow_.density;
  const auto reached = [&](double time) {
    if (steady_bodies_) return fmt::format("{:.4g} of the deck's loads and prescribed velocities", time / tmax);
    const double mu = flow_.viscosity * tmax / time;
    return flow_.speed > 0 ? fmt::format("a Reynolds number of {:.6g}", density * flow_.speed * flow_.length / mu)
                           : fmt::format("a viscosity of {:.6g}", mu);
  };
  throw RunError(
      fmt::format(
          "no steady {} is found at {}: residuals over the tolerance's{}{}; the last one that converged has {}; "
          "fastest there is {}: likely cause, {}a mesh too coarse for it, steps of continuation too long, or no steady "
          "flow that is stable",
          steady_bodies_ ? "solution" : "flow", reached(state_.time + dt), residuals_text(report.residuals),
          report.cause, state_.time > 0 ? reached(state_.time) : std::string("none"), fastest,
          steady_bodies_ ? "bodies too soft for these loads, " : ""),
      Failure::does_not_converge);
}

RunCounts FlowSolver::counts() const {
  RunCounts counts;
  counts.steps = state_.steps;
  counts.points = flow_.mesh.node_count();
  counts.point_steps = state_.steps * static_cast<long long>(counts.points);
  counts.dt_min = state_.dt_min, counts.dt_last = state_.dt_last;
  return counts;
}

HistoryLayout FlowSolver::history_layout() const { return fields_.history_layout(); }

Record FlowSolver::record() const { return fields_.record(state_); }

Snapshot FlowSolver::grid() const { return fields_.node_fields(state_); }

std::vector<std::string> FlowSolver::take_messages() { return std::exchange(messages_, {}); }

std::string FlowSolver::worst_element() const {
  return step_.immersed() ? fem::worst_element(step_.immersed()->system(), state_.q) : std::string();
}

SavedState FlowSolver::save() const {
  StateSaver saver;
  FlowState state = state_;
  exchange(saver, state);
  return saver.take();
}

void FlowSolver::restore(const SavedState& saved) {
  StateRestorer restorer(saved);
  exchange(restorer, state_);
  messages_.clear();  // of the start: the run has them
  step_.resume(state_, plan_.scene.clock.tmax);
}

std::vector<CostPart> FlowSolver::cost_parts() const {
  const FlowCost& cost = step_.cost();
  return {{"assembly", cost.assembly}, {"solve", cost.solve}, {"analysis", cost.analysis}};
}

Summary FlowSolver::more_summary() const {
  Summary summary = cost_summary();
  if (!step_.immersed()) return summary;
  summary.push_back(line_of("nodes_inside", state_.overlap.most));
  summary.push_back(line_of("nodes_carried", step_.immersed()->carried().nodes().size()));
  summary.push_back(line_of("node_spacing", fmt::format("{:.6g}", state_.doubts.spacing)));
  summary.push_back(line_of("cells_across", fmt::format("{:.6g}", state_.doubts.thinnest)));
  add_contact_summary(step_.immersed()->solids(), state_.contact.doubts, summary);
  return summary;
}

Summary FlowSolver::cost_summary() const {
  const FlowCost& cost = step_.cost();
  Summary summary{line_of("unknowns", unknowns_.count()),
                  line_of("newton_iterations", state_.newton_steps),
                  line_of("factorisations", state_.factorisations),
                  line_of("halvings", state_.halvings),
                  line_of("factor_nonzeros", cost.factor_nonzeros),
                  line_of("linear_solver", step_.by_krylov() ? "krylov" : "direct"),
                  line_of("krylov_iterations", state_.krylov_iterations),
                  line_of("krylov_failures", state_.krylov_failures)};
  if (flow_.integrator == FlowIntegrator::steady) summary.push_back(line_of("steady_residual", state_.residual));
  if (steady_bodies_) summary.push_back(line_of("steady_rounds", state_.rounds));
  return summary;
}

}  // namespace tether::fem
