// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "physics/box/mesh/flow_mesh.hpp"
#include "physics/box/outside.hpp"

namespace tether::coupled {

/// A velocity and how it changes from place to place.
struct FlowAtNode {
  Vec<3> v{};                                    ///< [velocity]
  std::array<std::array<double, 2>, 2> slope{};  ///< [a][b]: of v_a along b [1/time]
};

/// The flow at each node of triangles: free of divergence, quadratic, and at the boundary linear, where a quadratic one
/// is not held. Its stream function is the one whose differences between the ends of the faces about the node fit the
/// fluxes through them best (least squares; near faces weigh more). `v` has, along each axis, a number for each cell,
/// and is free of divergence.
std::vector<FlowAtNode> flow_at_nodes(const FlowMesh& mesh, const FaceValues& v);

}  // namespace tether::coupled
