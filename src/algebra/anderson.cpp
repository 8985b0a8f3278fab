// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/anderson.hpp"

namespace tether {

/// Of the changes in df those shares s whose sum is nearest to the residual: |df s - residual|^2 is least with
/// sum (bent |df_k| s_k)^2 added.
Eigen::VectorXd AndersonMixing::shares_of(const Eigen::VectorXd& residual, Eigen::Index columns) const {
  Eigen::MatrixXd changes(residual.size() + columns, columns);
  changes << df_.leftCols(columns), Eigen::MatrixXd((bent_ * df_.leftCols(columns).colwise().norm()).asDiagonal());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(changes.rows());
  right.head(residual.size()) = residual;
  return changes.colPivHouseholderQr().solve(right);
}

void AndersonMixing::next(std::span<const double> f, std::span<double> x) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(x.data(), n),
                        weight = Eigen::Map<const Eigen::VectorXd>(weight_.data(), n),
                        residual = weight.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(f.data(), n));
  Eigen::VectorXd step = Eigen::Map<const Eigen::VectorXd>(f.data(), n);
  if (count_ == 0) dx_.resize(n, kept_), df_.resize(n, kept_);
  if (count_ > 0) {
    const Eigen::Index column = (count_ - 1) % kept_, columns = std::min(count_, kept_);
    dx_.col(column) = at - last_x_;
    df_.col(column) = residual - last_f_;
    const Eigen::VectorXd shares = shares_of(residual, columns);
    step -= dx_.leftCols(columns) * shares;
    for (Eigen::Index k = 0; k < n; ++k) {
      if (weight[k] > 0) step[k] -= df_.leftCols(columns).row(k).dot(shares) / weight[k];
    }
  }
  last_x_ = at, last_f_ = residual, ++count_;
  Eigen::Map<Eigen::VectorXd>(x.data(), n) += step;
}

}  // namespace tether
