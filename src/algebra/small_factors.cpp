// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/small_factors.hpp"

#include <Eigen/SparseCholesky>

namespace tether {

struct SmallFactors::Factors {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> of;
};

SmallFactors::SmallFactors() : factors_(std::make_unique<Factors>()) {}

SmallFactors::SmallFactors(SmallFactors&&) noexcept = default;

SmallFactors& SmallFactors::operator=(SmallFactors&&) noexcept = default;

SmallFactors::~SmallFactors() = default;

bool SmallFactors::factorise(const Eigen::SparseMatrix<double>& A) {
  factors_->of.compute(A);
  return factors_->of.info() == Eigen::Success;
}

Eigen::MatrixXd SmallFactors::solve(const Eigen::MatrixXd& b) const { return factors_->of.solve(b); }

void SmallFactors::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { x = factors_->of.solve(b); }

}  // namespace tether
