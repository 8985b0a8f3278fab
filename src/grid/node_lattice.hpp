// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "grid/mesh.hpp"

namespace tether {

/// The nodes of a region of quadrilaterals that stand in rows, as those of a block do: `count` lines of nodes each way,
/// the first way first.
struct NodeLattice {
  std::array<std::size_t, 2> count{};
  std::vector<int> nodes;
  std::size_t first_element = 0;          ///< its elements are numbered on from here, the first way first
  std::array<std::size_t, 2> elements{};  ///< each way

  int node(std::size_t i, std::size_t j) const { return nodes[j * count[0] + i]; }
  /// Edges 0 to 3 (bottom, right, top, left), each with its nodes along the first or the second way.
  std::vector<int> edge(std::size_t k) const;
};

/// Returns the lattice of each region of a plane mesh of quadrilaterals whose elements are numbered row by row; others
/// have none.
std::vector<NodeLattice> node_lattices_of(const Mesh& mesh);

/// Ways of lattices whose lines of nodes go on from one to the other, as their edges are the same nodes: of way `way`
/// of lattice l the chain, and whether it runs against it. All ways of a chain have as many lines.
struct LatticeChains {
  struct Link {
    int chain = -1;
    bool reversed = false;
  };
  std::vector<std::array<Link, 2>> of;  ///< of each lattice and way
  std::vector<std::size_t> lines;       ///< of each chain
};
LatticeChains chains_of(const std::vector<NodeLattice>& lattices);

}  // namespace tether
