// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/mesh/flow_mesh.hpp"
#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Tetrahedra within an outline in space: Delaunay ones by TetGen of its facets, which stay as they are, and of lattice
/// points. The same outline makes the same mesh to the last bit. Throws RunError, with a place, where facets cross or
/// touch each other.
FlowMesh space_mesh(const Outline& outline, const MeshSizes& sizes);

}  // namespace tether::coupled
