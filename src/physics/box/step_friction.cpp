// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "base/numbers.hpp"
#include "physics/box/liquid/extend.hpp"
#include "physics/box/liquid/parts.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// What the fluid's friction does in a step, to itself and to bodies that it sticks to.

namespace {

/// The most that a node's velocity can change by an impulse on it: the consistent mass of linear triangles and
/// tetrahedra is nowhere less than 1 / (dim + 2) of the lumped one.
double mobility_of(int dim, double lumped) { return (dim + 2) / lumped; }

}  // namespace

/// A flow goes on through open sides as it comes; what has a surface ends there, as at the surface.
Beyond CoupledStep::beyond_open_sides() const {
  return liquid_ || !coupled_.voids.empty() ? Beyond::nothing : Beyond::fluid;
}

/// The solids get at (4) what the fluid's friction gave their nodes, as a force that acts all the step.
void CoupledStep::add_friction(CoupledState& state, double h) {
  const bool sticks = sticks_to_bodies(coupled_);
  const SolidsBeside solids{placer_.whole().surface(), at_.beside, state.u.size(), sticks};
  const bool any = solids.surface.side_count() > 0;
  if (liquid_) parts_ = liquid::liquid_parts(coupled_.grid, at_.surface->distance);
  const RubbingFluid fluid{at_.room(), coupled_.density,    coupled_.viscosity,
                           parts_,     beyond_open_sides(), any ? &solids : nullptr};
  const Rubbed rubbed = add_viscosity(team_, fluid, sticks ? rubbed_nodes(state) : RubbedNodes{}, h, coupled_.tolerance,
                                      state.driven, state.v);
  for (std::size_t k = 0; sticks && k < drag_.size(); ++k) drag_[k] = rubbed.impulse[k] / h;
  state.books.viscous += rubbed.taken;
}

RubbedNodes CoupledStep::rubbed_nodes(const CoupledState& state) const {
  RubbedNodes nodes{{}, state.u, state.driven_nodes};
  const auto dim = at(surface_.dim);
  for (std::size_t k = 0; k < state.u.size(); ++k)
    nodes.mobility.push_back(solids_.held[k] != 0 ? 0 : mobility_of(surface_.dim, solids_.system.lumped[k / dim]));
  return nodes;
}

/// Keeps what all else than the fluid's friction gave each node, as `rubbed_nodes` takes its answer to a force; none
/// where it was held, as there that is what friction asks for. A body that sinks at its last speed then has in each
/// step the drag of that speed, whatever h. That drag never gives energy asks for answers no smaller than the true
/// ones, by springs of any stiffness and both rules of the solids' step.
void CoupledStep::keep_drive_of_bodies(std::span<const double> u0, const Solution& solution, double h,
                                       CoupledState& state) const {
  const auto dim = at(surface_.dim);
  for (std::size_t k = 0; k < u0.size(); ++k) {
    const double by_friction = drag_[k] * mobility_of(surface_.dim, solids_.system.lumped[k / dim]);
    state.driven_nodes[k] = solution.held[k] != 0 ? 0 : (state.u[k] - u0[k]) / h - by_friction;
  }
}

/// Keeps what pressures and forces gave each open face in this step, and the end of the step after them: the viscosity
/// of the next one sees it. `unforced_` holds what these changed. About a liquid faces get it from those in it, as they
/// get their velocities: they may be in it by then.
void CoupledStep::keep_drive(const FaceValues& given, double h, CoupledState& state) const {
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const double change = unforced_[axis][f] + (state.v[axis][f] - given[axis][f]);
      state.driven[axis][f] = at_.domain.face[axis][f] == FaceKind::open ? change / h : 0;
    }
  }
  if (!liquid_) return;
  constexpr int layers = 2;
  liquid::extend_about_liquid(at_.room(), at_.domain, at_.surface->distance, face_values(coupled_.grid), layers,
                              state.driven);
}

/// Faces that no pressure moves but that have liquid keep what friction made of their velocity, with the acceleration
/// of those in the liquid: on, not along a line through these, whose slope is that of the stress below the surface.
void CoupledStep::keep_rubbed_faces(const FaceValues& given, double h, CoupledState& state) const {
  for (int axis = 0; axis < coupled_.grid.dim; ++axis) {
    for (std::size_t f = 0; f < state.v[at(axis)].size(); ++f) {
      if (at_.room().face[at(axis)][f] != FaceKind::open || at_.domain.face[at(axis)][f] == FaceKind::open) continue;
      if (part_of_face(parts_, coupled_.grid, axis, coupled_.grid.place_of_face(axis, f)) == 0) continue;
      state.v[at(axis)][f] = given[at(axis)][f] - unforced_[at(axis)][f] + h * state.driven[at(axis)][f];
    }
  }
}

}  // namespace tether::coupled
