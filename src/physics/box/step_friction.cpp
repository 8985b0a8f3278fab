// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <algorithm>

#include "base/diagnostics.hpp"
#include "base/numbers.hpp"
#include "physics/box/liquid/extend.hpp"
#include "physics/box/liquid/parts.hpp"
#include "physics/box/step.hpp"

namespace tether::coupled {

// What the fluid's friction does in a step, to itself and to bodies that it sticks to.

/// A flow goes on through open sides as it comes; what has a surface ends there, as at the surface.
Beyond CoupledStep::beyond_open_sides() const {
  return liquid_ || !coupled_.voids.empty() ? Beyond::nothing : Beyond::fluid;
}

/// What rubs in a step: the same in all of its passes.
void CoupledStep::begin_friction(const CoupledState& state, double h, Beyond beyond) {
  if (liquid_) parts_ = liquid::liquid_parts(coupled_.grid, at_.surface->distance);
  const WholeSurface& whole = placer_.whole();
  beside_.emplace(SolidsBeside{whole.surface(), at_.beside, state.u.size(), sticks_to_bodies(coupled_)});
  std::vector<double> mobility;
  for (std::size_t k = 0; sticks_to_bodies(coupled_) && k < state.u.size(); ++k) mobility.push_back(mobility_of(k));
  friction_.emplace(RubbingFluid{at_.room(), coupled_.density, coupled_.viscosity, parts_, beyond,
                                 whole.surface().side_count() > 0 ? &*beside_ : nullptr},
                    mobility, h);
}

/// The solids get at (4) what the fluid's friction gave their nodes, as a force that acts all the step.
void CoupledStep::add_friction(CoupledState& state, double h) {
  const double tolerance = std::max(coupled_.tolerance, 1e-10);
  const std::span<const double> u =
      sticks_to_bodies(coupled_) ? std::span<const double>(state.u) : std::span<const double>();
  Rubbed rubbed = friction_->act(team_, u, state.driven_nodes, tolerance, state.driven, state.v);
  if (rubbed.iterations < 0) {  // solids at open sides may take the sign of its power
    begin_friction(state, h, Beyond::nothing);
    rubbed = friction_->act(team_, u, state.driven_nodes, tolerance, state.driven, state.v);
  }
  if (rubbed.iterations < 0)
    throw RunError(
        fmt::format("t = {:.9g}: conjugate gradients do not converge for the fluid's friction: likely cause, "
                    "values that ran away",
                    state.time),
        Failure::does_not_converge);
  for (std::size_t k = 0; k < rubbed.impulse.size(); ++k) drag_[k] = rubbed.impulse[k] / h;
  state.books.viscous += rubbed.heat;
  state.books.projected += rubbed.taken - rubbed.heat;
}

/// The most that a node's velocity can change by an impulse on it: the consistent mass of linear triangles and
/// tetrahedra is nowhere less than 1 / (dim + 2) of the lumped one. So a node is dragged along at once and no further.
double CoupledStep::mobility_of(std::size_t k) const {
  return solids_.held[k] != 0 ? 0 : (surface_.dim + 2) / solids_.system.lumped[k / at(surface_.dim)];
}

/// Keeps what pressures and forces gave each open face, which `unforced_` holds, and what the end of the step before
/// gave: a flow that is steady from step to step then is one for friction, too.
void CoupledStep::take_drive(double h, CoupledState& state) const {
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const bool open = at_.domain.face[axis][f] == FaceKind::open;
      state.driven[axis][f] = open ? unforced_[axis][f] / h + state.ended[axis][f] : 0;
    }
  }
}

/// Keeps what the end of this step makes of the velocities that it was given.
void CoupledStep::keep_end(const FaceValues& given, double h, CoupledState& state) const {
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const bool open = at_.domain.face[axis][f] == FaceKind::open;
      state.ended[axis][f] = open ? (state.v[axis][f] - given[axis][f]) / h : 0;
    }
  }
  take_drive(h, state);
  extend_drive(state);
  if (liquid_) keep_rubbed_faces(given, h, state);
}

/// About a liquid faces get it from those in it, as they get their velocities: they may be in it by then.
void CoupledStep::extend_drive(CoupledState& state) const {
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
