// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "grid/mesh.hpp"

namespace tether {

/// A way through a body, from a side of its boundary to the one where it leaves.
struct Way {
  std::size_t element = 0;  ///< where it begins
  double length = 0;        ///< [length]
  double layers = 0;        ///< of elements that it crosses
  double area = 0;          ///< of the side where it begins [length2, in the plane length]
  bool opposed = true;      ///< it leaves by a side that lies opposite; else it cut a corner of the body
  int side = 0;             ///< that where it begins, for layers_across()
};

/// From each side of the boundary, in the order of the elements. Through quadrilaterals and hexahedra a way leads from
/// a side to the opposite one and is as long as its ends are apart at right angles to both, which is the thickness
/// however sheared they are; through triangles and tetrahedra it leads straight along the side's normal, and their
/// layers are a first estimate: two of the former and three of the latter (into as many a cell is cut across).
std::vector<Way> ways_across(const Mesh& mesh);

/// Layers of triangles or tetrahedra, of each of these ways: the fewest edges from the side to a node of the boundary
/// opposite, which does not depend on how the cells are cut or sheared; its first estimate where none lies opposite.
std::vector<double> layers_across(const Mesh& mesh, const std::vector<Way>& ways);

/// [length3, in the plane length2]
double volume_of_element(const Mesh& mesh, std::size_t e);

}  // namespace tether
