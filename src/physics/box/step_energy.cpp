// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "algebra/krylov.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// A step of fluid and solids that keeps the solids' energy: Newton's method over elasticity, contact and pressures
// together, with the cells of the step's start.

namespace {

/// The solids of a state, as their own step has them, with nothing exchanged yet.
fem::SolidState solids_of(const CoupledState& state) {
  fem::SolidState solids;
  solids.time = state.time;
  solids.q = state.q, solids.v = state.u;
  solids.contact = state.contact;
  return solids;
}

}  // namespace

/// A step in which a body swings is found again; so is one whose friction came first, which may send bodies back.
fem::NewtonReport CoupledStep::find_calm(CoupledState& state, double h, SolidRule rule, Solution& solution) {
  const CoupledState begun = state;
  const std::size_t said = messages_.size();
  if (rule == SolidRule::energy && state.calm_steps > 0) rule = SolidRule::calm;
  fem::NewtonReport end = find_with_friction(state, h, rule, solution);
  const bool may_swing = end.converged && rule == SolidRule::energy;
  const double heat = state.books.viscous - begun.books.viscous;
  const int body = may_swing ? swings_->found(begun, {solution.working, drag_, heat, h}) : -1;
  const bool swings = body >= 0 || (may_swing && state.unsettled_friction > begun.unsettled_friction);
  if (swings) {
    go_back(begun, state), messages_.resize(said);
    solution = {};
    end = find_with_friction(state, h, SolidRule::calm, solution);
    if (end.converged && body >= 0 && state.swings++ == 0) messages_.push_back(Swings::text(begun, body));
  }
  if (end.converged) Swings::keep(swings, solution.working, state);
  return end;
}

/// A step that was found before, with other friction, is found again from where it ended.
fem::NewtonReport CoupledStep::solve_by_energy(CoupledState& state, double h, SolidRule rule, bool again,
                                               Solution& solution) {
  const SystemCost before = system_.cost();
  fem::SolidState moved = solids_of(state);
  const auto advance = [&] {
    if (rule == SolidRule::euler) return solid_step_->advance_by_euler(moved, h);
    return rule == SolidRule::calm ? solid_step_->advance_calmly(moved, h) : solid_step_->advance(moved, h);
  };
  fem::NewtonReport report{false, {}};
  if (again) {
    around_.begin(fluid_of(state, h, solution), state.q, around_.pressures());
    solid_step_->start_where_it_ended(solution.left);
    report = advance();
    if (!report.converged) {
      const long long newton_steps = moved.newton_steps;
      moved = solids_of(state), moved.newton_steps = newton_steps;
    }
  }
  if (!report.converged) {
    solution.held = solids_.held;
    find_regions_of(state, h, solution);
    tell_of_unmeasured_volume(solution.regions, state);
    around_.begin(fluid_of(state, h, solution), state.q, solution.p);
    report = advance();
  }
  state.newton_steps += moved.newton_steps;
  state.iterations += system_.cost().iterations - before.iterations;
  if (report.converged) take_moved(moved, state, h, solution);
  return report;
}

/// Takes over what was found. Held nodes, too, sweep what takes them to where they are led.
void CoupledStep::take_moved(const fem::SolidState& moved, CoupledState& state, double h, Solution& solution) {
  const std::size_t count = state.q.size();
  solution.p = around_.pressures();
  solution.fluid_force.assign(count, 0.0), solution.friction.assign(count, 0.0);
  add_transposed_product(flow_->map().B, 1, solution.p, solution.fluid_force);
  const auto residual = solid_step_->residual(), touching = solid_step_->touching();
  solution.working.resize(count), solution.taken = solution.fluid_force, solution.wall_force.assign(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    solution.working[k] = (moved.q[k] - state.q[k]) / h;
    if (solution.held[k] == 0) solution.taken[k] += residual[k];
    solution.wall_force[k] = moved.hold[k] - touching[k];
  }
  solution.terms = solid_step_->terms_size(solution.working);
  book_moved(moved, solution, state);
  state.q = moved.q, state.u = moved.v, state.contact = moved.contact;
  finish(state, h, solution);
}

/// The work of all that acts on the solids from outside, on their way; loads are what is left of it.
void CoupledStep::book_moved(const fem::SolidState& moved, const Solution& solution, CoupledState& state) {
  EnergyBooks& books = state.books;
  std::vector<double> way(moved.q);
  for (std::size_t k = 0; k < way.size(); ++k) way[k] -= state.q[k];
  const double by_fluid = dot(way, solution.fluid_force), outside = dot(way, flow_->map().outside),
               weight = dot(way, flow_->map().film_weight), rubbed = dot(way, drag_),
               springs = solids_.spring_energy(state.q) - solids_.spring_energy(moved.q);
  books.coupling -= by_fluid;
  books.open_sides += outside, books.gravity += weight;
  books.projected -= rubbed, state.work += rubbed, state.last.gave += rubbed;
  books.loads += moved.of_loads + moved.of_supports - by_fluid - outside - weight - rubbed - springs;
  books.damped += moved.damped;
}

void CoupledStep::look_at_contact(CoupledState& state) {
  fem::SolidState solids = solids_of(state);
  solid_step_->look_at_contact(solids);
  state.contact = solids.contact;
}

}  // namespace tether::coupled
