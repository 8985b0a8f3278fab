// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "grid/mesh.hpp"

namespace tether {

/// How a connected part of a mesh is divided across its thin direction.
struct ElementsAcross {
  double count = 0;      ///< layers of elements from one side to the other
  double thickness = 0;  ///< [length]
  double along = 0;      ///< length of an element across the thin direction, in the mean [length]
  double longest = 0;    ///< longest extent of the part along an axis [length]
  std::vector<int> regions;
};

/// Of each connected part of a mesh of order 1, from its sides alone, so that it holds for any mesh. From each side on
/// the boundary a way leads through the part: through quadrilaterals and hexahedra from a side to the opposite one,
/// through triangles and tetrahedra straight along the side's normal, where two of the former and three of the latter
/// count as a layer (into as many a cell is cut across). The thickness is what a tenth of the boundary does not exceed.
std::vector<ElementsAcross> elements_across(const Mesh& mesh);

}  // namespace tether
