// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/numbers.hpp"
#include "grid/shapes.hpp"

namespace tether {

/// The derivatives of a side's map from its reference side, a column a direction of it.
template <class Side>
using Tangents = Eigen::Matrix<double, Side::dim + 1, Side::dim>;

/// Those where its nodes are at q, where their functions have the gradients G.
template <class Side>
Tangents<Side> tangents_at(const int* nodes, std::span<const double> q, const Values<Side::nodes * Side::dim>& G) {
  constexpr int dim = Side::dim + 1;
  Tangents<Side> t = Tangents<Side>::Zero();
  for (int a = 0; a < Side::nodes; ++a) {
    const Eigen::Map<const Eigen::Matrix<double, dim, 1>> x(&q[static_cast<std::size_t>(nodes[a]) * dim]);
    for (int i = 0; i < Side::dim; ++i) t.col(i) += x * G[at(a * Side::dim + i)];
  }
  return t;
}

}  // namespace tether
