// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sparse_products.hpp"

namespace tether {
namespace {

SparseMatrix plain(const EigenSparse& A) {
  SparseMatrix out;
  out.n = A.cols();
  out.start.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1);
  out.row.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
  out.value.assign(A.valuePtr(), A.valuePtr() + A.nonZeros());
  return out;
}

}  // namespace

EigenSparse congruent(const EigenSparse& S, const EigenSparse& E) { return E.transpose() * EigenSparse(S * E); }

SparseMatrix plus_weighted_square(const SparseMatrix& L, const EigenRows& B, std::span<const double> D) {
  const Eigen::Map<const Eigen::VectorXd> weights(D.data(), static_cast<Eigen::Index>(D.size()));
  return plain(eigen_of(L) + EigenSparse(B * weights.asDiagonal() * B.transpose()));
}

}  // namespace tether
