// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "grid/mesh.hpp"

namespace tether {

/// A place in a mesh: nodes of its element, and the values of their shape functions there, whose sum is 1.
struct MeshPlace {
  std::vector<int> nodes;
  std::vector<double> parts;
  /// The value at the place of component i of `per_node` numbers a node.
  double of(std::span<const double> values, std::size_t per_node, std::size_t i) const;
};

/// The place of a mesh that is nearest to one that was asked for.
struct NearestPlace {
  MeshPlace place;
  std::size_t element = 0;  ///< of the place
  double away = 0;          ///< how far the place that was asked for lies outside of all elements [length]
  double element_size = 0;  ///< the longest extent of the element along an axis [length]
};

/// The place of the mesh nearest to `x`, whose components beyond the mesh's dimension do not count. Where several
/// elements share the place the first of them has it; a place at a node, as near as rounding tells, is the node alone.
/// A distance that is not small compared with the element is an upper bound of the distance. The mesh has an element.
NearestPlace nearest_place(const Mesh& mesh, const std::array<double, 3>& x);

}  // namespace tether
