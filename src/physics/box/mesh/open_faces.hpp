// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// A part `by` x_i x_j of half a power.
struct Couple {
  std::size_t i, j;
  double by;
};

/// Returns what open faces, across an axis of the box, have of half the power of 2 D:D, by viscosity, for a flow to go
/// on as it comes: -(w_t d_t w_n - w_n d_t w_t) / 2 of each axis t along them, w_n going out. All but corners is then
/// as if the power were |grad w|^2. Velocities along the faces are linear between the faces' nodes, and these have the
/// means of the faces about them, or 0 where a face of the boundary is held. Numbers stand dim a face, as in `held`.
std::vector<Couple> couples_at(const FlowMesh& mesh, std::span<const std::size_t> open,
                               std::span<const std::uint8_t> held);

}  // namespace tether::coupled
