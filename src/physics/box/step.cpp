// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/liquid_flow.hpp"
#include "physics/box/mesh/mesh_flow.hpp"

namespace tether::coupled {
namespace {

std::unique_ptr<Flow> flow_of(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface,
                              const SolidEquations& solids, CoupledSystem& system, Team& team) {
  if (scene.mesh) return std::make_unique<MeshFlow>(scene, gravity, surface, solids.system.unknowns(), team);
  if (scene.liquid) return std::make_unique<LiquidFlow>(scene, gravity, surface, solids, system, team);
  return std::make_unique<GridFlow>(scene, gravity, surface, solids, team);
}

}  // namespace

CoupledStep::CoupledStep(const Scene& scene, const Solids& solids, Team& team)
    : scene_(scene),
      coupled_(*scene.coupled()),
      surface_(surface_of(solids.mesh)),
      solids_(coupled_, solids, gravity_of(scene), team),
      contact_(coupled_, surface_),
      system_(coupled_, team),
      flow_(flow_of(coupled_, gravity_of(scene), surface_, solids_, system_, team)),
      around_(solids_, system_, surface_, *flow_, team),
      drag_(solids_.system.unknowns(), 0.0),
      first_volumes_(enclosed_volumes(surface_, solids.mesh.x)) {
  if (coupled_.viscosity > 0) passes_.emplace(coupled_, gravity_of(scene), solids_, *flow_, *flow_->friction());
  if (tether::keeps_energy(coupled_, solids, scene.clock.tstep)) solid_step_.emplace(solids_.system, &around_);
  if (passes_ && solid_step_) swings_.emplace(solids_.system);
}

void CoupledStep::resume(CoupledState& state) {
  flow_->place(state);
  system_.keep_orders(state.orders);
}

/// One step of the paper, 3.1 to 3.3, or one whose solids keep their energy.
fem::NewtonReport CoupledStep::advance(CoupledState& state, double h, bool by_euler) {
  const std::vector<double> q0 = state.q;
  Solution solution;
  flow_->begin(state, h);  // (1) without pressure: v*
  const SolidRule rule = by_euler ? SolidRule::euler : solid_step_ ? SolidRule::energy : SolidRule::linear;
  const fem::NewtonReport end = swings_   ? find_calm(state, h, rule, solution)
                                : passes_ ? find_with_friction(state, h, rule, solution)
                                          : find_step(state, h, rule, solution);
  solution.L = {}, system_.let_go();  // where solids are placed next, others take their room
  if (!end.converged) return end;
  note_unswept(q0, solution, state);
  check(state);
  state.last.cfl = flow_->cells_crossed(state.v, h);
  state.cfl_largest = std::max(state.cfl_largest, state.last.cfl);
  flow_->end(change_, state, h);
  note_bodies_that_left(state.time + h, state);
  return end;
}

fem::NewtonReport CoupledStep::find_with_friction(CoupledState& state, double h, SolidRule rule, Solution& solution) {
  const auto find = [&](CoupledState& of_pass, double left) {
    solution.left = left;
    return find_step(of_pass, h, rule, solution);
  };
  NodeInertia nodes;
  if (!state.driven_nodes.empty()) nodes = {solids_.inertia(rule, state.q, h), solids_.held};
  return passes_->find({.find = find,
                        .change = change_,
                        .working = solution.working,
                        .linear = rule == SolidRule::linear,
                        .nodes = std::move(nodes),
                        .drag = drag_},
                       h, state, messages_);
}

/// Finds velocities and pressures, and moves the solids. A solution that was found before, from the same start with
/// other friction, is what the next one begins with: its matrices are the same.
fem::NewtonReport CoupledStep::find_step(CoupledState& state, double h, SolidRule rule, Solution& solution) {
  change_ = state.v;
  flow_->add_forces(state.smoke, h, state.v);
  const bool again = solution.L.n > 0;
  if (!again) solution = begin_solution(state, h);
  if (solid_step_) return solve_by_energy(state, h, rule, again, solution);
  const std::vector<double> q0 = state.q, u0 = state.u;
  if (!again) solids_.assemble(state.q, state.u, state.time, h);  // (4): A, b
  solve(state, h, again, solution);                               // (7), (8)
  move_solids(state, u0, h);                                      // (5)
  book_solids(q0, u0, solution, state, h);
  note_turning(state, h);
  return {true, {}};
}

/// Begins with the pressures of the step before.
CoupledStep::Solution CoupledStep::begin_solution(const CoupledState& state, double h) const {
  Solution solution;
  solution.p = flow_->guess_of(state);
  solution.L = flow_->pressure_matrix(h / coupled_.density);
  return solution;
}

/// Contact decides which velocities are held; as these change, the equations are solved again.
void CoupledStep::solve(CoupledState& state, double h, bool again, Solution& solution) {
  const std::vector<double> u0 = state.u;
  const SystemCost before = system_.cost();
  std::vector<double> change(u0.size()), inertia(u0.size());
  contact_.begin(state.q, u0, h, state.touches);
  bool settled = false;
  for (int k = 0; k < most_contact_solutions && !settled; ++k) {
    if (k > 0) ++state.contact_solutions;
    std::vector<std::uint8_t> held = solids_.held;
    for (std::size_t i = 0; i < state.u.size(); ++i) state.u[i] = solids_.held[i] != 0 ? 0 : u0[i];
    contact_.hold(state.touches, held, state.u);
    solids_.system.move_supports(state.time + h, fem::slope_width * h, state.u);
    solution.same_matrices = (again || k > 0) && held == solution.held;
    solution.held = std::move(held);
    if (!solution.same_matrices) find_regions_of(state, h, solution);
    if (k == 0) tell_of_unmeasured_volume(solution.regions, state);
    solve_once(fluid_of(state, h, solution), state, solution);
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = state.u[i] - u0[i];
    solids_.system.multiply_mass(change, inertia);
    settled = !contact_.changed(state.u, solution.wall_force, inertia, state.touches);
  }
  if (!settled) tell_of_unsettled_contact(state);
  state.iterations += system_.cost().iterations - before.iterations;
  state.lu_solutions += system_.cost().lu_solves - before.lu_solves;
  note_powers(state, solution);
  finish(state, h, solution);
}

/// Gives the fluid what the pressures make of it, (8), and keeps what was found.
void CoupledStep::finish(CoupledState& state, double h, Solution& solution) {
  const FaceValues free = state.v;
  flow_->add_pressure(solution.p, h / coupled_.density, state.v);
  account(free, solution, state, h);
  flow_->keep_pressures(solution.p, state);
  const CouplingMap& map = flow_->map();
  for (std::size_t k = 0; k < solution.friction.size(); ++k) {
    state.fluid_force[k] = solution.fluid_force[k] + map.outside[k] + map.film_weight[k] + drag_[k];
    state.wall_force[k] = solution.wall_force[k] + solution.friction[k];
  }
}

/// Finds, with the volume term, what each cell of a region takes of it.
void CoupledStep::find_regions_of(const CoupledState& state, double h, Solution& solution) const {
  Regions& regions = solution.regions;
  regions =
      regions_of(flow_->regions(), flow_->map(), enclosed_volumes(surface_, state.q), first_volumes_, solution.held, h);
  const bool any = coupled_.volume_term && coupled_.coupling.simultaneous && flow_->keeps_volume(state);
  for (std::size_t k = 0; k < regions.source.size(); ++k) {
    if (!any || regions.compliant[k] == 0) regions.source[k] = 0;
  }
}

/// What a step of the fluid is for the solids in it: its flux is that of v*.
FluidOfStep CoupledStep::fluid_of(const CoupledState& state, double h, const Solution& solution) const {
  FluidOfStep fluid{.B = flow_->map().B,
                    .L = solution.L,
                    .r = flow_->net_flux(state.v),
                    .drag = drag_,
                    .cell = flow_->rows(),
                    .cells = flow_->row_count(),
                    .region = flow_->regions().of,
                    .closed = solution.regions.closed,
                    .loose = solution.regions.closed,
                    .time = state.time,
                    .h = h,
                    .coarse = flow_->coarse_pressures()};
  for (std::size_t k = 0; k < fluid.r.size(); ++k) fluid.r[k] -= solution.regions.source[at(fluid.region[k])];
  for (std::size_t k = 0; k < fluid.loose.size(); ++k) {
    if (coupled_.coupling.simultaneous && solution.regions.compliant[k] != 0) fluid.loose[k] = 0;
  }
  return fluid;
}

void CoupledStep::solve_once(const FluidOfStep& fluid, CoupledState& state, Solution& solution) {
  std::vector<double>& b = solution.b;
  b = solids_.b;
  solution.friction.assign(b.size(), 0.0);
  contact_.add_friction(solution.friction);
  const CouplingMap& map = flow_->map();
  for (std::size_t k = 0; k < b.size(); ++k)
    b[k] += solution.friction[k] + fluid.drag[k] + map.outside[k] + map.film_weight[k];
  solution.lifts = contact_.lifts(state.touches, b.size());
  solids_.add_lifts(solution.lifts, b);
  CoupledEquations equations = fluid.equations(flow_->flux_map(), solids_.A, b, fluid.r, solution.held);
  equations.same_matrices = solution.same_matrices;
  solution.fluid_force.assign(b.size(), 0.0);
  if (!coupled_.coupling.simultaneous) {
    const std::vector<double> before = flow_->guess_of(state);
    add_transposed_product(map.B, 1, before, solution.fluid_force);
    system_.solve_solids(equations, state.time, state.u, before);
    system_.solve_fluid(equations, state.time, state.u, solution.p);
  } else {
    system_.solve(equations, state.time, state.u, solution.p);
    add_transposed_product(map.B, 1, solution.p, solution.fluid_force);
  }
  std::vector<double>& taken = solution.taken;  // A u1 - b
  taken.resize(b.size()), solution.wall_force.assign(b.size(), 0.0);
  solids_.A.multiply(state.u, taken);
  for (std::size_t k = 0; k < b.size(); ++k) {
    taken[k] -= b[k];
    if (solution.held[k] == 0) continue;
    solution.wall_force[k] = taken[k] - solution.fluid_force[k];  // which holds it
    taken[k] = solution.fluid_force[k];
  }
}

void CoupledStep::note_powers(const CoupledState& state, Solution& solution) const {
  solution.working = state.u;
  solution.terms = terms_size(solids_.A, state.u);
  for (std::size_t k = 0; k < state.u.size(); ++k) solution.terms += std::abs(state.u[k] * solution.b[k]);
}

void CoupledStep::move_solids(CoupledState& state, std::span<const double> u0, double h) {
  for (std::size_t k = 0; k < state.q.size(); ++k) state.q[k] += 0.5 * h * (u0[k] + state.u[k]);
  solids_.system.place_supports(state.time + h, state.q);
  contact_.place(state.q);
}

}  // namespace tether::coupled
