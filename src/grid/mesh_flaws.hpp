// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// What is wrong with a mesh: of which element or node, and where.
struct MeshFlaw {
  std::size_t region = 0;  ///< from 0
  std::string message;
  std::string hint = {};  ///< what would be right
};

/// "(x, y)" or "(x, y, z)" of a place, and of a node.
std::string place_text(const Vec<3>& x, int dim);
std::string place_text(const Mesh& mesh, int node);

/// Elements whose Jacobian is not positive at a point of quadrature, in ascending order.
std::vector<std::size_t> inverted_elements(const Mesh& mesh);
/// Finds the first of these in each region.
void find_inverted(const Mesh& mesh, std::vector<MeshFlaw>& flaws);

/// A node within a side of the boundary that does not have it: parts that touch without being joined. With the regions
/// of both, from 0.
struct HangingNode {
  int node = 0;
  int region = 0, region_of_side = 0;
};
std::optional<HangingNode> hanging_node(const Mesh& mesh);
/// Reports it; `numbers` are the deck's of the regions.
void find_hanging(const Mesh& mesh, const std::vector<int>& numbers, std::vector<MeshFlaw>& flaws);

/// Pairs of nodes in one place, to 1e-9 of the mesh's size: each node with the lowest one there, in ascending order.
std::vector<std::pair<int, int>> coinciding_nodes(const Mesh& mesh);

}  // namespace tether
