// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/friction/rubbed.hpp"
#include "physics/box/mesh/friction_levels.hpp"
#include "physics/box/mesh/strain_on_mesh.hpp"
#include "physics/box/state.hpp"

namespace tether::coupled {

/// What friction in a fluid on a mesh does to the velocities of its cells in a time h. They become, with those in the
/// middles of the faces and those of the solids' nodes, the ones of which
///     1/2 sum m (v - v*)^2 + h (half the power that friction takes)
/// is least: implicit and stable for any h. Faces that nothing holds have no mass of their own.
class FrictionOnMesh {
 public:
  /// mu is a viscosity [stress time]; through `open` faces the flow goes on as it comes. The mesh must outlive it.
  /// Throws RunError where values ran away.
  FrictionOnMesh(const FlowMesh& mesh, FaceHolds holds, std::span<const std::size_t> open, double density, double mu,
                 NodeInertia nodes, double h);
  FrictionOnMesh(const FrictionOnMesh&) = delete;
  FrictionOnMesh& operator=(const FrictionOnMesh&) = delete;

  /// Lets friction act on velocities v of the cells and u of the nodes, to a tolerance of conjugate gradients, with the
  /// faces that are held at velocities `given`, dim a face. `driven` is the acceleration by pressures and forces. It
  /// acts meanwhile, and at the end h times it is taken back; so are the nodes.
  Rubbed act(Team& team, std::span<const double> u, std::span<const double> driven_nodes, double tolerance,
             std::span<const double> given, const FaceValues& driven, FaceValues& v);

 private:
  void carry(std::span<double> x) const;
  void pass_on(std::span<double> y) const;
  std::vector<double> pulls_of(const FaceValues& v) const;
  std::vector<double> forces(Team& team, std::span<const double> pulls, std::span<const double> x);
  int solve(Team& team, std::span<const double> pulls, std::span<const double> u, double tolerance);
  void begin_with(const FaceValues& v, std::span<const double> u, std::span<const double> driven_to,
                  std::span<const double> given);
  std::size_t node(std::size_t k) const { return holds_.held.size() + k; }
  std::span<double> nodes_of(std::span<double> x) const { return x.subspan(holds_.held.size()); }

  const FlowMesh& mesh_;
  FaceHolds holds_;
  double h_;
  NodeInertia nodes_;
  std::vector<double> masses_;  // of each number of the nodes
  StrainOnMesh strain_;
  FrictionLevels levels_;
  std::vector<double> x_;  // of each number of the faces, then of the nodes: what was found last
  bool begun_ = false;
};

}  // namespace tether::coupled
