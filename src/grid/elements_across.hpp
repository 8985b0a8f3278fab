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

/// Of each connected part of a mesh of order 1, in the order of parts_of(), from its sides alone, so that it holds for
/// any mesh: by the shortest of the ways_across() that leave opposite, from a tenth of the boundary. The thickness is
/// at right angles to it, whatever the angle of the elements' other sides: a body bends as its own shape does.
std::vector<ElementsAcross> elements_across(const Mesh& mesh);

}  // namespace tether
