// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/immersed_map.hpp"

#include <algorithm>

#include "solvers/fem/flow_elements.hpp"

namespace tether::fem {

ImmersedMap::ImmersedMap(const Flow& flow) : flow_(flow), finder_(flow.mesh), count_(node_count_of(flow.mesh.kind)) {}

std::optional<std::size_t> ImmersedMap::place(std::span<const double> x) {
  const std::size_t nodes = x.size() / 2;
  element_.resize(nodes, -1), cell_.resize(nodes), parts_.resize(nodes * size());
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto found = finder_.find({x[2 * n], x[2 * n + 1]}, element_[n]);
    if (!found) return n;
    element_[n] = found->element;
    const auto write = [&](const auto& values) { std::copy(values.begin(), values.end(), &parts_[n * size()]); };
    with_values_at(flow_.mesh.kind, found->s, write);
  }
  cells_ = element_;
  std::sort(cells_.begin(), cells_.end());
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  nodes_.clear();
  for (const int cell : cells_) {
    for (int a = 0; a < count_; ++a)
      nodes_.push_back(flow_.twin[static_cast<std::size_t>(flow_.mesh.element(static_cast<std::size_t>(cell))[a])]);
  }
  for (std::size_t n = 0; n < nodes; ++n)
    cell_[n] = static_cast<std::size_t>(std::lower_bound(cells_.begin(), cells_.end(), element_[n]) - cells_.begin());
  return std::nullopt;
}

void ImmersedMap::velocities(std::span<const double> v, std::span<double> V) const {
  for (std::size_t n = 0; n < cell_.size(); ++n) {
    double x = 0, y = 0;
    for (std::size_t a = 0; a < size(); ++a) {
      const auto node = static_cast<std::size_t>(nodes_[cell_[n] * size() + a]);
      x += parts_[n * size() + a] * v[2 * node], y += parts_[n * size() + a] * v[2 * node + 1];
    }
    V[2 * n] = x, V[2 * n + 1] = y;
  }
}

void ImmersedMap::add_forces(std::span<const double> F, std::span<double> f) const {
  for (std::size_t n = 0; n < cell_.size(); ++n) {
    for (std::size_t a = 0; a < size(); ++a) {
      const auto node = static_cast<std::size_t>(nodes_[cell_[n] * size() + a]);
      f[2 * node] += parts_[n * size() + a] * F[2 * n], f[2 * node + 1] += parts_[n * size() + a] * F[2 * n + 1];
    }
  }
}

}  // namespace tether::fem
