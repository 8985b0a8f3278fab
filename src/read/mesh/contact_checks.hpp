// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/contact.hpp"
#include "model/solids.hpp"

namespace tether {

/// Warns of the first region whose law fails where it is squeezed.
void warn_of_laws(const Deck& deck, const Solids& solids, Diagnostics& diagnostics);

/// Reports the first obstacle of $contact, or of $coupled, that an edge of reaches into a body at the start.
void check_obstacles(const Deck& deck, const Solids& solids, const Contact& contact, Diagnostics& diagnostics);

/// Sets the gap of a contact that the deck gives none: a tenth of the shortest side of the surface, or what surfaces
/// that meet are apart at the start where that is less and the bodies move (of an equilibrium: only where a body is so
/// near to itself by its shape). Reports surfaces that touch at the start, between which no barrier can stand, and a
/// gap of the deck that presses bodies at the start.
void find_gap(const Deck& deck, const Solids& solids, Contact& contact, Diagnostics& diagnostics);

}  // namespace tether
