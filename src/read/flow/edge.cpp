// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/flow/edge.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "grid/mesh_extent.hpp"
#include "grid/point_finder.hpp"
#include "grid/shapes.hpp"
#include "read/flow/checks.hpp"

namespace tether {
namespace {

double apart(const Vec<2>& a, const Vec<2>& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

std::size_t per_side(const Mesh& mesh) { return static_cast<std::size_t>(side_node_count_of(mesh.kind)); }

/// Sum of the nodes' places by weights, values or slopes of the side's functions.
template <class Weights>
Vec<2> weighted(const Mesh& mesh, const int* side, const Weights& weights) {
  Vec<2> sum{};
  for (std::size_t a = 0; a < weights.size(); ++a) {
    const Vec<2> x = node_place(mesh, side[a]);
    sum[0] += weights[a] * x[0], sum[1] += weights[a] * x[1];
  }
  return sum;
}

template <int p>
Vec<2> nearest_place_of(const Mesh& mesh, const int* side, const Vec<2>& at) {
  double s = 0;
  for (int k = 0; k < 20; ++k) {
    const Vec<2> x = weighted(mesh, side, Line<p>::values(s)), along = weighted(mesh, side, Line<p>::slopes(s));
    const Vec<2> off{at[0] - x[0], at[1] - x[1]};
    const double step = (off[0] * along[0] + off[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    const double next = std::clamp(s + step, -1.0, 1.0);
    if (std::abs(next - s) < 1e-15) break;
    s = next;
  }
  return weighted(mesh, side, Line<p>::values(s));
}

}  // namespace

Vec<2> node_place(const Mesh& mesh, int node) {
  const auto n = 2 * static_cast<std::size_t>(node);
  return {mesh.x[n], mesh.x[n + 1]};
}

Vec<2> side_place(const Mesh& mesh, const int* side, double s) {
  return order_of(mesh.kind) == 1 ? weighted(mesh, side, Line<1>::values(s)) : weighted(mesh, side, Line<2>::values(s));
}

/// A parabola goes beyond its three nodes by no more than an eighth of what separates its ends from its vertex, which
/// is less than the extent of its nodes: half of that is plenty.
Box<2> box_of_side(const Mesh& mesh, const int* side) {
  Box<2> box{node_place(mesh, side[0]), node_place(mesh, side[0])};
  for (std::size_t a = 1; a < per_side(mesh); ++a) box.add(node_place(mesh, side[a]));
  const double more = order_of(mesh.kind) == 1 ? 0 : 0.5 * std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  for (std::size_t i = 0; i < 2; ++i) box.low[i] -= more, box.high[i] += more;
  return box;
}

OnEdge nearest_of_side(const Mesh& mesh, const int* side, const Vec<2>& at) {
  const Vec<2> place =
      order_of(mesh.kind) == 1 ? nearest_place_of<1>(mesh, side, at) : nearest_place_of<2>(mesh, side, at);
  const double length = apart(node_place(mesh, side[0]), node_place(mesh, side[per_side(mesh) - 1]));
  return {place, apart(place, at), length, side, nullptr};
}

OnEdge nearest_of_sides(const Mesh& mesh, const Sides& sides, const Vec<2>& at) {
  OnEdge nearest;
  for (std::size_t s = 0; s < sides.size(); s += per_side(mesh)) {
    const OnEdge here = nearest_of_side(mesh, &sides[s], at);
    if (here.away < nearest.away) nearest = here;
  }
  return nearest;
}

FlowEdge::FlowEdge(const Flow& flow) : flow_(flow) {
  const std::size_t count = per_side(flow.mesh);
  for (const FlowSide& side : flow.sides) {
    for (std::size_t s = 0; s < side.sides.size(); s += count) {
      const int* nodes = &side.sides[s];
      boxes_.push_back(box_of_side(flow.mesh, nodes));
      lengths_.push_back(apart(node_place(flow.mesh, nodes[0]), node_place(flow.mesh, nodes[count - 1])));
    }
  }
}

OnEdge FlowEdge::nearest(const Vec<2>& at) const {
  OnEdge nearest;
  for (const FlowSide& side : flow_.sides) {
    OnEdge here = nearest_of_sides(flow_.mesh, side.sides, at);
    here.of = &side;
    if (here.away < nearest.away) nearest = here;
  }
  return nearest;
}

const FlowSide* FlowEdge::inflow_at(const Vec<2>& at) const {
  const double within = coincident * MeshExtent(flow_.mesh).size();
  for (const FlowSide& side : flow_.sides) {
    if (side.boundary != Boundary::inflow) continue;
    if (nearest_of_sides(flow_.mesh, side.sides, at).away <= within) return &side;
  }
  return nullptr;
}

double FlowEdge::shortest_in(const Box<2>& box) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < boxes_.size(); ++s) {
    if (boxes_[s].meets(box)) shortest = std::min(shortest, lengths_[s]);
  }
  return shortest;
}

namespace {

/// Square root of the area between the corners of the element that a side of the boundary belongs to.
double element_size(const Mesh& mesh, const int* side) {
  const auto count = static_cast<std::size_t>(node_count_of(mesh.kind));
  const auto line = static_cast<std::size_t>(order_of(mesh.kind));
  const auto ends = std::array{side[0], side[line]};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span nodes(mesh.element(e), count);
    if (std::any_of(ends.begin(), ends.end(), [&](int n) { return std::ranges::find(nodes, n) == nodes.end(); }))
      continue;
    const Vec<2> a = node_place(mesh, nodes[0]), b = node_place(mesh, nodes[line]);
    const Vec<2> c = node_place(mesh, nodes[count - 1]), d = node_place(mesh, nodes[count - 1 - line]);
    return std::sqrt(0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])));
  }
  return 0;
}

/// A place on a curved wall is outside the elements beside it, whose edges only come near to the curve, and so may be
/// one of few digits: what is less than half an element away is meant to be on the edge.
void place_probe(const Deck& deck, int k, const PointFinder& finder, const Flow& flow, Vec<2>& probe,
                 Diagnostics& diagnostics) {
  if (finder.find(probe)) return;
  const OnEdge edge = FlowEdge(flow).nearest(probe);
  const auto remark = [&](Severity severity, const std::string& message, const char* hint) {
    diagnostics.add(deck.remark(severity, "flow.probe", {1, k}, message, hint));
  };
  const std::string at = fmt::format("probe {} at ({:.6g}, {:.6g})", k, probe[0], probe[1]);
  if (!edge.side || edge.away >= 0.5 * element_size(flow.mesh, edge.side))
    return remark(Severity::error, at + " lies outside the fluid",
                  "a probe records the flow at a place of its mesh, edges included");
  remark(Severity::warning,
         fmt::format("{} lies outside the fluid's mesh by {:.3g} and is moved to ({:.6g}, {:.6g})", at, edge.away,
                     edge.place[0], edge.place[1]),
         "the edges of elements come only near to a curved wall");
  probe = edge.place;
}

}  // namespace

void place_probes(const Deck& deck, Flow& flow, Diagnostics& diagnostics) {
  const PointFinder finder(flow.mesh);
  auto probe = flow.probes.begin();
  for (const Subscript at : deck.given_elements("flow.probe")) {
    if (at[0] == 1 && deck.given("flow.probe", 2, at[1])) place_probe(deck, at[1], finder, flow, *probe++, diagnostics);
  }
}

}  // namespace tether
