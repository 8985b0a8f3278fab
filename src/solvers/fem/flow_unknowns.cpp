// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/flow_unknowns.hpp"

#include <algorithm>
#include <cmath>

namespace tether::fem {
namespace {

constexpr std::array corners_of_q1{0, 1, 2, 3};
constexpr std::array corners_of_q2{0, 2, 6, 8};

/// Which sides win at the nodes where they meet: walls at rest, then moving walls, then inflows.
int rank(Boundary boundary) {
  return boundary == Boundary::no_slip ? 3 : boundary == Boundary::moving ? 2 : boundary == Boundary::inflow ? 1 : 0;
}

/// The axis across a side that runs along the other one.
std::size_t axis_across(const Mesh& mesh, const int* side, int nodes) {
  const double* from = &mesh.x[2 * static_cast<std::size_t>(side[0])];
  const double* to = &mesh.x[2 * static_cast<std::size_t>(side[nodes - 1])];
  return std::abs(to[0] - from[0]) > std::abs(to[1] - from[1]) ? 1 : 0;
}

}  // namespace

std::span<const int> pressure_nodes(FlowElement element) {
  return element == FlowElement::q1q1 ? std::span<const int>(corners_of_q1) : std::span<const int>(corners_of_q2);
}

FlowUnknowns::FlowUnknowns(const Flow& of) : flow(of) {
  const Mesh& mesh = flow.mesh;
  const std::size_t nodes = mesh.node_count();
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  const auto twin = [&](int node) { return static_cast<std::size_t>(flow.twin[static_cast<std::size_t>(node)]); };
  prescribed_by.assign(nodes, -1);
  std::vector<std::uint8_t> held(2 * nodes, 0), has_pressure(nodes, 0);
  bool open = false;
  for (std::size_t k = 0; k < flow.sides.size(); ++k) {
    const FlowSide& side = flow.sides[k];
    open |= side.boundary == Boundary::open;
    for (std::size_t n = 0; n < side.sides.size(); ++n) {
      const std::size_t node = twin(side.sides[n]);
      int& by = prescribed_by[node];
      if (side.boundary == Boundary::slip) {
        const int* first = &side.sides[n / per_side * per_side];
        held[2 * node + axis_across(mesh, first, static_cast<int>(per_side))] = 1;
      } else if (rank(side.boundary) > (by < 0 ? 0 : rank(flow.sides[static_cast<std::size_t>(by)].boundary))) {
        by = static_cast<int>(k);
        held[2 * node] = held[2 * node + 1] = 1;
      }
    }
  }
  const auto with_pressure = pressure_nodes(flow.element);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const int a : with_pressure) has_pressure[twin(mesh.element(e)[a])] = 1;
  }
  pinned = !open;
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
  copy_to_twins(velocity, 2), copy_to_twins(pressure, 1), copy_to_twins(prescribed_by, 1);
}

void FlowUnknowns::prescribe(double time, std::span<double> v) const {
  for (std::size_t n = 0; n < prescribed_by.size(); ++n) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (velocity[2 * n + i] < 0) v[2 * n + i] = 0;
    }
    if (prescribed_by[n] < 0) continue;
    const FlowVector& given = flow.sides[static_cast<std::size_t>(prescribed_by[n])].velocity;
    const auto at = given.at(flow.mesh.x[2 * n], flow.mesh.x[2 * n + 1], time);
    v[2 * n] = at[0], v[2 * n + 1] = at[1];
  }
}

}  // namespace tether::fem
