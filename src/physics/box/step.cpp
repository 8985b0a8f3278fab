// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "physics/box/carry_velocity.hpp"
#include "physics/box/cut_faces.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/smoke_follow.hpp"

namespace tether::coupled {
namespace {

constexpr int layers_around_fluid = 4;

std::vector<double> on_cells(const PressureNumbers& numbers, std::span<const double> p) {
  std::vector<double> values(numbers.of_cell.size(), 0.0);
  for (std::size_t k = 0; k < p.size(); ++k) values[numbers.cell[k]] = p[k];
  return values;
}

/// Measures by what goes through a face over all of its area: through the sliver that a solid leaves of one little
/// does, however fast.
double cells_crossed(const FlowDomain& domain, const FaceValues& v, double h) {
  double most = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(domain.grid.dim); ++axis) {
    for (std::size_t f = 0; f < v[axis].size(); ++f) {
      if (domain.face[axis][f] != FaceKind::closed)
        most = std::max(most, std::abs(v[axis][f]) * domain.area[axis][f] * h / domain.grid.volume());
    }
  }
  return most;
}

}  // namespace

CoupledStep::CoupledStep(const Scene& scene, const Solids& solids, Team& team)
    : team_(team),
      scene_(scene),
      coupled_(*scene.coupled()),
      gravity_(gravity_of(scene)),
      surface_(surface_of(solids.mesh)),
      solids_(coupled_, solids, gravity_, team),
      box_(coupled_),
      outside_(coupled_, gravity_),
      placer_(coupled_, surface_, solids.mesh.x.size(), box_, outside_, team),
      contact_(coupled_, surface_),
      system_(coupled_, team),
      around_(solids_, system_),
      drag_(solids_.system.unknowns(), 0.0),
      first_volumes_(enclosed_volumes(surface_, solids.mesh.x)) {
  if (coupled_.liquid) liquid_.emplace(coupled_, gravity_, team_);
  if (tether::keeps_energy(coupled_, solids, scene.clock.tstep)) solid_step_.emplace(solids_.system, &around_);
}

void CoupledStep::resume(CoupledState& state) {
  place(state);
  system_.keep_orders(state.orders);
}

/// One step of the paper, 3.1 to 3.3, or one whose solids keep their energy.
fem::NewtonReport CoupledStep::advance(CoupledState& state, double h, bool by_euler) {
  const std::vector<double> q0 = state.q;
  const LiquidBooks before = liquid_ ? books_of_liquid(state) : LiquidBooks{};
  Solution solution;
  move_fluid_freely(state, h);  // (1) without pressure: v*
  const fem::NewtonReport end = coupled_.viscosity > 0 ? find_with_friction(state, h, by_euler, solution)
                                                       : find_step(state, h, by_euler, solution);
  if (!end.converged) return end;
  note_unswept(q0, solution, state);
  state.last.cfl = cells_crossed(at_.domain, state.v, h);
  state.cfl_largest = std::max(state.cfl_largest, state.last.cfl);
  carry_smoke_along(state, h);
  const double found = energy_of(state.v);
  const FaceValues given = coupled_.viscosity > 0 ? state.v : FaceValues{};
  end_velocity(h, state.last.cfl, state.v);
  if (coupled_.viscosity > 0) keep_end(given, h, state);
  if (liquid_) move_particles(state, h);
  check(state);
  place_solids(state.time + h, state);
  liquid_ ? book_liquid(before, state) : book_remeshed(found, state);
  return end;
}

/// Finds velocities and pressures, and moves the solids.
fem::NewtonReport CoupledStep::find_step(CoupledState& state, double h, bool by_euler, Solution& solution) {
  unforced_ = state.v;
  add_forces(state.smoke, h, state.v);
  solution = begin_solution(state, h);
  if (solid_step_) return solve_by_energy(state, h, by_euler, solution);
  const std::vector<double> q0 = state.q, u0 = state.u;
  solids_.assemble(state.q, state.u, state.time, h);  // (4): A, b
  solve(state, h, solution);                          // (7), (8)
  move_solids(state, u0, h);                          // (5)
  book_solids(q0, u0, solution, state, h);
  note_turning(state, h);
  return {true, {}};
}

/// Leaves what the next step is to find, in cut faces and in the solids.
void CoupledStep::end_velocity(double h, double cells_crossed, FaceValues& v) const {
  if (liquid_) {
    if (coupled_.coupling.cuts_faces) blend_cut_faces(at_.domain, at_.room(), h, v);
    return liquid_->extend(at_, cells_crossed, v);
  }
  if (coupled_.coupling.cuts_faces) blend_cut_faces(at_.domain, h, v);
  extend_velocity(at_.domain, v, layers_around_fluid);
}

void CoupledStep::book_remeshed(double before, CoupledState& state) const {
  state.books.remeshed += before - energy_of(state.v);
}

/// Finds what a step begins with.
void CoupledStep::place(CoupledState& state) {
  if (liquid_) liquid_->look(state.liquid_flow, state.particles);
  at_ = placer_.at(state.q, {}, liquid_ ? liquid_->filled() : std::span<const double>());
}

/// The fluid's cells change with them, and smoke goes where there is fluid.
void CoupledStep::place_solids(double time, CoupledState& state) {
  const FlowDomain before = std::move(at_.domain);
  at_ = {};  // it takes as much room as the new one
  liquid_ ? place_liquid(state) : place(state);
  if (coupled_.smoke) follow_domain(before, at_.domain, state.smoke);
  note_thin_bodies(time, state);
  note_bodies_that_left(time, state);
}

