// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "grid/point_finder.hpp"
#include "read/flow/checks.hpp"
#include "read/flow/edge.hpp"

namespace tether {
namespace {

using Place = std::array<double, 2>;

/// Square root of the area between the corners of the element that a side of the boundary belongs to.
double element_size(const Mesh& mesh, const int* side) {
  const auto count = static_cast<std::size_t>(node_count_of(mesh.kind));
  const auto line = static_cast<std::size_t>(order_of(mesh.kind));
  const auto ends = std::array{side[0], side[line]};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span nodes(mesh.element(e), count);
    if (std::any_of(ends.begin(), ends.end(), [&](int n) { return std::ranges::find(nodes, n) == nodes.end(); }))
      continue;
    const Place a = node_place(mesh, nodes[0]), b = node_place(mesh, nodes[line]);
    const Place c = node_place(mesh, nodes[count - 1]), d = node_place(mesh, nodes[count - 1 - line]);
    return std::sqrt(0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])));
  }
  return 0;
}

/// A place on a curved wall is outside the elements beside it, whose edges only come near to the curve, and so may be
/// one of few digits: what is less than half an element away is meant to be on the edge.
void place_probe(const Deck& deck, int k, const PointFinder& finder, const Flow& flow, Place& probe,
                 Diagnostics& diagnostics) {
  if (finder.find(probe)) return;
  const OnEdge edge = FlowEdge(flow).nearest(probe);
  const auto remark = [&](Severity severity, const std::string& message, const char* hint) {
    diagnostics.add(deck.remark(severity, "flow", "probe", {1, k}, message, hint));
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
  for (const Subscript at : deck.given_elements("flow", "probe")) {
    if (at[0] == 1 && deck.given("flow", "probe", 2, at[1]))
      place_probe(deck, at[1], finder, flow, *probe++, diagnostics);
  }
}

}  // namespace tether
