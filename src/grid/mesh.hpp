// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grid/elements.hpp"

namespace tether {

/// Nodes of element sides, side_node_count_of() each.
using Sides = std::vector<int>;

/// Appends the nodes of all sides of an element. Seen from outside, a side's first direction and the one from it to the
/// body's inside turn clockwise in the plane; in space the side's two directions span its outward normal.
void add_sides(ElementKind kind, const int* element, Sides& sides);

/// Nodes, within an element, of the side that is low (0) or high (1) along an axis of a quadrilateral or hexahedron.
std::vector<int> side_of_box(ElementKind kind, int axis, int end);

/// Nodes, within an element, of its corners.
std::vector<int> corners_of(ElementKind kind);

/// The edges of an element of order 2: the nodes at both ends, and the one in the middle last. Of order 1: none.
std::vector<std::array<int, 3>> curved_edges_of(ElementKind kind);

/// Edges, or triangles in space, that a side is parted into by its nodes: their numbers within the side, which turn as
/// it does; the third of an edge is -1.
std::vector<std::array<int, 3>> facets_of_side(ElementKind kind);

/// The root of the tree that a node belongs to, each node's parent being above[node], a root's itself. Paths are halved
/// on the way.
inline int root_of(std::vector<int>& above, int node) {
  while (above[static_cast<std::size_t>(node)] != node) {
    int& next = above[static_cast<std::size_t>(node)];
    next = above[static_cast<std::size_t>(next)];
    node = next;
  }
  return node;
}

/// Places nearer to each other than this part of the mesh's size are one place.
constexpr double coincident = 1e-9;

/// Elements of one kind with their nodes.
struct Mesh {
  ElementKind kind = ElementKind::quad4;
  std::vector<double> x;                                   ///< dim numbers a node [length]
  std::vector<int> nodes;                                  ///< of the elements, one after the other
  std::vector<int> region;                                 ///< of each element, from 0
  std::map<std::string, Sides> sides;                      ///< named parts of the boundary
  std::map<std::string, std::vector<int>> node_sets = {};  ///< named sets of nodes, each node once, ascending

  int dim() const { return dimension_of(kind); }
  std::size_t node_count() const { return x.size() / static_cast<std::size_t>(dim()); }
  std::size_t element_count() const { return region.size(); }
  const int* element(std::size_t e) const { return &nodes[e * static_cast<std::size_t>(node_count_of(kind))]; }
};

/// Makes elements of order 1 of the corners of these; the nodes are all there.
Mesh by_corners(const Mesh& mesh);

/// The sides of all elements that belong to one element alone, in the order of the elements.
Sides boundary_of(const Mesh& mesh);

/// Returns the element that has each of these sides on the mesh's boundary; the number of elements for a side that is
/// not on it.
std::vector<std::size_t> elements_of_sides(const Mesh& mesh, const Sides& sides);

/// Leaves of the named sides that stand twice under one name, from both elements or by mistake, the first alone.
void drop_twins(Mesh& mesh);

/// Returns for each node the number of its connected part of the mesh, from 0; -1 for a node of no element.
std::vector<int> parts_of(const Mesh& mesh);
/// How many of them there are.
int count_parts(const Mesh& mesh);

/// Returns for each element the number of the block of elements that it hangs together with by whole sides, from 0.
std::vector<int> blocks_by_sides(const Mesh& mesh);

}  // namespace tether
