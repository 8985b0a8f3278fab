// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// Adds each membrane that $membrane gives by curves as a body: points at rest and without stress, equally spaced along
/// its joined curves. A point's volume is thickness times its piece of the curve times the depth at the point: about an
/// axis that is the ring of the point's own radius, as it is for points of regions and files.
void add_membranes(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
