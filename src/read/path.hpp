// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/physics.hpp"

namespace tether {

/// The path that $in names, or where it names none, the one that the deck's groups ask for: coupled with $coupled, fem
/// with $fem, $mesh, $rigid or $flow, else mpm. The coupled path without $coupled is an error.
Path path_of(const Deck& deck, Diagnostics& diagnostics);

/// The deck without what only other paths have a use for, if $in names the path: so one deck describes a scene for
/// several paths. What is left out is a remark, one a group, and a warning where it acts on the scene. The same deck
/// where $in names none.
Deck deck_of_path(const Deck& deck, Path path, Diagnostics& diagnostics);

/// Returns whether a deck whose regions are bodies on a mesh has a use for a variable that points, or the grid, have
/// one for.
bool is_of_meshes(const Variable& variable);

}  // namespace tether
