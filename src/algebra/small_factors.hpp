// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace tether {

/// L D L^T of a small sparse symmetric matrix, by Eigen, with an order of elimination of its own: for systems of which
/// CHOLMOD's analysis would cost more than the factors. Compiled once, since it costs the compiler seconds.
class SmallFactors {
 public:
  SmallFactors();
  SmallFactors(SmallFactors&&) noexcept;
  SmallFactors& operator=(SmallFactors&&) noexcept;
  ~SmallFactors();

  /// Returns false where a pivot is 0.
  bool factorise(const Eigen::SparseMatrix<double>& A);
  /// x of A x = b, a column each.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  /// Sets an x of its size to that of one column.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace tether
