// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "base/diagnostics.hpp"
#include "deck/deck.hpp"
#include "deck/particle_file.hpp"
#include "laws/materials/material.hpp"

namespace tether {

/// The law of region r (from 1) by ipath(4, r), with the constants of matr and $fluid; $mpm density wins over it.
std::optional<Material> region_material(const Deck& deck, int r, Diagnostics& diagnostics);

/// The law of a particle file by its own ipath(4) and constants.
std::optional<Material> file_material(const Deck& deck, const ParticleFile& file, Diagnostics& diagnostics);

/// The law of membrane b (from 1) with Young's modulus E and Poisson's ratio nu.
Membrane membrane_law(const Deck& deck, int b, double E, double nu);

}  // namespace tether
