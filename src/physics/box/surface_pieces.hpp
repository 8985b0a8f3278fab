// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "grid/boxes.hpp"
#include "grid/solid_surface.hpp"

namespace tether::coupled {

/// A point of quadrature on the surface.
struct SurfacePoint {
  Vec<3> x{};       ///< where it is [length]
  Vec<3> share{};   ///< of the side's nodes, their sum is 1
  double part = 0;  ///< of the side's area that it stands for
};

/// Part of a side that lies in one box of a lattice.
struct SurfacePiece {
  int side = 0;
  std::size_t first = 0, count = 0;  ///< of its points
  Vec<3> middle{};                   ///< [length]
  std::array<int, 3> cell{};         ///< of the grid that holds it, which may lie outside the grid
};

/// The surface cut along a lattice of `per_cell` boxes a cell along each axis. Polynomials of degree 2 in the place are
/// integrated exactly over each piece.
struct SurfacePieces {
  std::vector<SurfacePiece> pieces;
  std::vector<SurfacePoint> points;
  std::vector<Vec<3>> area;  ///< of each side, out of the solid [area]
};

SurfacePieces cut_surface(const SolidSurface& surface, std::span<const double> q, const StaggeredGrid& grid,
                          int per_cell);

}  // namespace tether::coupled
