// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/gmsh/content.hpp"

#include <algorithm>
#include <numeric>

namespace tether::gmsh {
namespace {

constexpr const char* triangles =
    "Mesh.ElementOrder = 1 makes 3-node triangles; a fluid takes quadrangles, by 'Recombine Surface{:};'.";
constexpr const char* tetrahedra = "Mesh.ElementOrder = 1 makes 4-node tetrahedra.";
constexpr const char* complete = "Mesh.SecondOrderIncomplete = 0 makes 9-node quadrangles and 27-node hexahedra.";
constexpr const char* only_boxes = "Bodies in space are of tetrahedra or of hexahedra alone: tetrahedra always fit.";
constexpr const char* order_two = "Mesh.ElementOrder = 2 is the highest there is here, of quadrangles and hexahedra.";

constexpr auto none = std::nullopt;

/// Source: Gmsh reference manual, "MSH file format"; the numbers of both versions.
const ElementType types[] = {
    {1, "2-node line", 1, 2, none, ""},
    {2, "3-node triangle", 2, 3, ElementKind::tri3, ""},
    {3, "4-node quadrangle", 2, 4, ElementKind::quad4, ""},
    {4, "4-node tetrahedron", 3, 4, ElementKind::tet4, ""},
    {5, "8-node hexahedron", 3, 8, ElementKind::hex8, ""},
    {6, "6-node prism", 3, 6, none, only_boxes},
    {7, "5-node pyramid", 3, 5, none, only_boxes},
    {8, "3-node line", 1, 3, none, ""},
    {9, "6-node triangle", 2, 6, none, triangles},
    {10, "9-node quadrangle", 2, 9, ElementKind::quad9, ""},
    {11, "10-node tetrahedron", 3, 10, none, tetrahedra},
    {12, "27-node hexahedron", 3, 27, ElementKind::hex27, ""},
    {13, "18-node prism", 3, 18, none, only_boxes},
    {14, "14-node pyramid", 3, 14, none, only_boxes},
    {15, "point", 0, 1, none, ""},
    {16, "8-node quadrangle", 2, 8, none, complete},
    {17, "20-node hexahedron", 3, 20, none, complete},
    {18, "15-node prism", 3, 15, none, only_boxes},
    {19, "13-node pyramid", 3, 13, none, only_boxes},
    {20, "9-node triangle", 2, 9, none, triangles},
    {21, "10-node triangle", 2, 10, none, triangles},
    {26, "4-node line", 1, 4, none, ""},
    {27, "5-node line", 1, 5, none, ""},
    {29, "20-node tetrahedron", 3, 20, none, tetrahedra},
    {36, "16-node quadrangle", 2, 16, none, order_two},
    {92, "64-node hexahedron", 3, 64, none, order_two},
};

}  // namespace

const ElementType* find_type(int number) {
  const auto found =
      std::find_if(std::begin(types), std::end(types), [&](const ElementType& type) { return type.number == number; });
  return found == std::end(types) ? nullptr : &*found;
}

/// Gmsh counts corners around, then edges, faces and the middle, in an order of its own for hexahedra.
std::vector<int> gmsh_order(ElementKind kind) {
  std::vector<int> lattice;  // ours of each of Gmsh's
  switch (kind) {
    case ElementKind::quad4:
      lattice = {0, 1, 3, 2};
      break;
    case ElementKind::quad9:
      lattice = {0, 2, 8, 6, 1, 5, 7, 3, 4};
      break;
    case ElementKind::hex8:
      lattice = {0, 1, 3, 2, 4, 5, 7, 6};
      break;
    case ElementKind::hex27:
      lattice = {0, 2, 8, 6, 18, 20, 26, 24, 1, 3, 9, 5, 11, 7, 17, 15, 19, 21, 23, 25, 4, 10, 12, 14, 16, 22, 13};
      break;
    case ElementKind::tri3:
    case ElementKind::tet4:
      lattice.resize(static_cast<std::size_t>(node_count_of(kind)));
      std::iota(lattice.begin(), lattice.end(), 0);
  }
  std::vector<int> order(lattice.size());
  for (std::size_t k = 0; k < lattice.size(); ++k) order[static_cast<std::size_t>(lattice[k])] = static_cast<int>(k);
  return order;
}

}  // namespace tether::gmsh
