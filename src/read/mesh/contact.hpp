// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/contact.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"

namespace tether {

/// Reports $contact where there are no elastic bodies on a mesh that could meet, or where they are in a fluid.
void check_contact_deck(const Deck& deck, Diagnostics& diagnostics);

/// Returns what $contact says, or what it says by default, of the solids of a scene, whose mesh, regions and integrator
/// are there, without the gap; `walls` are sides of the box that stop them without it. Reports mistakes at their
/// places, and bodies that start beyond a wall or plane or in an obstacle. In the plane obstacles are at z = 0.
Contact read_contact(const Deck& deck, const Scene& scene, const Solids& solids, const std::set<int>& walls,
                     Diagnostics& diagnostics);

/// Returns the same of elastic bodies alone or in a flow, with the gap; nothing without the group.
std::optional<Contact> contact_of(const Deck& deck, const Scene& scene, const Solids& solids, Diagnostics& diagnostics);

}  // namespace tether
