// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "scene/scene.hpp"
#include "scene/solids.hpp"

namespace tether {

/// The meshes that $reg and $mesh describe by blocks or by the file that $mesh names, whose text the deck must have by
/// then (load_mesh): of the regions that are a fluid, and of the others. Nothing where there are none of them, or where
/// they are wrong. Mistakes are reported at their places: regions that are no quadrilaterals, elements turned inside
/// out, blocks that touch without being joined; and those of a mesh file.
struct DeckMeshes {
  std::optional<Mesh> fluid, bodies;
};
DeckMeshes meshes_of(const Deck& deck, Diagnostics& diagnostics);

/// Adds the bodies on a mesh that $reg, $mesh and $fem describe, with loads, supports and tracked places; with $rigid
/// they are one rigid body, without laws and supports. A static problem that supports leave free to move as a whole is
/// a mistake of its own.
void add_solids(const Deck& deck, Scene& scene, Diagnostics& diagnostics);
/// The same on a mesh that has been made; nothing where it is wrong, which has been reported.
void add_solids_on(std::optional<Mesh> mesh, const Deck& deck, Scene& scene, Diagnostics& diagnostics);

/// Loads of $fem on a mesh, and supports of $fem and of the walls that its nodes stand on at the start.
void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics);
void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics);

/// The factor that $group gives as what_time and what_factor in column k, or as what_expression(k); where it gives
/// neither, a static problem's grows in proportion to time.
Amplitude amplitude_of(const Deck& deck, const std::string& group, const std::string& what, int k,
                       Diagnostics& diagnostics);

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

/// Tells what a deck with a mesh says without effect, of points, membranes and regions that there are none of; and of
/// an axis, which elastic bodies do not have.
void check_mesh_deck(const Deck& deck, Diagnostics& diagnostics);
/// Tells of an edge of the grid that goes through the mesh and whose wall would hold `held` nodes.
void check_wall(const Deck& deck, const Mesh& mesh, const GridEdge& edge, std::size_t held, Diagnostics& diagnostics);
/// Warns of bodies that overlap at the start.
void check_overlaps(const Deck& deck, const Solids& solids, Diagnostics& diagnostics);
/// Tells of supports that move one node along one axis to different places.
void check_supports_agree(const Deck& deck, const Solids& solids, Diagnostics& diagnostics);

/// Directions and turns in which the supports leave a connected part of the mesh free, 0 where it is held.
int free_motions(const Solids& solids);

}  // namespace tether
