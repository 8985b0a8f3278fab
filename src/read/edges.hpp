// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// The edges of $mpm, which take the place of their walls: those become open.
Edges edges_of(const Deck& deck, Walls& walls, Diagnostics& diagnostics);

/// Once the bodies are there: which gas comes in, and what must not stand at an open edge.
void check_edges(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
