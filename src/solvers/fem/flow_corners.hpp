// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/flow.hpp"

namespace tether::fem {

/// An element's side of the boundary that meets a side whose force is recorded, at a node of both.
struct CornerSide {
  Sides nodes = {};              ///< of this one element side
  std::vector<int> shared = {};  ///< those of them, from 0, that the other has too
  bool slip = false;             ///< nothing acts along it
};

/// The neighbours of a side whose force is recorded, where it ends. A node's force is that of all sides it stands on:
/// what these get belongs to them. Open sides are none, as their stress stands in the equations, nor are periodic ones,
/// whose two stresses cancel.
std::vector<CornerSide> corner_sides_of(const Flow& flow, const ForceSide& force);

}  // namespace tether::fem