void CoupledStep::move_fluid_freely(CoupledState& state, double h) {
  if (liquid_) {
    take_from_particles(state, h);
  } else {
    box_.prescribe(at_.domain, state.time, h, state.v);
    extend_velocity(at_.domain, state.v, layers_around_fluid);
    carry_along(state, h);
  }
}

void CoupledStep::carry_along(CoupledState& state, double h) {
  FaceValues carried = state.v;
  carry_velocity(team_, at_.domain, state.v, h, coupled_.advection, carried);
  const CarriedIn in = carried_in(coupled_, at_.domain, state.v, h);
  state.books.jets += in.jets, state.books.open_sides += in.open_sides;
  state.books.advected += energy_of(state.v) + in.jets + in.open_sides - energy_of(carried);
  state.v = std::move(carried);
}

/// Gravity, smoke and the pressure outside come last: at rest they are to the last digit what pressures balance, and
/// viscosity, which walls feel, would leave no such sum.
void CoupledStep::add_forces(const Smoke& smoke, double h, FaceValues& v) const {
  for (std::size_t axis = 0; axis < at(coupled_.grid.dim); ++axis) {
    for (std::size_t f = 0; f < v[axis].size() && gravity_[axis] != 0; ++f) {
      if (at_.room().face[axis][f] == FaceKind::open) v[axis][f] += h * gravity_[axis];
    }
  }
  if (coupled_.smoke) add_buoyancy(at_.domain, smoke, coupled_.smoke_lift, coupled_.smoke_weight, h, v);
  outside_.press(at_.domain, h, v);
}

/// Begins with the pressures of the step before.
CoupledStep::Solution CoupledStep::begin_solution(const CoupledState& state, double h) const {
  Solution solution;
  solution.p = of_cells(at_.numbers, state.p);
  solution.L = pressure_matrix(at_.domain, at_.numbers, h / coupled_.density);
  return solution;
}

/// Contact decides which velocities are held; as these change, the equations are solved again.
void CoupledStep::solve(CoupledState& state, double h, Solution& solution) {
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
    solution.same_matrices = k > 0 && held == solution.held;
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
  add_pressure(at_.domain, at_.numbers, solution.p, h / coupled_.density, state.v);
  account(free, solution, state, h);
  state.p = on_cells(at_.numbers, solution.p);
  extend_pressure(at_.domain, state.p, layers_around_fluid);
  for (std::size_t k = 0; k < solution.friction.size(); ++k) {
    state.fluid_force[k] = solution.fluid_force[k] + at_.map.outside[k] + at_.map.film_weight[k] + drag_[k];
    state.wall_force[k] = solution.wall_force[k] + solution.friction[k];
  }
  solution.L = {}, system_.let_go();  // where solids are placed next, others take their room
}

/// Finds, with the volume term, what each cell of a region takes of it.
void CoupledStep::find_regions_of(const CoupledState& state, double h, Solution& solution) const {
  Regions& regions = solution.regions;
  regions = regions_of(at_.domain, at_.map, at_.numbers, enclosed_volumes(surface_, state.q), first_volumes_,
                       solution.held, h);
  const bool any = coupled_.volume_term && coupled_.coupling.simultaneous && (!liquid_ || state.full != 0);
  for (std::size_t k = 0; k < regions.source.size(); ++k) {
    if (!any || regions.compliant[k] == 0) regions.source[k] = 0;
  }
}

/// What a step of the fluid is for the solids in it: `flux` is that of v*, and forces on the nodes are those that
/// nothing in the step changes.
FluidOfStep CoupledStep::fluid_of(const CoupledState& state, double h, const Solution& solution) const {
  FluidOfStep fluid{at_.map.B,
                    solution.L,
                    net_flux(at_.domain, at_.numbers, state.v),
                    drag_,
                    at_.numbers.cell,
                    at_.domain.kind.size(),
                    of_cells(at_.numbers, at_.domain.region),
                    solution.regions.closed,
                    solution.regions.closed,
                    state.time,
                    h};
  for (std::size_t k = 0; k < fluid.given.size(); ++k) fluid.given[k] += at_.map.outside[k] + at_.map.film_weight[k];
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
  for (std::size_t k = 0; k < b.size(); ++k) b[k] += solution.friction[k] + fluid.given[k];
  solution.lifts = contact_.lifts(state.touches, b.size());
  solids_.add_lifts(solution.lifts, b);
  const CouplingMatrix& caused = coupled_.coupling.two_maps ? at_.crossing_map : at_.map.B;
  CoupledEquations equations = fluid.equations(caused, solids_.A, b, fluid.r, solution.held);
  equations.same_matrices = solution.same_matrices;
  solution.fluid_force.assign(b.size(), 0.0);
  if (!coupled_.coupling.simultaneous) {
    const std::vector<double> before = of_cells(at_.numbers, state.p);
    add_transposed_product(at_.map.B, 1, before, solution.fluid_force);
    system_.solve_solids(equations, state.time, state.u, before);
    system_.solve_fluid(equations, state.time, state.u, solution.p);
  } else {
    system_.solve(equations, state.time, state.u, solution.p);
    add_transposed_product(at_.map.B, 1, solution.p, solution.fluid_force);
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
