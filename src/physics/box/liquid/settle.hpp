// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "physics/box/coupling_map.hpp"
#include "physics/box/liquid/surface.hpp"

namespace tether::liquid {

/// Returns for each pressure's cell by how much volume liquid is to be moved out of it in a step, so that particles
/// neither crowd nor thin out: a quarter of what a hat about it holds too much, or, within the liquid, too little
/// [volume].
std::vector<double> crowding(const StaggeredGrid& grid, std::span<const double> distance, std::span<const double> open,
                             const coupled::PressureNumbers& numbers, std::span<const double> filled);

}  // namespace tether::liquid
