// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/contact.hpp"
#include "model/solids.hpp"

namespace tether {

/// Checks how bodies with a contact stand at the start: warns of laws that fail where they are squeezed, reports
/// obstacles that reach into bodies and surfaces that touch, and sets the gap where the deck gives none.
void check_contact(const Deck& deck, const Solids& solids, Contact& contact, Diagnostics& diagnostics);

}  // namespace tether
