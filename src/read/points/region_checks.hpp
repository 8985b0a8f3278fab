// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "model/scene.hpp"

namespace tether {

/// Warns of regions whose points hold another volume than the deck draws, that share space, and of a region of gas on
/// both sides of a closed membrane.
void check_regions(const Deck& deck, const Scene& scene, Diagnostics& diagnostics);

/// A line for each region of points: area and mass that it has by its points, next to those that the deck draws.
std::string regions_text(const Deck& deck, const Scene& scene);

}  // namespace tether
