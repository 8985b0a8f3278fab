// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// Where a run begins.

/// The fluid's velocity of the deck, less what pressures take of it so that it flows round the solids.
CoupledState CoupledStep::start() {
  CoupledState state;
  const Mesh& mesh = solids_.system.solids.mesh;
  state.q = mesh.x;
  state.u = fem::first_velocities(solids_.system);
  solids_.system.place_supports(0, state.q);
  solids_.system.move_supports(0, fem::slope_width * scene_.clock.tstep, state.u);
  state.touches.assign(state.q.size(), Touch::away);
  state.fluid_force.assign(state.q.size(), 0.0), state.wall_force = state.fluid_force;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(coupled_.grid.dim); ++axis)
    state.v[axis].assign(coupled_.grid.face_count(static_cast<int>(axis)), coupled_.start[axis]);
  if (coupled_.viscosity > 0) state.driven = state.ended = face_values(coupled_.grid);
  state.driven_nodes.assign(sticks_to_bodies(coupled_) ? state.u.size() : 0, 0.0);
  state.left.assign(static_cast<std::size_t>(surface_.parts), 0);
  state.p.assign(coupled_.grid.cell_count(), 0.0);
  liquid_ ? fill_with_liquid(state) : place(state);
  project_start(state);
  if (coupled_.smoke) state.smoke = smoke_at_start();
  if (solid_step_) look_at_contact(state);
  note_thin_bodies(0, state);
  return state;
}

/// Makes the fluid's velocity free of divergence.
void CoupledStep::project_start(CoupledState& state) {
  box_.prescribe(at_.domain, 0, 0, state.v);
  solids_.assemble(state.q, state.u, 0, scene_.clock.tstep);
  const std::vector<double> r = net_flux(at_.domain, at_.numbers, state.v);
  std::vector<double> p(r.size(), 0.0);
  const std::vector<int> region = of_cells(at_.numbers, at_.domain.region);
  const Regions regions = regions_of(at_.domain, at_.map, at_.numbers, first_volumes_, first_volumes_, solids_.held, 1);
  system_.solve_fluid({solids_.A, solids_.b, at_.map.B, at_.map.B, pressure_matrix(at_.domain, at_.numbers, 1), r,
                       solids_.held, at_.numbers.cell, at_.domain.kind.size(), region, regions.closed, regions.closed},
                      0, state.u, p);
  add_pressure(at_.domain, at_.numbers, p, 1, state.v);
  constexpr double cells_crossed = 1;
  end_velocity(scene_.clock.tstep, cells_crossed, state.v);
  if (liquid_) move_particles(state, 0);
}

}  // namespace tether::coupled
