// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_products.hpp"

namespace tether {
EigenSparse congruent(const EigenSparse& S, const EigenSparse& E) { return E.transpose() * EigenSparse(S * E); }

EigenSparse weighted_square(const EigenRows& B, std::span<const double> D) {
  const Eigen::Map<const Eigen::VectorXd> weights(D.data(), static_cast<Eigen::Index>(D.size()));
  return B * weights.asDiagonal() * B.transpose();
}

}  // namespace tether
