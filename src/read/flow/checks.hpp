// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/flow.hpp"
#include "model/scene.hpp"

namespace tether {

/// Returns whether the deck has what a fluid's mesh is made of; reports what it has instead: no region that is a fluid,
/// rigid bodies, no $mesh, a depth, a fluid that is blocks in part and of a file in part.
bool check_flow_frame(const Deck& deck, Diagnostics& diagnostics);

/// Reports what the deck asks for beside a fluid and cannot have, and what has no effect.
void check_flow_deck(const Deck& deck, Diagnostics& diagnostics);

/// Moves probes that are outside the fluid's mesh by less than half an element to its edge, with a warning; reports
/// probes further outside.
void place_probes(const Deck& deck, Flow& flow, Diagnostics& diagnostics);

/// Moves nodes of immersed bodies that are outside the fluid's mesh by less than a tenth of an element's side to its
/// edge, with a warning: on curved walls the bodies' nodes and the fluid's sides come only near to one another. Reports
/// nodes further outside or on an inflow, sides of bodies that an edge or a hole of the fluid's mesh crosses, elements
/// in a hole, and such edges within a body.
void place_bodies(const Deck& deck, Scene& scene, const Flow& flow, Diagnostics& diagnostics);

/// Reports expressions that have no finite value where and when they are first asked, and velocities of moving walls
/// that go through them; of prescribed velocities that bring more into a fluid without an open side than out of it.
void check_flow_velocities(const Deck& deck, const Clock& clock, const Flow& flow, Diagnostics& diagnostics);
/// The last of these. The velocities are finite when they are first asked.
void check_flow_balance(const Deck& deck, const Clock& clock, const Flow& flow, Diagnostics& diagnostics);

/// When prescribed velocities are first asked [time]: a steady flow has those of its end.
double first_time(const Flow& flow, const Clock& clock);

}  // namespace tether
