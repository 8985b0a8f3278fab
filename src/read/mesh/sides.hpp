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
#include "model/solids.hpp"

namespace tether {

/// An edge of the grid, x or y (axis 0, 1) = place, what the deck calls its wall, and the grid's size across it
/// [length].
struct GridEdge {
  AnyVariable variable;
  std::size_t axis;
  double place, size;
  Wall wall;
};
std::array<GridEdge, 4> edges_of(const Scene& scene);
/// Nodes of a mesh that stand at an edge, as near as rounding allows.
std::vector<int> nodes_at(const Mesh& mesh, const GridEdge& edge);

/// The sides of a mesh that variable(k) names, or null where the mesh has none of that name, which it reports.
const Sides* named_sides(const Deck& deck, TextVariable variable, int k, const Mesh& mesh, Diagnostics& diagnostics);

/// What a deck names of a mesh: sides, or a set of nodes of its file; none of them where there is nothing of that name.
struct NamedPart {
  const Sides* sides = nullptr;
  const std::vector<int>* nodes = nullptr;

  /// Returns the nodes, each once, ascending.
  std::vector<int> all_nodes() const;
};
/// Returns what variable(k) names; reports where the mesh has nothing of that name.
NamedPart named_part(const Deck& deck, TextVariable variable, int k, const Mesh& mesh, Diagnostics& diagnostics);

/// Returns the nodes, each once and ascending, of what variable(k) names: a side, a set of nodes, or 'region r' and so
/// the nodes of that region's elements; reports where there is nothing of that name.
std::vector<int> named_nodes(const Deck& deck, TextVariable variable, int k, const Solids& solids,
                             Diagnostics& diagnostics);

/// Reports elements k of the variables `others` that act on nothing, since on(k) is not given: "load 3"
/// where `what` is "load".
void check_all_act(const Deck& deck, const char* what, AnyVariable on, Variables others, Diagnostics& diagnostics);

}  // namespace tether
