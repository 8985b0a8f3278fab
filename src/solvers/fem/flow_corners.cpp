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

using Ends = std::set<std::pair<int, int>>;

/// The element sides of a force, by their ends.
Ends own_sides(const Flow& flow, const ForceSide& force) {
  Ends own;
  each_side(flow, force.sides, [&](auto first, auto last) { own.insert(std::minmax(*first, *(last - 1))); });
  return own;
}

/// Calls f with each element side of walls and inflows, whether it is of the force, and whether it slips.
template <class Function>
void each_held_side(const Flow& flow, const Ends& own, const Function& f) {
  for (const FlowSide& side : flow.sides) {
    if (side.boundary == Boundary::open || side.boundary == Boundary::periodic) continue;
    each_side(flow, side.sides, [&](auto first, auto last) {
      f(Sides(first, last), own.contains(std::minmax(*first, *(last - 1))), side.boundary == Boundary::slip);
    });
  }
}

/// The force's nodes that other walls and inflows have, too.
std::set<int> shared_nodes(const Flow& flow, const ForceSide& force, const Ends& own) {
  const std::set<int> on(force.sides.begin(), force.sides.end());
  std::set<int> shared;
  each_held_side(flow, own, [&](const Sides& nodes, bool is_own, bool) {
    for (const int node : nodes) {
      if (!is_own && on.contains(node)) shared.insert(node);
    }
  });
  return shared;
}

}  // namespace

std::vector<CornerSide> corner_sides_of(const Flow& flow, const ForceSide& force) {
  const Ends own = own_sides(flow, force);
  const std::set<int> shared = shared_nodes(flow, force, own);
  std::vector<CornerSide> corners;
  each_held_side(flow, own, [&](const Sides& nodes, bool is_own, bool slip) {
    CornerSide corner{.nodes = nodes, .slip = slip, .own = is_own};
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      if (shared.contains(nodes[a])) corner.shared.push_back(static_cast<int>(a));
    }
    if (!corner.shared.empty()) corners.push_back(std::move(corner));
  });
  return corners;
}

std::vector<NodeShare> node_shares_of(const Flow& flow, const ForceSide& force) {
  const std::set<int> shared = shared_nodes(flow, force, own_sides(flow, force));
  std::vector<int> twins(flow.twin.size(), 0);
  for (const int of : flow.twin) ++twins[static_cast<std::size_t>(of)];
  std::vector<NodeShare> nodes;
  for (const int node : std::set<int>(force.sides.begin(), force.sides.end())) {
    const auto of = static_cast<std::size_t>(flow.twin[static_cast<std::size_t>(node)]);
    nodes.push_back({static_cast<std::size_t>(node), of, (shared.contains(node) ? 0.5 : 1) / twins[of]});
  }
  return nodes;
}

}  // namespace tether::fem
