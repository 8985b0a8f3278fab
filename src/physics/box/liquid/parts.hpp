// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "physics/box/friction/strain_rates.hpp"

namespace tether::liquid {

/// Returns how much of each half of a cell along each axis is liquid, by a surface that is flat in each: `distance` is
/// that of the cells' middles from it [cells].
coupled::CellParts liquid_parts(const StaggeredGrid& grid, std::span<const double> distance);

}  // namespace tether::liquid
