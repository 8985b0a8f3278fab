// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "physics/box/mesh/flow_mesh.hpp"

namespace tether::coupled {

/// A number of the nodes of a face.
struct FaceValue {
  std::size_t face;
  double value;
};

/// A number in each cell, with the gradient that the means about the cell's nodes have.
class CellField {
 public:
  /// Both must outlive it. The nodes of faces that are `known`, as where something comes in, have the means of these.
  CellField(const FlowMesh& mesh, std::span<const double> values, std::span<const FaceValue> known = {});

  double value(std::size_t cell) const { return values_[cell]; }
  /// At a place in a cell.
  double at_place(std::size_t cell, const Vec<3>& x) const {
    const Vec<3> from = minus(x, mesh_.middle(cell));
    return values_[cell] + dot(slope_[cell], from);
  }
  /// Returns the same, within the extrema of the cell and of the means about its nodes.
  double limited_at(std::size_t cell, const Vec<3>& x) const {
    const auto [low, high] = extrema(cell);
    return std::clamp(at_place(cell, x), low, high);
  }
  /// Between the means about a cell's nodes, by a place's shares.
  double between_means(std::size_t cell, const std::array<double, 4>& shares) const {
    double value = 0;
    const auto nodes = mesh_.nodes_of(cell);
    for (std::size_t k = 0; k < nodes.size(); ++k) value += shares[k] * mean_[at(nodes[k])];
    return value;
  }
  std::array<double, 2> extrema(std::size_t cell) const;

 private:
  const FlowMesh& mesh_;
  std::span<const double> values_;
  std::vector<double> mean_;   // about each node
  std::vector<Vec<3>> slope_;  // of each cell, by length
};

}  // namespace tether::coupled
