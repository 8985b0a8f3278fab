// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "model/flow.hpp"

namespace tether::fem {

/// An element's side of the boundary at an end of a side whose force is recorded, where others of its walls meet it.
struct CornerSide {
  Sides nodes = {};              ///< of this one element side
  std::vector<int> shared = {};  ///< those of them, from 0, that the side and others have
  bool slip = false;             ///< nothing acts along it
  bool own = false;              ///< it is a part of the side, or one of the others
};

/// The element sides on both hands of such ends. A node's force is that of all sides it stands on, and each of two gets
/// what the stress on it gives, and half of what both do not explain: so the forces of all walls are those of all
/// nodes. Open sides are none, as their stress stands in the equations, nor are periodic ones, whose two stresses
/// cancel.
std::vector<CornerSide> corner_sides_of(const Flow& flow, const ForceSide& force);

/// A node of a side whose force is recorded, and its part of the force at the node whose unknowns it shares: half where
/// other walls meet the side there, and of twins half each.
struct NodeShare {
  std::size_t node = 0, unknowns_of = 0;
  double share = 1;
};
std::vector<NodeShare> node_shares_of(const Flow& flow, const ForceSide& force);

}  // namespace tether::fem
