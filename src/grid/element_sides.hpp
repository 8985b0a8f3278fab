// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grid/element_kind.hpp"

namespace tether {

/// Appends the nodes of all sides of an element. Seen from outside, a side's first direction and the one from it to the
/// body's inside turn clockwise in the plane; in space the side's two directions span its outward normal.
void add_sides(ElementKind kind, const int* element, Sides& sides);

/// Nodes, within an element, of the side that is low (0) or high (1) along an axis of a quadrilateral or hexahedron.
std::vector<int> side_of_box(ElementKind kind, int axis, int end);

}  // namespace tether
