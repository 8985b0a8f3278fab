// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "physics/box/mesh/outline.hpp"

namespace tether::coupled {

/// Points of lattices for a mesh within an outline, each lattice of half the step of the one before, where the sizes
/// about the outline ask for it: equilateral triangles in the plane, body-centred cubes in space. The lattices lie
/// still while the outline moves: so does the mesh, but near to it.
std::vector<Vec<3>> lattice_points(const Outline& outline, const MeshSizes& sizes);

}  // namespace tether::coupled
