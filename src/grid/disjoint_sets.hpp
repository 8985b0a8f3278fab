// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace tether {

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

}  // namespace tether
