// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/boxes.hpp"
#include "grid/solid_surface.hpp"

namespace tether {

/// How often the surfaces of all bodies but one go round x: 1 within a solid, more where several overlap, 0 outside.
double turns_about(const SolidSurface& surface, std::span<const double> q, const Vec<3>& x, int but_part);

/// Where the line between the middles of two neighbouring cells meets the solids' surface.
struct Crossing {
  int side = 0;
  Vec<3> share{};    ///< of the side's nodes
  double place = 0;  ///< along the line's axis [length]
};

/// Of all lines through the cells' middles along the axes. A line between the middles of cells i - 1 and i belongs to
/// face i, at the ends of the box to the side's face.
struct Crossings {
  std::vector<Crossing> all;
  std::array<std::vector<int>, 3> lowest, highest;  ///< crossing of each face, by number in `all`; -1: none
  std::vector<std::uint8_t> inside;                 ///< of each cell, in how many solids its middle lies
  std::vector<std::uint8_t> in_cavity;              ///< of each cell, whether it lies in a cavity of a solid
};

/// Solids that overlap are one, and what sticks out of the box is no crossing, but counts for what is inside.
Crossings find_crossings(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid);

}  // namespace tether
