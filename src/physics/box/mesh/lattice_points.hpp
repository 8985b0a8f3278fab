// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Returns points inside an outline's extent for a mesh of these sizes: of lattices of equilateral triangles, each of
/// half the size of the one before, those points where the mesh is to have about its size. They stay away from the
/// outline, and from one another.
std::vector<Vec<3>> lattice_points(const PlaneOutline& outline, const MeshSizes& sizes);

}  // namespace tether::coupled
