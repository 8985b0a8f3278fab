// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/mesh.hpp"
#include "model/scene.hpp"

namespace tether {

/// An edge of the grid, x or y (axis 0, 1) = place, what the deck calls its wall, and the grid's size across it
/// [length].
struct GridEdge {
  const char* variable;
  std::size_t axis;
  double place, size;
  Wall wall;
};
std::array<GridEdge, 4> edges_of(const Scene& scene);
/// Nodes of a mesh that stand at an edge, as near as rounding tells.
std::vector<int> nodes_at(const Mesh& mesh, const GridEdge& edge);

/// The sides of a mesh that variable(k) of a group names, or null where the mesh has none of that name, which is told.
const Sides* named_sides(const Deck& deck, const std::string& group, const std::string& variable, int k,
                         const Mesh& mesh, Diagnostics& diagnostics);

/// Tells of elements k of the group's variables `others`, "load 3" where `what` is "load", that act on nothing: on(k)
/// is not given.
void check_all_act(const Deck& deck, const std::string& group, const std::string& what, const std::string& on,
                   const std::vector<std::string>& others, Diagnostics& diagnostics);

}  // namespace tether
