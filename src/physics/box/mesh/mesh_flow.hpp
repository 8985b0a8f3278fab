// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physics/box/flow.hpp"
#include "physics/box/flow_box.hpp"
#include "physics/box/mesh/flow_surface.hpp"
#include "physics/box/mesh/friction_on_mesh.hpp"
#include "physics/box/mesh/mesh_map.hpp"
#include "physics/box/mesh/mesh_velocity.hpp"

namespace tether::coupled {

/// What bodies leave between each other, and to walls and obstacles, of the cells' size near them.
constexpr double least_gap = 1e-3;

/// Interpolates pressures of faces within a cell.
double pressure_in(const FlowMesh& mesh, std::span<const double> p, std::size_t cell, const Vec<3>& x);

/// A fluid on triangles or tetrahedra that fit the solids, made anew as these move: one velocity a cell, and pressures
/// in the middles of the faces, by which the flux through each face is the same on both sides (hybrid mixed elements of
/// the lowest order, P. A. Raviart, J. M. Thomas 1977; D. N. Arnold, F. Brezzi 1985). A face of the fluid at a solid is
/// a face of that, or a part of it: so B has its area over its nodes, and is exact.
///
/// A state's velocity is that on the mesh of the step that found it; the next step carries it over to its own.
class MeshFlow final : public Flow, public FlowFriction {
 public:
  /// All must outlive it; the team shares its loops. `numbers` are those of the solids' nodes.
  MeshFlow(const Coupled& scene, const Vec<3>& gravity, const SolidSurface& surface, std::size_t numbers, Team& team);

  /// The cells about the solids as they were placed last.
  const FlowMesh& mesh() const { return *at_.mesh; }
  Equations equations_at(std::span<const double> q, double by) const override;
  void start(CoupledState& state) override;
  void prescribe(double time, double h, FaceValues& v) const override;
  void finish_start(double /*h*/, CoupledState& /*state*/) override {}
  void place(CoupledState& state) override;

  void begin(CoupledState& state, double h) override;
  void add_forces(const Smoke& smoke, double h, FaceValues& v) const override;
  void book_forces(CoupledState& state, double h) const override;
  void end(const FaceValues& change, CoupledState& state, double h) override;
  void turn_map(std::span<const Vec<3>> area) override { at_.map.turn(team_, area); }

  const CouplingMap& map() const override { return at_.map; }
  const CouplingMatrix& flux_map() const override { return at_.map.B; }
  const FlowRegions& regions() const override { return at_.regions; }
  std::span<const std::size_t> rows() const override { return at_.rows; }
  std::size_t row_count() const override { return at_.rows.size(); }
  bool keeps_volume(const CoupledState& /*state*/) const override { return true; }
  std::vector<std::uint8_t> regions_of_jets(const FaceValues& v) const override;
  Vec<3> place_of_pressure(std::size_t k) const override { return at_.mesh->middle_of_face(at_.pressures.face_of[k]); }
  std::vector<double> guess_of(const CoupledState& state) const override;
  void keep_pressures(std::span<const double> p, CoupledState& state) const override;

  SparseMatrix pressure_matrix(double by) const override { return pressure_matrix(at_, by); }
  const CoarseUnknowns* coarse_pressures() const override { return mesh().dim == 3 ? &at_.coarse : nullptr; }
  std::vector<double> net_flux(const FaceValues& v) const override;
  void add_pressure(std::span<const double> p, double by, FaceValues& v) const override;
  double kinetic_energy(const FaceValues& v, const FaceValues& w) const override {
    return kinetic_energy_on(*at_.mesh, v, w);
  }
  double prescribed_power(std::span<const double> p, const FaceValues& v) const override;
  std::vector<double> masses() const override;
  double cells_crossed(const FaceValues& v, double h) const override;

  FlowFriction* friction() override { return this; }
  void begin_friction(const CoupledState& state, NodeInertia nodes, double h) override;
  std::vector<double> add_friction(CoupledState& state, double h, double tolerance, std::span<double> drag) override;
  bool has_dear_digits() const override { return mesh().dim == 3; }
  void take_drive(const FaceValues& change, double h, CoupledState& state) const override;
  void extend_drive(CoupledState& /*state*/) const override {}
  void add_viscous_pressure(double h, std::span<double> missed) const override;

