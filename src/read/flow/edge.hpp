// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "base/vec.hpp"
#include "model/flow.hpp"

namespace tether {

/// Returns where a node of a plane mesh is.
Vec<2> node_place(const Mesh& mesh, int node);

/// The place s, -1 .. 1, of an element side of a plane mesh: the curve through its nodes in the order of the side.
Vec<2> side_place(const Mesh& mesh, const int* side, double s);

/// A box around an element side, which may bulge out of the box of its nodes.
Box<2> box_of_side(const Mesh& mesh, const int* side);

/// The place of an edge that is nearest to another place.
struct OnEdge {
  Vec<2> place{};
  double away = std::numeric_limits<double>::infinity();  ///< between the two [length]
  double length = 0;                                      ///< of the element side, between its ends [length]
  const int* side = nullptr;                              ///< its nodes; null without an edge
  const FlowSide* of = nullptr;                           ///< of a fluid's edge: the side that it is a part of
};
/// Finds the nearest place of one element side.
OnEdge nearest_of_side(const Mesh& mesh, const int* side, const Vec<2>& at);
/// Finds the nearest place of many sides.
OnEdge nearest_of_sides(const Mesh& mesh, const Sides& sides, const Vec<2>& at);

/// The edge of a fluid's mesh, that of its holes included.
class FlowEdge {
 public:
  /// The flow must live as long.
  explicit FlowEdge(const Flow& flow);

  OnEdge nearest(const Vec<2>& at) const;
  /// The inflow that a place lies on, to 1e-9 of the mesh's size, or null.
  const FlowSide* inflow_at(const Vec<2>& at) const;
  /// Length of the shortest element side, between its ends, whose box meets this one; infinite where none does.
  double shortest_in(const Box<2>& box) const;

 private:
  const Flow& flow_;
  std::vector<Box<2>> boxes_;    // of all element sides
  std::vector<double> lengths_;  // between their ends [length]
};

}  // namespace tether
