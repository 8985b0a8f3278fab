// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The deck with the text of the mesh file that its $mesh names (relative to the deck, at most one folder up); the deck
/// as it is where it names none, or where the file cannot be read or is not the one that deck.effective meant, which is
/// reported.
Deck load_mesh(const Deck& deck, Diagnostics& diagnostics);

/// The meshes of the regions that are a fluid, and of the others, where there are any.
struct DeckMeshes {
  std::optional<Mesh> fluid, bodies;
};

/// Returns whether region r is a physical group of the file that $mesh names. In a deck with a fluid a region that has
/// vertices is a block all the same.
bool is_of_file(const Deck& deck, int r);

/// Reports a fluid, or bodies in it, that are of the file in part and blocks in part, and a file that no region is of.
/// Returns whether there is none of that.
bool check_sources(const Deck& deck, Diagnostics& diagnostics);

/// The meshes of those regions that are of the file. Mistakes are reported at their places in the file or in the deck.
DeckMeshes meshes_of_file(const Deck& deck, Diagnostics& diagnostics);

/// An error or a warning at the place where the deck says what region r is: its group, its vertices, or nreg.
Diagnostic remark_on_region(const Deck& deck, Severity severity, int r, const std::string& message,
                            const std::string& hint);

}  // namespace tether
