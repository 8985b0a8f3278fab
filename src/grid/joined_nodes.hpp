// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "grid/mesh.hpp"

namespace tether {

/// For each node the lowest number of a node at its place, to 1e-9 of the mesh's size.
std::vector<int> lowest_at_place(const Mesh& mesh);

/// Nodes at one place, to 1e-9 of the mesh's size, become one, with the lowest of their numbers; the others follow in
/// their order. Returns the new number of each node. Sides that are there already are not renumbered.
std::vector<int> join_nodes(Mesh& mesh);

}  // namespace tether
