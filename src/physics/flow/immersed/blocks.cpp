// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/flow/immersed/blocks.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace tether::fem {
namespace {

using Matrix = EigenSparse;

}  // namespace

ImmersedBlocks::ImmersedBlocks(const FlowUnknowns& unknowns, const ImmersedMap& map, const ImmersedPressure* pressure,
                               const Matrix& S, const Matrix& D)
    : unknowns_(unknowns),
      map_(map),
      pressure_(pressure),
      per_element_(static_cast<std::size_t>(map.nodes_per_cell())) {
  for (Eigen::Index d = 0; d < S.outerSize(); d += 2) {
    for (Matrix::InnerIterator at(S, d); at; ++at)
      pairs_.push_back(std::minmax(
          {element_of(static_cast<std::size_t>(at.row()) / 2), element_of(static_cast<std::size_t>(d) / 2)}));
  }
  for (Eigen::Index d = 0; pressure_ && d < D.outerSize(); d += 2) {
    for (Matrix::InnerIterator at(D, d); at; ++at)
      pairs_.push_back(std::minmax({pressure_->elements()[static_cast<std::size_t>(at.row()) / 4],
                                    element_of(static_cast<std::size_t>(d) / 2)}));
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  blocks_.reserve(pairs_.size());
  for (const Pair& pair : pairs_) blocks_.emplace_back(size_of(pair) * size_of(pair), 0.0);
}

std::size_t ImmersedBlocks::size_of(const Pair& pair) const {
  return (pair.first == pair.second ? 1 : 2) * places * per_element_;
}

std::size_t ImmersedBlocks::number_of(int a, int b) const {
  const Pair pair = std::minmax({a, b});
  return static_cast<std::size_t>(std::lower_bound(pairs_.begin(), pairs_.end(), pair) - pairs_.begin());
}

std::size_t ImmersedBlocks::begin_of(int element, const Pair& pair) const {
  return element == pair.first ? 0 : places * per_element_;
}

Lists ImmersedBlocks::clusters() const {
  const Flow& flow = unknowns_.flow;
  Lists clusters;
  for (const auto& [a, b] : pairs_) {
    std::vector<int> nodes;
    for (std::size_t n = 0; n < per_element_; ++n) nodes.push_back(flow.twin[at(flow.mesh.element(at(a))[n])]);
    for (std::size_t n = 0; b != a && n < per_element_; ++n)
      nodes.push_back(flow.twin[at(flow.mesh.element(at(b))[n])]);
    clusters.add(nodes);
  }
  return clusters;
}

void ImmersedBlocks::add_velocities(const Matrix& S) {
  for (Eigen::Index column = 0; column < S.outerSize(); ++column) {
    const auto d = static_cast<std::size_t>(column) / 2, j = static_cast<std::size_t>(column) % 2;
    for (Matrix::InnerIterator at(S, column); at; ++at) {
      const auto c = static_cast<std::size_t>(at.row()) / 2, i = static_cast<std::size_t>(at.row()) % 2;
      const std::size_t b = number_of(element_of(c), element_of(d)), size = size_of(pairs_[b]);
      const std::size_t rows = begin_of(element_of(c), pairs_[b]) + i, columns = begin_of(element_of(d), pairs_[b]) + j;
      const auto of_c = map_.parts(c), of_d = map_.parts(d);
      for (std::size_t m = 0; m < per_element_; ++m) {
        double* to = &blocks_[b][(rows + places * m) * size + columns];
        for (std::size_t n = 0; n < per_element_; ++n) to[places * n] += at.value() * of_c[m] * of_d[n];
      }
    }
  }
}

void ImmersedBlocks::add_pressures(const Matrix& D) {
  const auto corners = pressure_nodes(unknowns_.flow.element);
  for (Eigen::Index column = 0; column < D.outerSize(); ++column) {
    const auto d = static_cast<std::size_t>(column) / 2, j = static_cast<std::size_t>(column) % 2;
    for (Matrix::InnerIterator at(D, column); at; ++at) {
      const auto k = static_cast<std::size_t>(at.row()) / 4, corner = static_cast<std::size_t>(at.row()) % 4;
      const int of_q = pressure_->elements()[k];
      const std::size_t b = number_of(of_q, element_of(d)), size = size_of(pairs_[b]);
      const std::size_t q = begin_of(of_q, pairs_[b]) + places * static_cast<std::size_t>(corners[corner]) + 2;
      const std::size_t v = begin_of(element_of(d), pairs_[b]) + j;
      for (std::size_t n = 0; n < per_element_; ++n) {
        const double value = at.value() * map_.parts(d)[n];
        blocks_[b][q * size + v + places * n] -= value;
        blocks_[b][(v + places * n) * size + q] += value;
      }
    }
  }
  for (std::size_t k = 0; k < pressure_->elements().size(); ++k) {
    const int element = pressure_->elements()[k];
    // D has a column for each carried node, so that every element of the pressure is in some pair.
    const auto found =
        std::ranges::find_if(pairs_, [&](const Pair& p) { return p.first == element || p.second == element; });
    const std::size_t b = static_cast<std::size_t>(found - pairs_.begin()), size = size_of(*found);
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t s = 0; s < 4; ++s) {
        const std::size_t row = begin_of(element, *found) + places * static_cast<std::size_t>(corners[r]) + 2;
        const std::size_t other = begin_of(element, *found) + places * static_cast<std::size_t>(corners[s]) + 2;
        blocks_[b][row * size + other] += pressure_->extension(k)[4 * r + s];
      }
    }
  }
}

void ImmersedBlocks::add_to(std::size_t first, const ClusterPattern& pattern, SparseMatrix& K) const {
  std::vector<int> nodes, number;
  for (std::size_t b = 0; b < pairs_.size(); ++b) {
    const auto members = pattern.clusters()[first + b];
    nodes.clear(), number.clear();
    for (std::size_t m = 0; m < members.size(); ++m) {
      const auto node = at(members[m]);
      for (std::size_t i = 0; i < places; ++i) nodes.push_back(static_cast<int>(m));
      number.insert(number.end(),
                    {unknowns_.velocity[2 * node], unknowns_.velocity[2 * node + 1], unknowns_.pressure[node]});
    }
    pattern.add(first + b, nodes, number, blocks_[b], K);
  }
}

}  // namespace tether::fem
