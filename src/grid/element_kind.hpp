// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tether {

/// Elements: quadrilaterals and hexahedra with Lagrange functions of order 1 or 2, triangles and tetrahedra of order 1.
/// Nodes of quadrilaterals and hexahedra stand as on a lattice, along x first, then y, then z.
enum class ElementKind { quad4, quad9, tri3, hex8, hex27, tet4 };

constexpr int dimension_of(ElementKind kind) {
  return kind == ElementKind::quad4 || kind == ElementKind::quad9 || kind == ElementKind::tri3 ? 2 : 3;
}
/// Nodes along an edge less one; 1 or 2.
constexpr int order_of(ElementKind kind) { return kind == ElementKind::quad9 || kind == ElementKind::hex27 ? 2 : 1; }
constexpr bool is_simplex(ElementKind kind) { return kind == ElementKind::tri3 || kind == ElementKind::tet4; }
constexpr int node_count_of(ElementKind kind) {
  constexpr int counts[] = {4, 9, 3, 8, 27, 4};
  return counts[static_cast<int>(kind)];
}
/// Nodes of an element's side: an edge in the plane, a face in space.
constexpr int side_node_count_of(ElementKind kind) {
  constexpr int counts[] = {2, 3, 2, 4, 9, 3};
  return counts[static_cast<int>(kind)];
}
/// "q1", "q2" or "p1".
constexpr const char* element_name(ElementKind kind) {
  return is_simplex(kind) ? "p1" : order_of(kind) == 1 ? "q1" : "q2";
}

/// Nodes of element sides, side_node_count_of() each.
using Sides = std::vector<int>;

}  // namespace tether
