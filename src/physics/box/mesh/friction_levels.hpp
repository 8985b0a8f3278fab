// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algebra/sparse_solver.hpp"
#include "algebra/two_level.hpp"
#include "physics/box/friction/node_inertia.hpp"
#include "physics/box/mesh/mesh_map.hpp"
#include "physics/box/mesh/strain_on_mesh.hpp"

namespace tether::coupled {

/// What the velocities in the middles of a mesh's faces are while friction acts: unknowns of their own, sums of those
/// of a solid's nodes, or given.
struct FaceHolds {
  /// What solids make of the velocity of a face that the fluid sticks to.
  struct Carried {
    std::size_t face;
    NodeShares nodes;
  };
  std::vector<std::uint8_t> held;  ///< dim a face: 1 where it is given or carried
  std::vector<Carried> carried;
  std::vector<std::pair<std::size_t, NodeShares>> corners;  ///< nodes of the mesh at such faces, likewise
};

/// Preconditioner for the velocities of faces and nodes by friction, without jumps, by factors in the plane and by two
/// levels in space. Numbers stand dim a face, then dim a node of the solids. Axes are not apart: what ties a cell to
/// its faces are fluxes, which have parts along all of them.
class FrictionLevels {
 public:
  /// Throws RunError where there are no factors. Calls BLAS.
  FrictionLevels(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds, const NodeInertia& nodes);

  /// Returns whether a number is free: that of a face or a node which nothing holds. Where no face is carried no node
  /// is.
  bool is_free(std::size_t number) const { return unknown_[number] >= 0; }
  /// z = P^-1 r for the numbers that are free; 0 for others.
  void precondition(std::span<const double> r, std::span<double> z);

 private:
  void number_unknowns(const FaceHolds& holds, const NodeInertia& nodes);
  std::vector<NodeShares> unknowns_of_faces(const FlowMesh& mesh, const FaceHolds& holds) const;
  SparseMatrix matrix(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                      const NodeInertia& nodes) const;
  CoarseUnknowns coarse(const FlowMesh& mesh, const FaceHolds& holds) const;

  std::size_t of_faces_;             // numbers of faces
  std::vector<int> unknown_;         // of each number; -1: none
  std::vector<std::size_t> number_;  // of each unknown
  bool two_levels_;
  SparseSolver factors_;
  TwoLevelPreconditioner levels_;
  std::vector<double> r_, z_;
};

}  // namespace tether::coupled
