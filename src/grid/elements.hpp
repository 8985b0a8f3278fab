// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

namespace tether {

/// Elements: quadrilaterals and hexahedra, triangles and tetrahedra, with Lagrange functions of order 1 or 2. Nodes of
/// quadrilaterals and hexahedra stand as on a lattice, along x first, then y, then z. Triangles and tetrahedra have
/// their corners first, then the middles of their edges (ends_of_middle).
enum class ElementKind { quad4, quad9, tri3, tri6, hex8, hex27, tet4, tet10 };

/// The nodes of triangles and tetrahedra of order 2 that are not corners: which corners they stand between.
inline constexpr std::array<std::array<int, 2>, 6> ends_of_middle{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// What is known of a kind of element without its functions, which shapes.hpp has.
struct ElementRow {
  ElementKind kind;
  std::string_view name;  ///< in decks, the same in the plane and in space
  int dim;
  int order;     ///< nodes along an edge less one
  bool simplex;  ///< triangle or tetrahedron
  int nodes;
  int corners;
  int side_nodes;               ///< of a side: an edge in the plane, a face in space
  int gmsh_type;                ///< number of the type in Gmsh's files
  int vtk_type;                 ///< the same of a cell of VTK
  std::array<int, 27> in_gmsh;  ///< ours of each node of Gmsh's, which counts corners, edges, faces, the middle
  std::array<int, 27> in_vtk;   ///< ours of each node of VTK's, which has another order of edges and faces
};

/// THE list of elements. Sources of orders: Gmsh reference manual, "Node ordering"; VTK, "VTK file formats".
inline constexpr std::array element_rows{
    ElementRow{.kind = ElementKind::quad4,
               .name = "q1",
               .dim = 2,
               .order = 1,
               .simplex = false,
               .nodes = 4,
               .corners = 4,
               .side_nodes = 2,
               .gmsh_type = 3,
               .vtk_type = 9,
               .in_gmsh = {0, 1, 3, 2},
               .in_vtk = {0, 1, 3, 2}},
    ElementRow{.kind = ElementKind::quad9,
               .name = "q2",
               .dim = 2,
               .order = 2,
               .simplex = false,
               .nodes = 9,
               .corners = 4,
               .side_nodes = 3,
               .gmsh_type = 10,
               .vtk_type = 28,
               .in_gmsh = {0, 2, 8, 6, 1, 5, 7, 3, 4},
               .in_vtk = {0, 2, 8, 6, 1, 5, 7, 3, 4}},
    ElementRow{.kind = ElementKind::tri3,
               .name = "p1",
               .dim = 2,
               .order = 1,
               .simplex = true,
               .nodes = 3,
               .corners = 3,
               .side_nodes = 2,
               .gmsh_type = 2,
               .vtk_type = 5,
               .in_gmsh = {0, 1, 2},
               .in_vtk = {0, 1, 2}},
    ElementRow{.kind = ElementKind::tri6,
               .name = "p2",
               .dim = 2,
               .order = 2,
               .simplex = true,
               .nodes = 6,
               .corners = 3,
               .side_nodes = 3,
               .gmsh_type = 9,
               .vtk_type = 22,
               .in_gmsh = {0, 1, 2, 3, 4, 5},
               .in_vtk = {0, 1, 2, 3, 4, 5}},
    ElementRow{.kind = ElementKind::hex8,
               .name = "q1",
               .dim = 3,
               .order = 1,
               .simplex = false,
               .nodes = 8,
               .corners = 8,
               .side_nodes = 4,
               .gmsh_type = 5,
               .vtk_type = 12,
               .in_gmsh = {0, 1, 3, 2, 4, 5, 7, 6},
               .in_vtk = {0, 1, 3, 2, 4, 5, 7, 6}},
    ElementRow{
        .kind = ElementKind::hex27,
        .name = "q2",
        .dim = 3,
        .order = 2,
        .simplex = false,
        .nodes = 27,
        .corners = 8,
        .side_nodes = 9,
        .gmsh_type = 12,
        .vtk_type = 29,
        .in_gmsh = {0, 2, 8, 6, 18, 20, 26, 24, 1, 3, 9, 5, 11, 7, 17, 15, 19, 21, 23, 25, 4, 10, 12, 14, 16, 22, 13},
        .in_vtk = {0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13}},
    ElementRow{.kind = ElementKind::tet4,
               .name = "p1",
               .dim = 3,
               .order = 1,
               .simplex = true,
               .nodes = 4,
               .corners = 4,
               .side_nodes = 3,
               .gmsh_type = 4,
               .vtk_type = 10,
               .in_gmsh = {0, 1, 2, 3},
               .in_vtk = {0, 1, 2, 3}},
    ElementRow{.kind = ElementKind::tet10,
               .name = "p2",
               .dim = 3,
               .order = 2,
               .simplex = true,
               .nodes = 10,
               .corners = 4,
               .side_nodes = 6,
               .gmsh_type = 11,
               .vtk_type = 24,
               .in_gmsh = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8},
               .in_vtk = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
};

/// The row of a kind. Throws std::logic_error where it has none.
constexpr const ElementRow& row_of(ElementKind kind) {
  for (const ElementRow& row : element_rows) {
    if (row.kind == kind) return row;
  }
  throw std::logic_error("a kind of element without a row");
}

constexpr int dimension_of(ElementKind kind) { return row_of(kind).dim; }
constexpr int order_of(ElementKind kind) { return row_of(kind).order; }
constexpr bool is_simplex(ElementKind kind) { return row_of(kind).simplex; }
constexpr int node_count_of(ElementKind kind) { return row_of(kind).nodes; }
constexpr int corner_count_of(ElementKind kind) { return row_of(kind).corners; }
constexpr int side_node_count_of(ElementKind kind) { return row_of(kind).side_nodes; }
constexpr std::string_view element_name(ElementKind kind) { return row_of(kind).name; }

/// The kind that decks call `name`, in the plane or in space. Throws std::logic_error where there is none.
constexpr ElementKind element_kind(std::string_view name, int dim) {
  for (const ElementRow& row : element_rows) {
    if (row.name == name && row.dim == dim) return row.kind;
  }
  throw std::logic_error("no element has that name");
}

}  // namespace tether
