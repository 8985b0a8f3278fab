// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "grid/mesh.hpp"

namespace tether::cases {

/// A plane mesh of quadrangles and its place in a file: which physical group it is, by tag.
struct PlacedMesh {
  Mesh mesh;
  int tag = 1;
};

/// A file of Gmsh, version 2.2 of its format, of meshes with nodes of their own, whose regions are groups of the tags
/// `tag`, `tag` + 1, ..., and whose named sides are groups of curves. Nodes and elements have numbers at random, stand
/// in an order at random, and each element begins with a corner at random, as `seed` has it.
std::string gmsh_text(const std::vector<PlacedMesh>& meshes, unsigned seed);

}  // namespace tether::cases
