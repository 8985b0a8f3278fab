// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "grid/background_grid.hpp"
#include "grid/staggered_grid.hpp"

namespace tether {

/// Why a grid with so many points cannot be held, with the memory it would need; empty where it can. Counts against
/// the machine's physical memory, and the node numbers' range.
std::string memory_refusal(const BackgroundGrid& grid, double points);

/// The same of a fluid's cells, with the systems that couple it to bodies.
std::string memory_refusal(const StaggeredGrid& grid);

}  // namespace tether
