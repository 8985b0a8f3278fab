// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/stream_function.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>

#include "base/numbers.hpp"
#include "physics/flow/unknowns.hpp"

namespace tether::fem {
namespace {

/// Returns whether nothing flows through an element side: walls, and moving ones that run along themselves and an axis.
bool is_closed(const Mesh& mesh, const FlowSide& of, std::span<const int> side) {
  if (of.boundary == Boundary::no_slip || of.boundary == Boundary::slip) return true;
  const std::size_t across = axis_across(mesh, side);
  if (of.boundary != Boundary::moving || of.velocity.component[across]) return false;
  const auto place = [&](int node, std::size_t axis) { return mesh.x[2 * at(node) + axis]; };
  const double length = std::abs(place(side.back(), 1 - across) - place(side.front(), 1 - across));
  return std::ranges::all_of(side, [&](int node) {
    return std::abs(place(node, across) - place(side.front(), across)) < coincident * length;
  });
}

/// Returns the unknown of each node, from 0: nodes that closed sides join share theirs.
std::vector<int> lines_of_walls(const Flow& flow) {
  const std::size_t nodes = flow.mesh.node_count(), per_side = at(side_node_count_of(flow.mesh.kind));
  boost::disjoint_sets_with_storage<> lines(nodes);
  for (std::size_t n = 0; n < nodes; ++n) lines.make_set(n);
  for (const FlowSide& of : flow.sides) {
    for (std::size_t first = 0; first < of.sides.size(); first += per_side) {
      const std::span<const int> side = std::span(of.sides).subspan(first, per_side);
      if (!is_closed(flow.mesh, of, side)) continue;
      for (const int node : side) lines.union_set(at(side.front()), at(node));
    }
  }
  std::vector<int> unknown(nodes, -1), of_set(nodes, -1);
  int count = 0;
  for (std::size_t n = 0; n < nodes; ++n) {
    int& shared = of_set[lines.find_set(n)];
    if (shared < 0) shared = count++;
    unknown[n] = shared;
  }
  return unknown;
}

}  // namespace

StreamFunction::StreamFunction(const Flow& flow, const FlowElements& elements)
    : elements_(elements), unknown_(lines_of_walls(flow)), A_(elements.laplacian(unknown_)) {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(A_.n), 0);
  held[0] = 1;
  hold(A_, held, 1);
  solver_.factorise(A_, Definite::positive);
}

std::vector<double> StreamFunction::of(std::span<const double> v) const {
  const std::vector<double> source = elements_.stream_source(v);
  std::vector<double> value(static_cast<std::size_t>(A_.n), 0.0), psi(source.size());
  for (std::size_t n = 0; n < source.size(); ++n) value[at(unknown_[n])] += source[n];
  value[0] = 0;
  solver_.solve(value, value);
  for (std::size_t n = 0; n < psi.size(); ++n) psi[n] = value[at(unknown_[n])];
  return psi;
}

}  // namespace tether::fem
