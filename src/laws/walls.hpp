// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "base/words.hpp"

namespace tether {

/// What an edge of the grid does; the numbers are the deck's wl, wr, wb, wt.
enum class Wall { fixed = 0, open = 1, symmetry = 4, axis = 5, free_slip = 6 };
template <>
inline constexpr std::array<Word<Wall>, 5> words<Wall>{
    {{Wall::fixed, "0"}, {Wall::open, "1"}, {Wall::symmetry, "4"}, {Wall::axis, "5"}, {Wall::free_slip, "6"}}};

/// Axis bits of the momentum components that a node holds at zero.
enum Held : std::uint8_t { holds_none = 0, holds_x = 1, holds_y = 2 };

/// Symmetry, axis and free slip hold the component across the wall; a fixed wall holds both; an open one none.
constexpr std::uint8_t held_by(Wall wall, Held normal) {
  if (wall == Wall::open) return holds_none;
  return wall == Wall::fixed ? std::uint8_t{holds_x | holds_y} : std::uint8_t{normal};
}

/// Returns whether what lies beyond the wall is the image of what lies inside, for quadratic densities and normals.
constexpr bool mirrors(Wall wall) { return wall == Wall::symmetry || wall == Wall::axis || wall == Wall::free_slip; }

struct Walls {
  Wall left = Wall::free_slip, right = Wall::free_slip, bottom = Wall::free_slip, top = Wall::free_slip;
};

}  // namespace tether
