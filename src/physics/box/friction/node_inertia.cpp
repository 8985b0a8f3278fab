// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/node_inertia.hpp"

#include <utility>

#include "base/numbers.hpp"

namespace tether::coupled {

std::vector<double> masses_as_one(const NodeInertia& nodes, int dim) {
  std::vector<double> sums(nodes.size(), 0.0), along(nodes.size(), 0.0), of(nodes.size());
  for (std::size_t axis = 0; axis < at(dim); ++axis) {
    for (std::size_t k = 0; k < nodes.size(); ++k) along[k] = k % at(dim) == axis ? 1 : 0;
    nodes.mass.multiply(along, of);
    for (std::size_t k = axis; k < nodes.size(); k += at(dim)) sums[k] = of[k];
  }
  return sums;
}

NodeInertia loose_nodes(std::span<const double> masses, std::vector<std::uint8_t> held) {
  NodeInertia nodes{.mass = {}, .held = std::move(held)};
  nodes.mass.n = static_cast<std::int64_t>(masses.size());
  nodes.mass.start.push_back(0);
  for (const double mass : masses) {
    nodes.mass.row.push_back(nodes.mass.start.back());
    nodes.mass.value.push_back(mass);
    nodes.mass.start.push_back(nodes.mass.start.back() + 1);
  }
  return nodes;
}

}  // namespace tether::coupled
