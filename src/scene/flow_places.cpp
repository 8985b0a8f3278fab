// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "grid/lagrange.hpp"
#include "grid/mesh_flaws.hpp"
#include "grid/point_finder.hpp"
#include "scene/flow_checks.hpp"
#include "scene/flow_of_deck.hpp"
#include "scene/solids.hpp"

namespace tether {
namespace {

using Place = std::array<double, 2>;

constexpr double tolerance = 1e-9;  // of the mesh's size

Place place_of(const Mesh& mesh, int node) {
  const auto n = 2 * static_cast<std::size_t>(node);
  return {mesh.x[n], mesh.x[n + 1]};
}

double size_of(const Mesh& mesh) {
  const auto [low, high] = std::minmax_element(mesh.x.begin(), mesh.x.end());
  return *high - *low;
}

double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// The place of an element side, the curve through its nodes in the order of the side, that is nearest to `at`.
template <int p>
Place nearest_of(const Mesh& mesh, const int* side, const Place& at) {
  const auto place = [&](double s) {
    const auto N = Line<p>::values(s);
    Place x{};
    for (std::size_t a = 0; a < N.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) x[i] += N[a] * place_of(mesh, side[a])[i];
    }
    return x;
  };
  double s = 0;
  for (int k = 0; k < 20; ++k) {
    const auto dN = Line<p>::slopes(s);
    const Place x = place(s), off{at[0] - x[0], at[1] - x[1]};
    Place along{};
    for (std::size_t a = 0; a < dN.size(); ++a) {
      for (std::size_t i = 0; i < 2; ++i) along[i] += dN[a] * place_of(mesh, side[a])[i];
    }
    const double step = (off[0] * along[0] + off[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    const double next = std::clamp(s + step, -1.0, 1.0);
    if (std::abs(next - s) < 1e-15) break;
    s = next;
  }
  return place(s);
}

Place nearest_of(const Mesh& mesh, const int* side, const Place& at) {
  return mesh.kind == ElementKind::quad4 ? nearest_of<1>(mesh, side, at) : nearest_of<2>(mesh, side, at);
}

/// The inflow that a place lies on, or null.
const FlowSide* inflow_at(const Flow& flow, const Place& at) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(flow.mesh.kind));
  const double within = tolerance * size_of(flow.mesh);
  for (const FlowSide& side : flow.sides) {
    for (std::size_t s = 0; s < side.sides.size() && side.boundary == Boundary::inflow; s += per_side) {
      const int* nodes = &side.sides[s];
      if (apart(nearest_of(flow.mesh, nodes, at), at) <= within) return &side;
    }
  }
  return nullptr;
}

/// The place of the boundary that is nearest to one outside of it, and the side's nodes; null without a boundary.
struct OnBoundary {
  Place place{};
  const int* side = nullptr;
};

OnBoundary nearest_on_boundary(const Flow& flow, const Place& at) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(flow.mesh.kind));
  OnBoundary nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const FlowSide& side : flow.sides) {
    for (std::size_t s = 0; s < side.sides.size(); s += per_side) {
      const Place place = nearest_of(flow.mesh, &side.sides[s], at);
      const double away = apart(place, at);
      if (away < least) nearest = {place, &side.sides[s]}, least = away;
    }
  }
  return nearest;
}

/// Square root of the area between the corners of the element that a side of the boundary belongs to.
double element_size(const Mesh& mesh, const int* side) {
  const auto count = static_cast<std::size_t>(node_count_of(mesh.kind));
  const auto line = static_cast<std::size_t>(order_of(mesh.kind));
  const auto ends = std::array{side[0], side[line]};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span nodes(mesh.element(e), count);
    if (std::any_of(ends.begin(), ends.end(), [&](int n) { return std::ranges::find(nodes, n) == nodes.end(); }))
      continue;
    const Place a = place_of(mesh, nodes[0]), b = place_of(mesh, nodes[line]);
    const Place c = place_of(mesh, nodes[count - 1]), d = place_of(mesh, nodes[count - 1 - line]);
    return std::sqrt(0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])));
  }
  return 0;
}

/// A place on a curved wall is outside the elements beside it, whose edges only come near to the curve, and so may be
/// one of few digits: what is less than half an element away is meant to be on the edge.
void place_probe(const Deck& deck, int k, const PointFinder& finder, const Flow& flow, Place& probe,
                 Diagnostics& diagnostics) {
  if (finder.find(probe)) return;
  const OnBoundary edge = nearest_on_boundary(flow, probe);
  const double away = edge.side ? apart(edge.place, probe) : 0;
  const auto remark = [&](Severity severity, const std::string& message, const char* hint) {
    diagnostics.add(deck.remark(severity, "flow", "probe", {1, k}, message, hint));
  };
  const std::string at = fmt::format("probe {} at ({:.6g}, {:.6g})", k, probe[0], probe[1]);
  if (!edge.side || away >= 0.5 * element_size(flow.mesh, edge.side))
    return remark(Severity::error, at + " lies outside the fluid",
                  "a probe records the flow at a place of its mesh, edges included");
  remark(Severity::warning,
         fmt::format("{} lies outside the fluid's mesh by {:.3g} and is moved to ({:.6g}, {:.6g})", at, away,
                     edge.place[0], edge.place[1]),
         "the edges of elements come only near to a curved wall");
  probe = edge.place;
}

/// Of the flow's probes, which are those of the deck that have both numbers, in their order.
void place_probes(const Deck& deck, const PointFinder& finder, Flow& flow, Diagnostics& diagnostics) {
  auto probe = flow.probes.begin();
  for (const Subscript at : deck.given_elements("flow", "probe")) {
    if (at[0] == 1 && deck.given("flow", "probe", 2, at[1]))
      place_probe(deck, at[1], finder, flow, *probe++, diagnostics);
  }
}

/// Of each region the first node that is wrong.
void check_bodies(const Deck& deck, const Solids& solids, const Flow& flow, const PointFinder& finder,
                  Diagnostics& diagnostics) {
  const std::vector<int> regions = regions_of(deck, false);
  std::set<std::pair<int, int>> seen;
  std::set<int> told;
  for (std::size_t e = 0; e < solids.mesh.element_count(); ++e) {
    const int r = regions[static_cast<std::size_t>(solids.mesh.region[e])];
    for (int a = 0; a < node_count_of(solids.mesh.kind); ++a) {
      const int node = solids.mesh.element(e)[a];
      if (told.contains(r) || !seen.emplace(r, node).second) continue;
      const Place at = place_of(solids.mesh, node);
      const FlowSide* inflow = inflow_at(flow, at);
      if (!inflow && finder.find(at)) continue;
      told.insert(r);
      const std::string what = inflow ? fmt::format("on the inflow '{}'", inflow->name) : "outside the fluid";
      diagnostics.add(deck.remark(
          Severity::error, "reg", "xvi", {1, r},
          fmt::format("region {}: its node at {} lies {}", r, place_text(solids.mesh, node), what),
          inflow ? "an immersed body goes with the fluid, and there its velocity is prescribed"
                 : "an immersed body lies within the fluid's blocks, which go on beneath it; a hole is outside"));
    }
  }
}

}  // namespace

void place_in_flow(const Deck& deck, const Scene& scene, Flow& flow, Diagnostics& diagnostics) {
  const PointFinder finder(flow.mesh);
  place_probes(deck, finder, flow, diagnostics);
  if (scene.solids) check_bodies(deck, *scene.solids, flow, finder, diagnostics);
}

}  // namespace tether
