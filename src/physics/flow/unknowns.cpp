// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace tether::fem {

Lists clusters_of(const Flow& flow) {
  Lists clusters;
  const auto per_element = static_cast<std::size_t>(node_count_of(flow.mesh.kind));
  for (std::size_t e = 0; e < flow.mesh.element_count(); ++e) {
    std::vector<int> nodes;
    for (std::size_t a = 0; a < per_element; ++a)
      nodes.push_back(flow.twin[static_cast<std::size_t>(flow.mesh.element(e)[a])]);
    clusters.add(nodes);
  }
  return clusters;
}

std::size_t axis_across(const Mesh& mesh, std::span<const int> side) {
  const double* from = &mesh.x[2 * static_cast<std::size_t>(side.front())];
  const double* to = &mesh.x[2 * static_cast<std::size_t>(side.back())];
  return std::abs(to[0] - from[0]) > std::abs(to[1] - from[1]) ? 1 : 0;
}

namespace {

constexpr std::array corners_of_q1{0, 1, 2, 3};
constexpr std::array corners_of_q2{0, 2, 6, 8};

}  // namespace

std::span<const int> pressure_nodes(FlowElement element) {
  return element == FlowElement::q1q1 ? std::span<const int>(corners_of_q1) : std::span<const int>(corners_of_q2);
}

FlowUnknowns::FlowUnknowns(const Flow& of) : flow(of), holders(holders_of(of)) {
  const Mesh& mesh = flow.mesh;
  const std::size_t nodes = mesh.node_count();
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  const auto twin = [&](int node) { return static_cast<std::size_t>(flow.twin[static_cast<std::size_t>(node)]); };
  std::vector<std::uint8_t> held(2 * nodes, 0), has_pressure(nodes, 0);
  bool open = false;
  for (const FlowSide& side : flow.sides) {
    open |= side.boundary == Boundary::open;
    for (std::size_t n = 0; n < side.sides.size() && side.boundary == Boundary::slip; ++n) {
      const auto of_element = std::span(side.sides).subspan(n / per_side * per_side, per_side);
      held[2 * twin(side.sides[n]) + axis_across(mesh, of_element)] = 1;
    }
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    if (holders[n].side >= 0) held[2 * n] = held[2 * n + 1] = 1;
  }
  const auto with_pressure = pressure_nodes(flow.element);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int a : with_pressure) has_pressure[twin(mesh.element(e)[a])] = 1;
  }
  pinned = !open && !any_own_volume(flow);
  bool to_pin = pinned;
  velocity.assign(2 * nodes, -1), pressure.assign(nodes, -1), first.push_back(0);
  for (std::size_t n = 0; n < nodes; ++n) {
    int next = first.back();
    if (static_cast<std::size_t>(flow.twin[n]) == n) {
      for (std::size_t i = 0; i < 2; ++i) velocity[2 * n + i] = held[2 * n + i] ? -1 : next++;
      if (has_pressure[n] && to_pin)
        to_pin = false;
      else if (has_pressure[n])
        pressure[n] = next++;
    }
    first.push_back(next);
  }
  copy_to_twins(velocity, 2), copy_to_twins(pressure, 1);
}

void FlowUnknowns::prescribe(double time, std::span<double> v) const {
  for (std::size_t n = 0; n < holders.size(); ++n) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (velocity[2 * n + i] < 0) v[2 * n + i] = 0;
    }
    if (holders[n].side < 0) continue;
    const double* place = &flow.mesh.x[2 * static_cast<std::size_t>(holders[n].node)];
    const auto at = flow.sides[static_cast<std::size_t>(holders[n].side)].velocity.at(place[0], place[1], time);
    v[2 * n] = at[0], v[2 * n + 1] = at[1];
  }
}

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