  std::size_t fluid_cells() const override { return at_.mesh->cells(); }
  void add_sums(const CoupledState& state, CoupledSums& sums) const override;
  double pressure_energy(const CoupledState& state) const override;
  void add_summary(Summary& summary) const override;
  Snapshot cell_fields(const CoupledState& state) const override;
  Snapshot mesh_fields(const CoupledState& state) const override;
  Snapshot surface_fields(const CoupledState& state) const override { return {state.time, {}}; }
  Snapshot particle_fields(const CoupledState& state) const override { return {state.time, {}}; }
  std::vector<std::string> take_messages() override { return std::exchange(messages_, {}); }

 private:
  /// The fluid about solids at some places.
  struct Placed {
    std::vector<double> q;  ///< these places
    std::shared_ptr<const FlowMesh> mesh;
    FacePressures pressures;
    std::vector<std::size_t> rows;  ///< 0, 1, ...
    CoarseUnknowns coarse;          ///< in space
    FlowRegions regions;
    CouplingMap map;
  };
  Placed placed(std::span<const double> q) const;
  double pocket() const;
  FlowMesh without_shut_in(FlowMesh mesh) const;
  std::shared_ptr<const FlowMesh> mesh_at(std::span<const double> q) const;
  std::shared_ptr<const FlowMesh> mesh_of(const std::vector<double>& q) const;
  CouplingMap map_of(const Placed& at, std::span<const double> q) const;
  SparseMatrix pressure_matrix(const Placed& at, double by) const;
  static CoarseUnknowns coarse_of(const Placed& at);
  bool is_open(const FlowMesh& mesh, std::size_t face) const;
  double pressure_outside(std::size_t face) const {
    return outside_.pressure_beyond(at_.mesh->boundary[face].number, at_.mesh->middle_of_face(face)[1]);
  }
  /// Calls f(face, cell, pressure outside) for faces of open sides.
  template <class Function>
  void each_open_side(const Function& f) const {
    for (std::size_t face = 0; face < at_.mesh->faces(); ++face) {
      if (at_.pressures.of[face] < 0) f(face, at_.mesh->cell_of(face), pressure_outside(face));
    }
  }
  /// Calls f(face, flux out) for faces that jets blow through or take in.
  template <class Function>
  void each_prescribed(const FaceValues& v, const Function& f) const {
    const FlowMesh& mesh = *at_.mesh;
    for (std::size_t face = 0; face < mesh.faces(); ++face) {
      if (mesh.boundary[face].kind == BoundaryKind::box_side && v[0][mesh.cells() + face] != 0)
        f(face, v[0][mesh.cells() + face]);
    }
  }
  Vec<3> velocity_of_solid(const FlowMesh& old, std::size_t cell, std::span<const double> u, const Vec<3>& fluid) const;
  Vec<3> jet_velocity(const MeshVelocity::Origin& origin, const FlowMesh& old, std::span<const double> speeds,
                      const Vec<3>& fluid) const;
  std::vector<double> pressures_on_faces(const CellFinder& finder, const FlowMesh& old,
                                         std::span<const double> p) const;
  FaceValues still() const;
  bool holds(std::size_t face, int axis) const;
  FaceHolds face_holds(std::span<const double> q) const;
  void rub_with(std::span<const std::size_t> open, std::span<const double> q, double h);
  void note_narrow_cells(CoupledState& state);
  std::vector<double> given_at_faces(const FaceValues& v) const;
  FaceValues drive_from(const CellFinder& finder, const FaceValues& before) const;
  static double most_energy(double before, const CarriedIn& in, CoupledState& state);
  CarriedIn carried_in_by(const FaceValues& v, double h) const;
  void start_smoke(CoupledState& state) const;
  void carry_smoke_to(const FlowMesh& next, double h, CoupledState& state) const;
  double outside_at(double y, double (Outside::*of)(int row) const) const;
  double buoyancy(const Smoke& smoke, std::size_t cell) const {
    return scene_.smoke_lift * smoke.temperature(cell) - scene_.smoke_weight * smoke.density(cell);
  }
  double kinetic_energy_on(const FlowMesh& mesh, const FaceValues& v, const FaceValues& w) const;

  const Coupled& scene_;
  Vec<3> gravity_;  // [acceleration]
  const SolidSurface& surface_;
  FlowSurface with_obstacles_;
  Team& team_;
  Outside outside_;
  Placed at_;
  std::vector<double> kept_q_;  // places that the mesh before fits: a step that is not found begins anew
  std::shared_ptr<const FlowMesh> kept_;
  NodeInertia nodes_;  // of the step's friction
  std::optional<FrictionOnMesh> rubbing_;
  std::vector<std::string> messages_;
};

}  // namespace tether::coupled
