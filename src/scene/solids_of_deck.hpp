// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "scene/scene.hpp"
#include "scene/solids.hpp"

namespace tether {

/// The mesh that $reg and $mesh describe by blocks, or the one of the file that $mesh names, whose text the deck must
/// have by then (load_mesh). Mistakes are told at their places: regions that are no quadrilaterals, elements turned
/// inside out, blocks that touch without being joined; and those of a mesh file.
std::optional<Mesh> mesh_of(const Deck& deck, Diagnostics& diagnostics);

/// Adds the elastic bodies that $reg, $mesh and $fem describe, with loads, supports and tracked nodes. A static problem
/// that supports leave free to move as a whole is a mistake of its own.
void add_solids(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

/// Loads of $fem on a mesh, and supports of $fem and of the walls that its nodes stand on at the start.
void add_loads(const Deck& deck, Solids& solids, Diagnostics& diagnostics);
void add_supports(const Deck& deck, const Scene& scene, Solids& solids, Diagnostics& diagnostics);

/// Directions and turns in which the supports leave a connected part of the mesh free, 0 where it is held.
int free_motions(const Solids& solids);

}  // namespace tether
