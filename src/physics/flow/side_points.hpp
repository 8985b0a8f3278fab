// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "grid/mesh.hpp"
#include "physics/flow/plane_elements.hpp"

namespace tether::fem {

/// A point of quadrature on a side of a mesh, as its element sees it.
struct SidePoint {
  std::size_t element = 0;
  PlanePoint at;     ///< in the reference element, with all of the element's functions
  Vec<2> normal{};   ///< outward, as long as the point's part of the side [length]
  PlaneVectors G{};  ///< gradients of the functions [1/length]
};

/// Appends the points of quadrature of these sides of a mesh of quadrilaterals.
void add_side_points(const Mesh& mesh, const Sides& sides, std::vector<SidePoint>& points);

}  // namespace tether::fem
