// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_corners.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace tether::fem {
namespace {

/// Calls f with the first and the last of each element side's nodes.
template <class Function>
void each_side(const Flow& flow, const Sides& sides, const Function& f) {
  const auto per_side = static_cast<std::ptrdiff_t>(side_node_count_of(flow.mesh.kind));
  for (auto first = sides.begin(); first != sides.end(); first += per_side) f(first, first + per_side);
}

}  // namespace

std::vector<CornerSide> corner_sides_of(const Flow& flow, const ForceSide& force) {
  const std::set<int> on(force.sides.begin(), force.sides.end());
  std::set<std::pair<int, int>> own;
  each_side(flow, force.sides, [&](auto first, auto last) { own.insert(std::minmax(*first, *(last - 1))); });
  std::vector<CornerSide> corners;
  for (const FlowSide& side : flow.sides) {
    if (side.boundary == Boundary::open || side.boundary == Boundary::periodic) continue;
    each_side(flow, side.sides, [&](auto first, auto last) {
      if (own.contains(std::minmax(*first, *(last - 1)))) return;
      CornerSide corner{.nodes = Sides(first, last), .slip = side.boundary == Boundary::slip};
      for (std::size_t a = 0; a < corner.nodes.size(); ++a) {
        if (on.contains(corner.nodes[a])) corner.shared.push_back(static_cast<int>(a));
      }
      if (!corner.shared.empty()) corners.push_back(std::move(corner));
    });
  }
  return corners;
}

}  // namespace tether::fem
