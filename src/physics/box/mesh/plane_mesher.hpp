// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Returns triangles of the fluid that an outline bounds: each of its segments is an edge, or several where others meet
/// it. Inside are points of lattices of equilateral triangles, coarse ones far from short segments, and edges are
/// Delaunay's but for those of the outline. The same outline gives the same bits. Throws RunError where segments cross.
FlowMesh plane_mesh(const Outline& outline, const MeshSizes& sizes);

}  // namespace tether::coupled
