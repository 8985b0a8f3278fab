// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "grid/staggered_grid.hpp"

namespace tether {
class SideFaces;
}

namespace tether::coupled {

/// What a cell holds. Fluid cells have a pressure; in void ones it is zero.
enum class CellKind : std::uint8_t { fluid, solid, wall, empty };

/// What a face does: its velocity is found with the pressure; or is prescribed by a wall or a jet; or a solid closes
/// it.
enum class FaceKind : std::uint8_t { open, prescribed, closed };

/// A number for each face, by axis.
using FaceValues = std::array<std::vector<double>, 3>;

FaceValues face_values(const StaggeredGrid& grid, double value = 0);

/// Where fluid is and which faces it goes through, during one step.
struct FlowDomain {
  StaggeredGrid grid;
  std::vector<CellKind> kind;                 ///< of each cell
  std::array<std::vector<FaceKind>, 3> face;  ///< of each face
  FaceValues area;                            ///< open area of each face; 0 where closed [area]
  FaceValues volume;                          ///< of the fluid that an open face's velocity moves [volume]
  std::vector<int> region;                    ///< of each fluid cell, from 0: cells that open faces join; else -1
  int regions = 0;
  std::shared_ptr<const SideFaces> sides = nullptr;  ///< what the box's sides are where no solid is; null: no openings
};

/// Cells on the two sides of a face across the axis, lower first; -1 outside the box.
std::array<int, 2> cells_beside(const StaggeredGrid& grid, int axis, std::size_t face);

}  // namespace tether::coupled
