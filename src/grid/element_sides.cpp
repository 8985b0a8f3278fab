// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/element_sides.hpp"

#include <array>

namespace tether {
namespace {

/// Corners of a triangle's edges and of a tetrahedron's faces, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 2>, 3> edges_of_triangle{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<std::array<int, 3>, 4> faces_of_tetrahedron{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

/// A lattice number of a box with p + 1 nodes a line.
int lattice(int p, int i, int j, int k) { return i + (p + 1) * (j + (p + 1) * k); }

}  // namespace

std::vector<int> side_of_box(ElementKind kind, int axis, int end) {
  const int p = order_of(kind), dim = dimension_of(kind);
  std::vector<int> side;
  // Along the axes that follow in the cycle x, y, z; from low to high where that turns counter-clockwise about the
  // outward normal, from high to low else.
  for (int b = 0; b <= (dim == 3 ? p : 0); ++b) {
    for (int a = 0; a <= p; ++a) {
      std::array<int, 3> at{0, 0, 0};
      at[static_cast<std::size_t>(axis)] = end * p;
      const bool forward = dim == 3 ? end == 1 : (axis == 0) == (end == 1);
      at[static_cast<std::size_t>((axis + 1) % dim)] = forward ? a : p - a;
      if (dim == 3) at[static_cast<std::size_t>((axis + 2) % 3)] = b;
      side.push_back(lattice(p, at[0], at[1], at[2]));
    }
  }
  return side;
}

void add_sides(ElementKind kind, const int* element, Sides& sides) {
  if (kind == ElementKind::tri3) {
    for (const auto& edge : edges_of_triangle) {
      for (const int a : edge) sides.push_back(element[a]);
    }
  } else if (kind == ElementKind::tet4) {
    for (const auto& face : faces_of_tetrahedron) {
      for (const int a : face) sides.push_back(element[a]);
    }
  } else {
    for (int axis = 0; axis < dimension_of(kind); ++axis) {
      for (const int end : {0, 1}) {
        for (const int a : side_of_box(kind, axis, end)) sides.push_back(element[a]);
      }
    }
  }
}

}  // namespace tether
