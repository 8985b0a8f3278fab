// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/box/flow.hpp"
#include "physics/box/flow_box.hpp"
#include "physics/box/friction/viscosity.hpp"
#include "physics/box/placer.hpp"
#include "physics/box/solid_equations.hpp"

namespace tether::coupled {

/// A fluid on the regular grid, all over the room that solids leave: pressures of cells, velocities of faces across
/// them.
class GridFlow : public Flow, public FlowFriction {
 public:
  /// All must outlive it.
  GridFlow(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface, const SolidEquations& solids,
           Team& team);

  /// The fluid about solids at q.
  virtual Placement placed(std::span<const double> q) const { return placer_.at(q); }
  Equations equations_at(std::span<const double> q, double by) const override;

  void start(CoupledState& state) override;
  void prescribe(double time, double h, FaceValues& v) const override { box_.prescribe(at_.domain, time, h, v); }
  void finish_start(double h, CoupledState& state) override;
  void place(CoupledState& state) override { take(placed(state.q)); }

  void begin(CoupledState& state, double h) override;
  void add_forces(const Smoke& smoke, double h, FaceValues& v) const override;
  void book_forces(CoupledState& state, double h) const override;
  void end(const FaceValues& change, CoupledState& state, double h) override;
  void turn_map(std::span<const Vec<3>> area) override { at_.map.turn(team_, area); }

  const CouplingMap& map() const override { return at_.map; }
  const CouplingMatrix& flux_map() const override { return scene_.coupling.two_maps ? at_.crossing_map : at_.map.B; }
  const FlowRegions& regions() const override { return regions_; }
  std::span<const std::size_t> rows() const override { return at_.numbers.cell; }
  std::size_t row_count() const override { return at_.domain.kind.size(); }
  bool keeps_volume(const CoupledState& /*state*/) const override { return true; }
  std::vector<std::uint8_t> regions_of_jets(const FaceValues& v) const override {
    return coupled::regions_of_jets(at_.domain, v);
  }
  Vec<3> place_of_pressure(std::size_t k) const override;
  std::vector<double> guess_of(const CoupledState& state) const override { return of_cells(at_.numbers, state.p); }
  void keep_pressures(std::span<const double> p, CoupledState& state) const override;

  SparseMatrix pressure_matrix(double by) const override;
  std::vector<double> net_flux(const FaceValues& v) const override;
  void add_pressure(std::span<const double> p, double by, FaceValues& v) const override;
  double kinetic_energy(const FaceValues& v, const FaceValues& w) const override;
  double prescribed_power(std::span<const double> p, const FaceValues& v) const override;
  std::vector<double> masses() const override;
  double cells_crossed(const FaceValues& v, double h) const override;

  FlowFriction* friction() override { return this; }
  void begin_friction(const CoupledState& state, NodeInertia nodes, double h) override;
  std::vector<double> add_friction(CoupledState& state, double h, double tolerance, std::span<double> drag) override;
  bool has_dear_digits() const override { return false; }
  void take_drive(const FaceValues& change, double h, CoupledState& state) const override;
  void extend_drive(CoupledState& /*state*/) const override {}
  void add_viscous_pressure(double h, std::span<double> missed) const override;

  std::size_t fluid_cells() const override;
  void add_sums(const CoupledState& state, CoupledSums& sums) const override;
  double pressure_energy(const CoupledState& state) const override;
  void add_summary(Summary& summary) const override;
  Snapshot cell_fields(const CoupledState& state) const override;
  Snapshot surface_fields(const CoupledState& state) const override { return {state.time, {}}; }
  Snapshot particle_fields(const CoupledState& state) const override { return {state.time, {}}; }
  std::vector<std::string> take_messages() override { return std::exchange(messages_, {}); }

 protected:
  void take(Placement placement);
  void end_velocities(const FaceValues& change, double h, CoupledState& state) const;
  void place_moved(double time, CoupledState& state);
  double energy_of(const FaceValues& v) const { return kinetic_energy(v, v); }

  // What a liquid with a surface does otherwise.

  /// Fills the room that solids leave at the start.
  virtual void fill(CoupledState& state) { place(state); }
  /// Gives velocities to faces in small parts of cut cells, and about the fluid.
  virtual void extend(double h, double cells_crossed, FaceValues& v) const;
  /// Ends the velocities of faces that no pressure moves, of a viscous fluid that had those `given`.
  virtual void keep_rubbed_faces(const FaceValues& /*given*/, const FaceValues& /*change*/, double /*h*/,
                                 CoupledState& /*state*/) const {}
  /// Places the solids where a step has moved them, and the fluid about them.
  virtual void place_after_step(CoupledState& state) { place(state); }
  /// Finds the parts of cells that rub.
  virtual void find_parts() {}
  /// Says what a fluid that rubs meets at open sides: itself, going on as it comes, unless a void lets it end.
  virtual Beyond beyond_open_sides() const { return scene_.voids.empty() ? Beyond::fluid : Beyond::nothing; }

  Team& team_;
  const Coupled& scene_;
  Vec<3> gravity_;  // [acceleration]
  const SolidSurface& surface_;
  const SolidEquations& solids_;
  FlowBox box_;
  Outside outside_;
  Placer placer_;
  Placement at_;     // of the solids now
  CellParts parts_;  // of a viscous liquid
  std::vector<std::string> messages_;

 private:
  void carry_along(CoupledState& state, double h);
  void carry_smoke_along(CoupledState& state, double h) const;
  std::vector<SmokeJet> smoke_sources(double time, double h) const;
  Smoke smoke_at_start() const;
  void begin_friction(Beyond beyond, double h, std::size_t numbers);
  void note_thin_bodies(double time, CoupledState& state);

  FlowRegions regions_;
  std::vector<double> mobility_;                // of the step's friction
  std::optional<SolidsNearFaces> near_solids_;  // likewise
  std::optional<Friction> rubbing_;             // likewise
};

}  // namespace tether::coupled
