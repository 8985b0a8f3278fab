// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/coupled.hpp"
#include "physics/box/liquid/near_solids.hpp"
#include "physics/box/liquid/particles.hpp"
#include "physics/box/outside.hpp"

namespace tether::liquid {

/// Returns the particles of a scene's liquid at the start: one for each small box, so many of which make up a cell,
/// that a region of liquid has a part of, as large as this part and at its middle. So each region has its true volume,
/// and its edge is where the deck has it. Of regions that overlap the first one has a place; solids and obstacles have
/// it before them.
/// `without` gets the numbers of regions that have no particle.
Particles seed(const Coupled& scene, const coupled::FlowDomain& room, const NearSolids& solids,
               std::vector<int>* without = nullptr);

}  // namespace tether::liquid
