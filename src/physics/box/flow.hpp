// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "algebra/two_level.hpp"
#include "physics/box/closed_regions.hpp"
#include "physics/box/coupling_map.hpp"
#include "physics/box/friction/node_inertia.hpp"
#include "physics/box/state.hpp"
#include "results/results.hpp"

namespace tether::coupled {

struct CoupledSums;

/// What a flow does with the friction of a viscous fluid.
class FlowFriction {
 public:
  FlowFriction() = default;
  FlowFriction(const FlowFriction&) = delete;
  FlowFriction& operator=(const FlowFriction&) = delete;
  virtual ~FlowFriction() = default;

  /// Finds what rubs in a step of length h, the same in all of its passes; `nodes` are those that the fluid sticks to,
  /// or none.
  virtual void begin_friction(const CoupledState& state, NodeInertia nodes, double h) = 0;
  /// Lets friction act; the nodes get `drag` [force]. `tolerance` is of the momentum that friction moves. Returns the
  /// velocities of the nodes by it and by their drive.
  virtual std::vector<double> add_friction(CoupledState& state, double h, double tolerance, std::span<double> drag) = 0;
  /// Returns whether the last digits of friction cost so many iterations that only a step's last pass should have them.
  virtual bool has_dear_digits() const = 0;
  /// Keeps the accelerations by `change`, what forces and pressures made of the velocities, and by the end of the step
  /// before: a flow that is steady from step to step then is one for friction, too.
  virtual void take_drive(const FaceValues& change, double h, CoupledState& state) const = 0;
  /// Gives velocities about the fluid the accelerations of those in it.
  virtual void extend_drive(CoupledState& state) const = 0;
  /// Adds to accelerations that lack `missed` (axis after axis, then of the nodes) those of the pressure
  /// 2 mu h div(missed), within the fluid.
  virtual void add_viscous_pressure(double h, std::span<double> missed) const = 0;
};

/// A fluid about solids: all that a step of both sees of it. With D the flux out of what each pressure stands for and M
/// the volume that a velocity moves, a flow makes L, net fluxes and what pressures do to velocities, and the map B
/// between pressures and the solids' nodes. What its velocities are it alone knows: by axis, with those that no
/// pressure moves among them. Kinds are the regular grid, a liquid on it, and a mesh.
///
/// A step is begin(), add_forces(), the solution, and end(). Solids stay as place() had them till a step's end.
class Flow {
 public:
  Flow() = default;
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;
  virtual ~Flow() = default;

  /// L of `by` (pressure_matrix()), B and regions of a fluid about solids at q.
  struct Equations {
    SparseMatrix L;
    CouplingMatrix B;
    FlowRegions regions;
  };
  virtual Equations equations_at(std::span<const double> q, double by) const = 0;

  // What a run begins with.

  /// Fills the room that solids leave and sets the velocities of the deck, not yet free of divergence.
  virtual void start(CoupledState& state) = 0;
  /// Sets the velocities of walls and jets in a step of length h [velocity].
  virtual void prescribe(double time, double h, FaceValues& v) const = 0;
  /// Ends the velocities of the start, which are free of divergence now, as end() does; `h` is the deck's step [time].
  virtual void finish_start(double h, CoupledState& state) = 0;
  /// Finds what a state goes on from.
  virtual void place(CoupledState& state) = 0;

  // The steps of a step.

  /// (1) without pressure: carries the velocity along to v*, and sets what walls and jets have.
  virtual void begin(CoupledState& state, double h) = 0;
  /// Adds to velocities what gravity, smoke and the pressure outside do in a time h.
  virtual void add_forces(const Smoke& smoke, double h, FaceValues& v) const = 0;
  /// Books the energy that these forces and openings gave the fluid at the velocities of the step's end.
  virtual void book_forces(CoupledState& state, double h) const = 0;
  /// Ends a step: velocities about the fluid are found, what it carries goes along, and solids are where the state has
  /// them. `change` is what forces and pressures made of the velocities [velocity].
  virtual void end(const FaceValues& change, CoupledState& state, double h) = 0;
  /// Turns the map to these areas of the surface's facets, times their normals out of the solid.
  virtual void turn_map(std::span<const Vec<3>> area) = 0;

  // Pressures and what they do.

  virtual const CouplingMap& map() const = 0;
  /// The map of the flux that the solids cause: B but for the paper's own mode.
  virtual const CouplingMatrix& flux_map() const = 0;
  virtual const FlowRegions& regions() const = 0;
  /// Rows of the pressures in matrices that keep their size while solids move, and how many rows these have.
  virtual std::span<const std::size_t> rows() const = 0;
  virtual std::size_t row_count() const = 0;
  /// Returns whether the volumes of closed regions are still those of the start.
  virtual bool keeps_volume(const CoupledState& state) const = 0;
  /// Marks the regions that jets fill or empty at velocities v.
  virtual std::vector<std::uint8_t> regions_of_jets(const FaceValues& v) const = 0;
  virtual Vec<3> place_of_pressure(std::size_t k) const = 0;
  /// First guesses, from what keep_pressures() left [stress].
  virtual std::vector<double> guess_of(const CoupledState& state) const = 0;
  virtual void keep_pressures(std::span<const double> p, CoupledState& state) const = 0;

  /// L = (h/rho) D M^-1 D^T, both triangles; `by` is h/rho [time volume/mass].
  virtual SparseMatrix pressure_matrix(double by) const = 0;
  /// Coarse pressures that L is preconditioned by; null: it is one that multigrid is made for.
  virtual const CoarseUnknowns* coarse_pressures() const { return nullptr; }
  /// D v with what prescribed velocities bring [volume/time].
  virtual std::vector<double> net_flux(const FaceValues& v) const = 0;
  /// v += (h/rho) M^-1 D^T p.
  virtual void add_pressure(std::span<const double> p, double by, FaceValues& v) const = 0;
  /// The sum of rho M v w / 2 [energy].
  virtual double kinetic_energy(const FaceValues& v, const FaceValues& w) const = 0;
  /// The power that the fluid does where velocities are prescribed [power].
  virtual double prescribed_power(std::span<const double> p, const FaceValues& v) const = 0;
  /// rho M of each velocity, axis after axis; 0 of those that no pressure moves [mass].
  virtual std::vector<double> masses() const = 0;
  /// How many cells the fluid crosses along an axis in a time h where it is fastest.
  virtual double cells_crossed(const FaceValues& v, double h) const = 0;

  /// Returns what it does with friction; null where it has none.
  virtual FlowFriction* friction() = 0;

  // What it shows.

  virtual std::size_t fluid_cells() const = 0;
  /// Adds the fluid's mass, momentum and energy.
  virtual void add_sums(const CoupledState& state, CoupledSums& sums) const = 0;
  /// Returns the pressure of a fluid at rest, by its depth, times volume: what rounding is small against [energy].
  virtual double pressure_energy(const CoupledState& state) const = 0;
  virtual void add_summary(Summary& summary) const = 0;
  virtual Snapshot cell_fields(const CoupledState& state) const = 0;
  virtual Snapshot surface_fields(const CoupledState& state) const = 0;
  /// At the corners of cells that are no grid's, one cell's after the other; nothing else.
  virtual Snapshot mesh_fields(const CoupledState& state) const { return {state.time, {}}; }
  virtual Snapshot particle_fields(const CoupledState& state) const = 0;
  virtual std::vector<std::string> take_messages() = 0;
};

}  // namespace tether::coupled
