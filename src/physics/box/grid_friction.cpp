// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"
#include "physics/box/grid_flow.hpp"
#include "physics/box/matrix.hpp"
#include "physics/box/projection.hpp"

namespace tether::coupled {

// What the fluid's friction does in a step, to itself and to bodies that it sticks to.

namespace {

/// 1 / mass of each number, 0 where it is held [1/mass].
std::vector<double> mobilities(const NodeInertia& nodes, int dim) {
  std::vector<double> mobilities = masses_as_one(nodes, dim);
  for (std::size_t k = 0; k < nodes.size(); ++k) mobilities[k] = nodes.held[k] != 0 ? 0 : 1 / mobilities[k];
  return mobilities;
}

}  // namespace

void GridFlow::begin_friction(const CoupledState& state, NodeInertia nodes, double h) {
  find_parts();
  mobility_ = mobilities(nodes, scene_.grid.dim);
  begin_friction(beyond_open_sides(), h, state.u.size());
}

void GridFlow::begin_friction(Beyond beyond, double h, std::size_t numbers) {
  const SolidSurface& whole = placer_.whole().surface();
  near_solids_.emplace(SolidsNearFaces{whole, at_.near_faces, numbers, sticks_to_bodies(scene_)});
  rubbing_.emplace(RubbingFluid{at_.room(), scene_.density, scene_.viscosity, parts_, beyond,
                                whole.side_count() > 0 ? &*near_solids_ : nullptr},
                   mobility_, h);
}

/// The solids get at (4) what the fluid's friction gave their nodes, as a force that acts all the step.
std::vector<double> GridFlow::add_friction(CoupledState& state, double h, double tolerance, std::span<double> drag) {
  const std::span<const double> u =
      sticks_to_bodies(scene_) ? std::span<const double>(state.u) : std::span<const double>();
  Rubbed rubbed = rubbing_->act(team_, u, state.driven_nodes, tolerance, state.driven, state.v);
  if (rubbed.iterations < 0) {  // solids at open sides may take the sign of its power
    begin_friction(Beyond::nothing, h, state.u.size());
    rubbed = rubbing_->act(team_, u, state.driven_nodes, tolerance, state.driven, state.v);
  }
  rubbed.book(h, state, drag);
  return std::move(rubbed.nodes);
}

void GridFlow::take_drive(const FaceValues& change, double h, CoupledState& state) const {
  for (std::size_t axis = 0; axis < state.v.size(); ++axis) {
    for (std::size_t f = 0; f < state.v[axis].size(); ++f) {
      const bool open = at_.domain.face[axis][f] == FaceKind::open;
      state.driven[axis][f] = open ? change[axis][f] / h + state.ended[axis][f] : 0;
    }
  }
  extend_drive(state);
}

void GridFlow::add_viscous_pressure(double h, std::span<double> missed) const {
  FaceValues faces = face_values(scene_.grid), more = faces;
  std::size_t k = 0;
  for (std::size_t axis = 0; axis < faces.size(); ++axis) {
    for (std::size_t f = 0; f < faces[axis].size(); ++f, ++k)
      faces[axis][f] = at_.domain.face[axis][f] == FaceKind::open ? missed[k] : 0;
  }
  std::vector<double> p = net_flux(faces);
  if (k < missed.size()) add_product(at_.map.B, 1, missed.subspan(k), p);
  for (double& value : p) value *= 2 * h * scene_.viscosity / scene_.grid.volume();
  add_pressure_within(at_.domain, at_.numbers, p, 1 / scene_.density, more);
  k = 0;
  for (const std::vector<double>& axis : more) {
    for (const double value : axis) missed[k++] += value;
  }
}

}  // namespace tether::coupled
