// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/mesh.hpp"
#include "model/coupled.hpp"
#include "model/scene.hpp"

namespace tether {

/// Returns whether the deck describes a box of cells that the memory holds and, with $mesh, bodies of as many
/// dimensions, so that a scene can be made; reports what it has instead: $flow, rigid bodies, an axis, a depth without
/// ends.
bool check_coupled_frame(const Deck& deck, Diagnostics& diagnostics);

/// Reports what the deck asks for and cannot have with $coupled, and what has no effect there. `energy`: whether steps
/// keep that of bodies.
void check_coupled_deck(const Deck& deck, const Coupled& coupled, bool energy, Diagnostics& diagnostics);

/// Reports nodes of bodies outside the box or in an obstacle, of each region the first, and jets in bodies or obstacles
/// and jets that meet no face.
void check_coupled_places(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics);

/// Reports a box without a cell of fluid, cavities that there are none of, and parts of it that nothing but walls and
/// obstacles close, into which jets bring more than out of them, bodies left aside.
void check_coupled_regions(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics);

/// Reports what a liquid with a surface cannot have in its box, regions of it that bodies and obstacles have all of,
/// jets that come in through obstacles, and what the deck says of a liquid that it has none of. Warns of steps too long
/// for waves of its surface, of friction at it, and of bodies in a box with obstacles that cut cells.
void check_liquid(const Deck& deck, const Scene& scene, const Coupled& coupled, Diagnostics& diagnostics);

/// Reports what a flow on a mesh cannot have in its box, and what the deck says of a mesh that there is none of.
void check_flow_mesh(const Deck& deck, const Coupled& coupled, Diagnostics& diagnostics);

/// Returns whether bodies of triangles or tetrahedra, with or without obstacles, part cells of fluid from those at the
/// box's sides: a step from a cell's middle to the next one's does not go through a body.
bool encloses_cells(const Coupled& coupled, const Mesh& mesh);

}  // namespace tether
