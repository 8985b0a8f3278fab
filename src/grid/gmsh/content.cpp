// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/content.hpp"

#include <algorithm>
#include <numeric>

namespace tether::gmsh {
namespace {

constexpr const char* triangles = "Mesh.ElementOrder = 2 makes 6-node triangles, 1 makes 3-node ones.";
constexpr const char* tetrahedra = "Mesh.ElementOrder = 2 makes 10-node tetrahedra, 1 makes 4-node ones.";
constexpr const char* complete = "Mesh.SecondOrderIncomplete = 0 makes 9-node quadrangles and 27-node hexahedra.";
constexpr const char* only_boxes = "Bodies in space are of tetrahedra or of hexahedra alone: tetrahedra always fit.";
constexpr const char* order_two = "Mesh.ElementOrder = 2 is the highest there is here.";

/// Source: Gmsh reference manual, "MSH file format"; the numbers of both versions.
const ElementType types[] = {
    {1, "2-node line", 1, 2, ""},
    {2, "3-node triangle", 2, 3, ""},
    {3, "4-node quadrangle", 2, 4, ""},
    {4, "4-node tetrahedron", 3, 4, ""},
    {5, "8-node hexahedron", 3, 8, ""},
    {6, "6-node prism", 3, 6, only_boxes},
    {7, "5-node pyramid", 3, 5, only_boxes},
    {8, "3-node line", 1, 3, ""},
    {9, "6-node triangle", 2, 6, ""},
    {10, "9-node quadrangle", 2, 9, ""},
    {11, "10-node tetrahedron", 3, 10, ""},
    {12, "27-node hexahedron", 3, 27, ""},
    {13, "18-node prism", 3, 18, only_boxes},
    {14, "14-node pyramid", 3, 14, only_boxes},
    {15, "point", 0, 1, ""},
    {16, "8-node quadrangle", 2, 8, complete},
    {17, "20-node hexahedron", 3, 20, complete},
    {18, "15-node prism", 3, 15, only_boxes},
    {19, "13-node pyramid", 3, 13, only_boxes},
    {20, "9-node triangle", 2, 9, triangles},
    {21, "10-node triangle", 2, 10, triangles},
    {26, "4-node line", 1, 4, ""},
    {27, "5-node line", 1, 5, ""},
    {29, "20-node tetrahedron", 3, 20, tetrahedra},
    {36, "16-node quadrangle", 2, 16, order_two},
    {92, "64-node hexahedron", 3, 64, order_two},
};

}  // namespace

const ElementType* find_type(int number) {
  const auto found =
      std::find_if(std::begin(types), std::end(types), [&](const ElementType& type) { return type.number == number; });
  return found == std::end(types) ? nullptr : &*found;
}

std::vector<int> gmsh_order(ElementKind kind) {
  const ElementRow& row = row_of(kind);
  std::vector<int> order(static_cast<std::size_t>(row.nodes));
  for (int k = 0; k < row.nodes; ++k) order[static_cast<std::size_t>(row.in_gmsh[static_cast<std::size_t>(k)])] = k;
  return order;
}

std::optional<ElementKind> kind_of(const ElementType& type) {
  for (const ElementRow& row : element_rows) {
    if (row.gmsh_type == type.number) return row.kind;
  }
  return std::nullopt;
}

}  // namespace tether::gmsh
