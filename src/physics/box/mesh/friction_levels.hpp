// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algebra/sparse_solver.hpp"
#include "algebra/two_level.hpp"
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

/// Preconditioner for the velocities of faces and nodes by friction: each axis by itself, without jumps, by factors in
/// the plane and by two levels in space. Numbers stand dim a face, then dim a node of the solids.
class FrictionLevels {
 public:
  /// `mass` is that of each number of the nodes, 0 where it is held [mass]. Throws RunError where there are no factors.
  /// Calls BLAS.
  FrictionLevels(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                 std::span<const double> mass);

  /// z = P^-1 r for the numbers that are free.
  void precondition(std::span<const std::uint8_t> is_free, std::span<const double> r, std::span<double> z);

 private:
  void number_faces(const FlowMesh& mesh, const FaceHolds& holds);
  void number_nodes(const FaceHolds& holds, std::span<const double> mass);
  SparseMatrix matrix(const FlowMesh& mesh, const StrainOnMesh& strain, const FaceHolds& holds,
                      std::span<const double> mass) const;
  CoarseUnknowns coarse(const FlowMesh& mesh, const FaceHolds& holds) const;

  std::size_t dim_, faces_;
  std::vector<int> of_face_, of_node_;  // unknowns of an axis, -1: none
  std::size_t count_ = 0;
  bool two_levels_;
  SparseSolver factors_;
  TwoLevelPreconditioner levels_;
  std::vector<double> r_, z_;
};

}  // namespace tether::coupled
