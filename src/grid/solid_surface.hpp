// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// The surface of solids made of triangles or tetrahedra: edges in the plane, triangles in space. Places q have dim
/// numbers a node.
struct SolidSurface {
  int dim = 2;
  Sides sides;             ///< dim nodes each; in the plane the solid is to the left of an edge, in space below a
                           ///< triangle whose nodes turn counter-clockwise as seen from above
  std::vector<int> sheet;  ///< of each side the connected part of the surface that it belongs to, from 0
  int sheets = 0;
  std::vector<std::uint8_t> cavity;  ///< of each sheet, whether the solid is around it
  std::vector<int> part;             ///< of each side the connected body, from 0
  int parts = 0;

  std::size_t side_count() const { return sheet.size(); }
  std::span<const int> side(std::size_t s) const {
    return std::span(sides).subspan(s * static_cast<std::size_t>(dim), static_cast<std::size_t>(dim));
  }
};

/// Returns the surface of a mesh of triangles or tetrahedra.
SolidSurface surface_of(const Mesh& mesh);

/// Place of a node; z is 0 in the plane.
Vec<3> place_of(std::span<const double> q, int node, int dim);

/// Volume enclosed by each sheet, per unit depth in the plane: positive where the solid is inside, negative around a
/// cavity [volume].
std::vector<double> enclosed_volumes(const SolidSurface& surface, std::span<const double> q);

/// A side's area times its normal out of the solid, per unit depth in the plane [area].
Vec<3> area_of_side(const SolidSurface& surface, std::size_t side, std::span<const double> q);

}  // namespace tether
