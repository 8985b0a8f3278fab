// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// Has the scene's points run as one row where `reduce` of $mpm asks for it; reports, at its place, why they cannot.
void read_strip(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
