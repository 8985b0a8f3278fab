// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"

namespace tether::coupled {

/// How the nodes of solids resist impulses of the fluid's friction in a step. Numbers are dim a node.
struct NodeInertia {
  SparseMatrix mass;               ///< symmetric, both triangles; what is stiff counts as heavy [mass]
  std::vector<std::uint8_t> held;  ///< of each number: 1 where its velocity is prescribed

  std::size_t size() const { return held.size(); }
};

/// The mass of each number where all that move along its axis do so as one: no stiffness resists that [mass].
std::vector<double> masses_as_one(const NodeInertia& nodes, int dim);
/// Nodes of these masses that have nothing to do with each other.
NodeInertia loose_nodes(std::span<const double> masses, std::vector<std::uint8_t> held);

}  // namespace tether::coupled
