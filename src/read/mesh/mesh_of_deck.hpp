// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "read/mesh/mesh_of_file.hpp"

namespace tether {

/// The meshes that $reg and $mesh describe by blocks or by the file that $mesh names, whose text the deck must have by
/// then (load_mesh): of the regions that are a fluid, and of the others. Nothing where there are none of them, or where
/// they are wrong. Mistakes are reported at their places: regions that are no quadrilaterals, elements turned inside
/// out, blocks that touch without being joined; and those of a mesh file.
DeckMeshes meshes_of(const Deck& deck, Diagnostics& diagnostics);

}  // namespace tether
