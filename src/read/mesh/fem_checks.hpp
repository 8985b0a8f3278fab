// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "model/scene.hpp"

namespace tether {

/// Reports all that a deck asks for and finite elements cannot represent, each at its place: bodies of points that are
/// no strings, membranes in plane stress, an axis, a pressure outside, a string with two neighbours in one place. Warns
/// of what $mpm asks for, which has no effect there.
void check_fem(const Deck& deck, const std::optional<ParticleFile>& particles, const Scene& scene,
               Diagnostics& diagnostics);

/// Takes the outputs that need a grid from a scene that runs by bars, and warns where the deck asks for them.
void drop_grid_outputs(const Deck& deck, Scene& scene, Diagnostics& diagnostics);

}  // namespace tether
