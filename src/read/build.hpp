// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "model/scene.hpp"

namespace tether {

/// Reports what can be said of a deck of which no scene can be made, for want of a grid or a clock: mistakes in its
/// regions.
void check_without_grid(const Deck& deck, Diagnostics& diagnostics);

/// Builds what a deck and its particle file ask for. Mistakes go into `diagnostics`; with errors there, the scene is
/// not to be used. Refuses, before it allocates, what this machine's memory cannot hold.
Scene build_scene(const Deck& deck, const std::optional<ParticleFile>& particles, Path path, Diagnostics& diagnostics);

}  // namespace tether
