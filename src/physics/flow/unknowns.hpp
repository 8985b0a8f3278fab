// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/sparse_matrix.hpp"
#include "model/flow.hpp"

namespace tether::fem {

/// The clusters of unknowns that elements couple, for ClusterPattern: the nodes of each, twins as one.
Lists clusters_of(const Flow& flow);

/// Returns the axis, 0 or 1, across an element side that runs along the other one.
std::size_t axis_across(const Mesh& mesh, std::span<const int> side);

/// Which numbers of a flow's nodes are unknown: velocities that no side prescribes, pressures at the corners of the
/// elements. Nodes on periodic sides share those of their twins. Where no side is open and no body
/// has a law for its volume, one pressure is pinned to zero.
class FlowUnknowns {
 public:
  /// The flow must outlive it.
  explicit FlowUnknowns(const Flow& flow);

  /// Sets the velocities that sides prescribe at a time. [velocity], 2 numbers a node
  void prescribe(double time, std::span<double> v) const;
  /// Gives twins the numbers of the nodes whose unknowns they share; `per_node` numbers a node.
  template <class Number>
  void copy_to_twins(std::vector<Number>& values, std::size_t per_node) const {
    for (std::size_t n = 0; n < flow.twin.size(); ++n) {
      const auto of = static_cast<std::size_t>(flow.twin[n]);
      for (std::size_t i = 0; of != n && i < per_node; ++i) values[n * per_node + i] = values[of * per_node + i];
    }
  }

  const Flow& flow;
  std::vector<Holder> holders;  ///< of each node the side that prescribes its velocity
  std::vector<int> velocity;    ///< unknown of each component of each node, -1 where it is prescribed
  std::vector<int> pressure;    ///< unknown of each node, -1 where it has none or is pinned
  std::vector<int> first;       ///< of each node the first of its unknowns, which stand together; and their number
  bool pinned = false;
  std::size_t count() const { return static_cast<std::size_t>(first.back()); }
};

/// Nodes of an element that have a pressure, counted in the element.
std::span<const int> pressure_nodes(FlowElement element);

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
