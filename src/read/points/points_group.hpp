// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"

namespace tether {

/// The particle data of a deck with igen 0 or 3: from `given` (the command line's --particles), else from the file that
/// $in particles names (relative to the deck, at most one folder up), else from after the deck's last group. Nothing
/// for igen 1, nor for igen 3 where none of these is there but membranes are given by curves.
std::optional<ParticleFile> load_particles(const Deck& deck, const std::optional<std::filesystem::path>& given,
                                           Diagnostics& diagnostics);

}  // namespace tether
