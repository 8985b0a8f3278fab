// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "base/numbers.hpp"
#include "physics/box/step.hpp"
#include "physics/box/viscosity.hpp"

namespace tether::coupled {

// What the fluid's friction does in a step, to itself and to bodies that it sticks to.

namespace {

/// The most that a node's velocity can change by an impulse on it: the consistent mass of linear triangles and
/// tetrahedra is nowhere less than 1 / (dim + 2) of the lumped one.
double mobility_of(int dim, double lumped) { return (dim + 2) / lumped; }

}  // namespace

bool CoupledStep::may_stop(double h) const {
  return stop_ != nullptr && h * coupled_.viscosity > 0 &&
         viscous_steps(coupled_.grid, coupled_.viscosity / coupled_.density, h) > steps_between_questions;
}

/// The solids get at (4) what the fluid's friction gave their nodes, as a force that acts all the step.
bool CoupledStep::add_friction(CoupledState& state, double h) {
  const double before = energy_of(state.v), nu = coupled_.viscosity / coupled_.density;
  const auto stop = may_stop(h) ? stop_ : nullptr;
  std::optional<StickingBodies> bodies;
  if (sticks_to_bodies(coupled_)) bodies.emplace(sticking(state));
  if (add_viscosity(at_.domain, state.v, nu, h, true, &state.driven, stop, bodies ? &*bodies : nullptr) < 0)
    return false;
  for (std::size_t k = 0; bodies && k < drag_.size(); ++k) drag_[k] = bodies->impulse[k] / h;
  state.books.viscous += before - energy_of(state.v);
  return true;
}

StickingBodies CoupledStep::sticking(const CoupledState& state) const {
  StickingBodies bodies{surface_, at_.beside, {}, state.u, state.driven_nodes, coupled_.density};
  const auto dim = at(surface_.dim);
  for (std::size_t k = 0; k < state.u.size(); ++k)
    bodies.mobility.push_back(solids_.held[k] != 0 ? 0 : mobility_of(surface_.dim, solids_.system.lumped[k / dim]));
  return bodies;
}

/// Keeps what all else than the fluid's friction gave each node, as `sticking` takes its answer to a force; none where
/// it was held, as there that is what friction asks for. A body that sinks at its last speed then has in each step the
/// drag of that speed, whatever h. That drag never gives energy asks for answers no smaller than the true ones, by
/// springs of any stiffness and both rules of the solids' step.
void CoupledStep::keep_drive_of_bodies(std::span<const double> u0, const Solution& solution, double h,
                                       CoupledState& state) const {
  const auto dim = at(surface_.dim);
  for (std::size_t k = 0; k < u0.size(); ++k) {
    const double by_friction = drag_[k] * mobility_of(surface_.dim, solids_.system.lumped[k / dim]);
    state.driven_nodes[k] = solution.held[k] != 0 ? 0 : (state.u[k] - u0[k]) / h - by_friction;
  }
}

/// Keeps what pressures and forces gave each open face in this step, and the end of the step after them: the viscosity
/// of the next one sees it. `unforced_` holds what these changed.
void CoupledStep::keep_drive(const FaceValues& given, double h, CoupledState& state) const {
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const double change = unforced_[axis][f] + (state.v[axis][f] - given[axis][f]);
      state.driven[axis][f] = at_.domain.face[axis][f] == FaceKind::open ? change / h : 0;
    }
  }
}

}  // namespace tether::coupled
