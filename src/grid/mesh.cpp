// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid/mesh.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace tether {
namespace {

/// Corners of a triangle's edges and of a tetrahedron's faces, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 2>, 3> edges_of_triangle{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<std::array<int, 3>, 4> faces_of_tetrahedron{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

/// The middle node between two corners, within a triangle or tetrahedron of order 2.
int middle_between(ElementKind kind, int a, int b) {
  const std::array ends{std::min(a, b), std::max(a, b)};
  const auto found = std::find(ends_of_middle.begin(), ends_of_middle.end(), ends);
  return corner_count_of(kind) + static_cast<int>(found - ends_of_middle.begin());
}

/// Appends a side of a simplex with these corners: of order 2 an edge with its middle between them, as a line has it,
/// and a face with its corners first.
template <std::size_t count>
void add_side_of_simplex(ElementKind kind, const int* element, const std::array<int, count>& corners, Sides& sides) {
  const auto middle = [&](std::size_t a) {
    return element[middle_between(kind, corners[a], corners[(a + 1) % count])];
  };
  const bool quadratic = order_of(kind) == 2;
  for (std::size_t a = 0; a < count; ++a) {
    sides.push_back(element[corners[a]]);
    if (quadratic && count == 2 && a == 0) sides.push_back(middle(0));
  }
  for (std::size_t a = 0; quadratic && count == 3 && a < count; ++a) sides.push_back(middle(a));
}

/// A lattice number of a box with p + 1 nodes a line.
int lattice(int p, int i, int j, int k) { return i + (p + 1) * (j + (p + 1) * k); }

/// Facets of a side of a quadrilateral mesh's lattice, of order 1 or 2, and of a triangle with three middles.
constexpr std::array<std::array<int, 3>, 4> facets_of_triangle{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};

}  // namespace

std::vector<std::array<int, 3>> facets_of_side(ElementKind kind) {
  const int p = order_of(kind);
  std::vector<std::array<int, 3>> facets;
  if (dimension_of(kind) == 2) {
    for (int a = 0; a < p; ++a) facets.push_back({a, a + 1, -1});
  } else if (is_simplex(kind)) {
    if (p == 1) return {{0, 1, 2}};
    facets.assign(facets_of_triangle.begin(), facets_of_triangle.end());
  } else {
    for (int b = 0; b < p; ++b) {
      for (int a = 0; a < p; ++a) {
        const int first = a + b * (p + 1), beyond = first + p + 2;
        facets.push_back({first, first + 1, beyond}), facets.push_back({first, beyond, beyond - 1});
      }
    }
  }
  return facets;
}

std::vector<int> corners_of(ElementKind kind) {
  std::vector<int> corners;
  const int p = order_of(kind);
  for (int c = 0; c < corner_count_of(kind); ++c)
    corners.push_back(is_simplex(kind) ? c : lattice(p, p * (c & 1), p * (c >> 1 & 1), p * (c >> 2 & 1)));
  return corners;
}

std::vector<std::array<int, 3>> curved_edges_of(ElementKind kind) {
  std::vector<std::array<int, 3>> edges;
  if (order_of(kind) == 1) return edges;
  const int dim = dimension_of(kind), corners = corner_count_of(kind);
  if (is_simplex(kind)) {
    for (int m = corners; m < node_count_of(kind); ++m) {
      const auto& ends = ends_of_middle[static_cast<std::size_t>(m - corners)];
      edges.push_back({ends[0], ends[1], m});
    }
    return edges;
  }
  const std::vector<int> at_corners = corners_of(kind);
  for (int c = 0; c < corners; ++c) {
    for (int axis = 0; axis < dim; ++axis) {
      if (c >> axis & 1) continue;
      const int from = at_corners[static_cast<std::size_t>(c)],
                to = at_corners[static_cast<std::size_t>(c | 1 << axis)];
      edges.push_back({from, to, (from + to) / 2});
    }
  }
  return edges;
}

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
  if (is_simplex(kind) && dimension_of(kind) == 2) {
    for (const auto& edge : edges_of_triangle) add_side_of_simplex(kind, element, edge, sides);
  } else if (is_simplex(kind)) {
    for (const auto& face : faces_of_tetrahedron) add_side_of_simplex(kind, element, face, sides);
  } else {
    for (int axis = 0; axis < dimension_of(kind); ++axis) {
      for (const int end : {0, 1}) {
        for (const int a : side_of_box(kind, axis, end)) sides.push_back(element[a]);
      }
    }
  }
}

namespace {

/// Sides by their nodes in ascending order, so that the two sides of a face meet.
struct Face {
  std::vector<int> sorted;
  std::size_t side;
  bool operator<(const Face& other) const { return sorted != other.sorted ? sorted < other.sorted : side < other.side; }
};

/// The sides of all elements, sorted so that those with the same nodes stand together.
std::vector<Face> faces_of(const Mesh& mesh, const Sides& all) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  std::vector<Face> faces;
  for (std::size_t s = 0; s * per_side < all.size(); ++s) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(s * per_side);
    faces.push_back({{first, first + static_cast<std::ptrdiff_t>(per_side)}, s});
    std::sort(faces.back().sorted.begin(), faces.back().sorted.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

Sides sides_of_all(const Mesh& mesh) {
  Sides all;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) add_sides(mesh.kind, mesh.element(e), all);
  return all;
}

/// Sides that one element alone has, of all of them.
std::vector<Face> outer_faces(const Mesh& mesh, const Sides& all) {
  const std::vector<Face> faces = faces_of(mesh, all);
  std::vector<Face> alone;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const bool with_last = k > 0 && faces[k].sorted == faces[k - 1].sorted;
    const bool with_next = k + 1 < faces.size() && faces[k].sorted == faces[k + 1].sorted;
    if (!with_last && !with_next) alone.push_back(faces[k]);
  }
  return alone;
}

