// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "scene/scene.hpp"

namespace tether {

/// What a deck and its particle file ask for. Mistakes go into `diagnostics`; with errors there, the scene is not to be
/// used. Refuses, before it allocates, what this machine's memory cannot hold.
Scene build_scene(const Deck& deck, const std::optional<ParticleFile>& particles, Path path, Diagnostics& diagnostics);

}  // namespace tether
