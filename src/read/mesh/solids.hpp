// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"
#include "read/mesh/sides.hpp"

namespace tether {

/// Adds the bodies on a mesh that $reg, $mesh and $fem describe, with loads, supports and tracked places; with $rigid
/// they are one rigid body, without laws and supports. A static problem that supports leave free to move as a whole is
/// a mistake of its own.
void add_solids(const Deck& deck, Scene& scene, Diagnostics& diagnostics);
/// Does the same on a mesh that has been made; nothing where it is wrong, which has been reported.
void add_solids_on(std::optional<Mesh> mesh, const Deck& deck, Scene& scene, Diagnostics& diagnostics);

/// Loads of $fem on a mesh, and supports of $fem and of the walls that its nodes stand on at the start.
void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics);
void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics);

/// Reports what a deck with a mesh says without effect, of points, membranes and regions that there are none of; and of
/// an axis, which elastic bodies do not have.
void check_mesh_deck(const Deck& deck, Diagnostics& diagnostics);
/// Reports an edge of the grid that goes through the mesh and whose wall would hold `held` nodes.
void check_wall(const Deck& deck, const Mesh& mesh, const GridEdge& edge, std::size_t held, Diagnostics& diagnostics);
/// Warns of bodies that overlap at the start; where contact stops them at one another that is a mistake.
void check_overlaps(const Deck& deck, const Solids& solids, Diagnostics& diagnostics);
/// Reports supports that move one node along one axis to different places.
void check_supports_agree(const Deck& deck, const Solids& solids, Diagnostics& diagnostics);

/// Directions and turns in which the supports leave a connected part of the mesh free, 0 where it is held.
int free_motions(const Solids& solids);

}  // namespace tether
