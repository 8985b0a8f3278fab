// SPDX-License-Identifier: GPL-3.0-or-later
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
  if (swings_) state.swing.assign(state.u.size(), 0.0);
  state.driven_nodes.assign(sticks_to_bodies(coupled_) ? state.u.size() : 0, 0.0);
  state.left.assign(static_cast<std::size_t>(surface_.parts), 0);
  flow_->start(state);
  project_start(state);
  if (solid_step_) look_at_contact(state);
  return state;
}

/// Makes the fluid's velocity free of divergence.
void CoupledStep::project_start(CoupledState& state) {
  flow_->prescribe(0, 0, state.v);
  solids_.assemble(state.q, state.u, 0, scene_.clock.tstep);
  const std::vector<double> r = flow_->net_flux(state.v);
  std::vector<double> p(r.size(), 0.0);
  const CouplingMatrix& B = flow_->map().B;
  const FlowRegions& parts = flow_->regions();
  const Regions regions = regions_of(parts, flow_->map(), first_volumes_, first_volumes_, solids_.held, 1);
  const SparseMatrix L = flow_->pressure_matrix(1);
  CoupledEquations equations{
      solids_.A,      solids_.b,     B, B, L, r, solids_.held, flow_->rows(), flow_->row_count(), parts.of,
      regions.closed, regions.closed};
  equations.coarse = flow_->coarse_pressures();
  system_.solve_fluid(equations, 0, state.u, p);
  flow_->add_pressure(p, 1, state.v);
  flow_->finish_start(scene_.clock.tstep, state);
}

}  // namespace tether::coupled
