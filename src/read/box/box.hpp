// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/coupled.hpp"
#include "model/scene.hpp"
#include "model/solids.hpp"

namespace tether {

/// Adds the fluid in a box that $in and $coupled describe, and the solids of $reg, $mesh and $fem where the deck has a
/// mesh. Mistakes are reported at their places.
void add_coupled(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

/// Jets by jet_on and what belongs to it, each with its part of the side.
void add_jets(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics);

/// Openings by open_on, likewise.
void add_openings(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics);

/// Obstacles and voids.
void add_boxes(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics);

/// Obstacles that are no boxes.
void add_shaped_obstacles(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics);

/// Adds what the deck says of a liquid with a surface.
void add_liquid(const Deck& deck, Coupled& coupled, Diagnostics& diagnostics);

/// Returns how solids meet in steps that keep the energy: the box's walls and obstacles, where its contact is not
/// switched off, and what $contact says; nothing without either. Sides with nodes that supports hold at walls meet
/// nothing. Reports mistakes at their places, and bodies that touch at the start.
std::optional<Contact> contact_in_box(const Deck& deck, const Scene& scene, const Coupled& coupled,
                                      const Solids& solids, Diagnostics& diagnostics);

/// Springs on nodes of the solids.
void add_springs(const Deck& deck, const Solids& solids, Coupled& coupled, Diagnostics& diagnostics);
/// Hinges, as supports of the solids.
void add_hinges(const Deck& deck, Solids& solids, Diagnostics& diagnostics);

}  // namespace tether
