// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grid/element_kind.hpp"

namespace tether {

/// Elements of one kind with their nodes.
struct Mesh {
  ElementKind kind = ElementKind::quad4;
  std::vector<double> x;               ///< dim numbers a node [length]
  std::vector<int> nodes;              ///< of the elements, one after the other
  std::vector<int> region;             ///< of each element, from 0
  std::map<std::string, Sides> sides;  ///< named parts of the boundary

  int dim() const { return dimension_of(kind); }
  std::size_t node_count() const { return x.size() / static_cast<std::size_t>(dim()); }
  std::size_t element_count() const { return region.size(); }
  const int* element(std::size_t e) const { return &nodes[e * static_cast<std::size_t>(node_count_of(kind))]; }
};

/// The sides of all elements that belong to one element alone, in the order of the elements.
Sides boundary_of(const Mesh& mesh);

/// Leaves of the named sides that stand twice under one name, from both elements or by mistake, the first alone.
void drop_twins(Mesh& mesh);

/// For each node the number of its connected part of the mesh, from 0; -1 for a node of no element.
std::vector<int> parts_of(const Mesh& mesh);
/// How many of them there are.
int count_parts(const Mesh& mesh);

/// For each element the number of the block of elements that it hangs together with by whole sides, from 0.
std::vector<int> blocks_by_sides(const Mesh& mesh);

}  // namespace tether