/// How many sides each of the elements has, whose sides are `all`.
std::size_t sides_per_element(const Mesh& mesh, const Sides& all) {
  const std::size_t elements = mesh.element_count();
  return elements == 0 ? 1 : all.size() / static_cast<std::size_t>(side_node_count_of(mesh.kind)) / elements;
}

}  // namespace

Mesh by_corners(const Mesh& mesh) {
  const ElementKind kind = element_kind(is_simplex(mesh.kind) ? "p1" : "q1", mesh.dim());
  Mesh linear{.kind = kind, .x = mesh.x, .nodes = {}, .region = mesh.region, .sides = {}};
  const std::vector<int> corners = corners_of(mesh.kind);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int c : corners) linear.nodes.push_back(mesh.element(e)[c]);
  }
  return linear;
}

Sides boundary_of(const Mesh& mesh) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  const Sides all = sides_of_all(mesh);
  std::vector<std::size_t> alone;
  for (const Face& face : outer_faces(mesh, all)) alone.push_back(face.side);
  std::sort(alone.begin(), alone.end());
  Sides boundary;
  for (const std::size_t s : alone) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(s * per_side);
    boundary.insert(boundary.end(), first, first + static_cast<std::ptrdiff_t>(per_side));
  }
  return boundary;
}

std::vector<std::size_t> elements_of_sides(const Mesh& mesh, const Sides& sides) {
  const auto per_side = static_cast<std::ptrdiff_t>(side_node_count_of(mesh.kind));
  const Sides all = sides_of_all(mesh);
  const std::vector<Face> outer = outer_faces(mesh, all);
  const std::size_t per_element = sides_per_element(mesh, all);
  std::vector<std::size_t> elements;
  for (auto first = sides.begin(); first != sides.end(); first += per_side) {
    std::vector<int> sorted(first, first + per_side);
    std::sort(sorted.begin(), sorted.end());
    const auto found = std::lower_bound(outer.begin(), outer.end(), sorted,
                                        [](const Face& face, const auto& nodes) { return face.sorted < nodes; });
    const bool there = found != outer.end() && found->sorted == sorted;
    elements.push_back(there ? found->side / per_element : mesh.element_count());
  }
  return elements;
}

void drop_twins(Mesh& mesh) {
  const auto per_side = static_cast<std::ptrdiff_t>(side_node_count_of(mesh.kind));
  for (auto& [name, sides] : mesh.sides) {
    std::set<std::vector<int>> seen;
    Sides once;
    for (auto first = sides.begin(); first != sides.end(); first += per_side) {
      std::vector<int> sorted(first, first + per_side);
      std::sort(sorted.begin(), sorted.end());
      if (seen.insert(std::move(sorted)).second) once.insert(once.end(), first, first + per_side);
    }
    sides = std::move(once);
  }
}

std::vector<int> parts_of(const Mesh& mesh) {
  std::vector<int> above(mesh.node_count()), part(mesh.node_count(), -1);
  std::iota(above.begin(), above.end(), 0);
  const auto per_element = static_cast<std::size_t>(node_count_of(mesh.kind));
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const int root = root_of(above, mesh.element(e)[0]);
    for (std::size_t a = 0; a < per_element; ++a) {
      above[static_cast<std::size_t>(root_of(above, mesh.element(e)[a]))] = root;
    }
  }
  std::vector<int> number(mesh.node_count(), -1);
  int parts = 0;
  for (const int node : mesh.nodes) {
    int& of_root = number[static_cast<std::size_t>(root_of(above, node))];
    if (of_root < 0) of_root = parts++;
    part[static_cast<std::size_t>(node)] = of_root;
  }
  return part;
}

int count_parts(const Mesh& mesh) {
  const std::vector<int> part = parts_of(mesh);
  return part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
}

std::vector<int> blocks_by_sides(const Mesh& mesh) {
  const Sides all = sides_of_all(mesh);
  const std::vector<Face> faces = faces_of(mesh, all);
  const std::size_t elements = mesh.element_count(), per_element = sides_per_element(mesh, all);
  std::vector<int> above(elements), number(elements, -1), block(elements);
  std::iota(above.begin(), above.end(), 0);
  for (std::size_t k = 1; k < faces.size(); ++k) {
    if (faces[k].sorted != faces[k - 1].sorted) continue;
    const int a = static_cast<int>(faces[k].side / per_element), b = static_cast<int>(faces[k - 1].side / per_element);
    above[static_cast<std::size_t>(root_of(above, a))] = root_of(above, b);
  }
  int blocks = 0;
  for (std::size_t e = 0; e < elements; ++e) {
    int& of_root = number[static_cast<std::size_t>(root_of(above, static_cast<int>(e)))];
    if (of_root < 0) of_root = blocks++;
    block[e] = of_root;
  }
  return block;
}

}  // namespace tether
