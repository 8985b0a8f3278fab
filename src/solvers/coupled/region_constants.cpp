// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/region_constants.hpp"

#include <Eigen/Cholesky>

#include "algebra/gmres.hpp"

namespace tether::coupled {

RegionConstants::RegionConstants(const CoupledEquations& equations, const ReducedEquations& with) {
  int count = 0;
  for (std::size_t r = 0; r < equations.closed.size(); ++r)
    number_.push_back(equations.closed[r] != 0 && equations.loose[r] == 0 ? count++ : -1);
  border_.assign(static_cast<std::size_t>(count), std::vector<double>(with.b.size() + equations.cells, 0.0));
  right_.assign(static_cast<std::size_t>(count), 0.0);
  for (std::size_t p = 0; p < with.r.size(); ++p) {
    const int number = number_[static_cast<std::size_t>(equations.region[p])];
    if (number < 0) continue;
    const auto c = static_cast<std::size_t>(number);
    right_[c] += with.r[p];
    for (CouplingMatrix::InnerIterator entry(equations.B, static_cast<std::int64_t>(p)); entry; ++entry) {
      const auto column = static_cast<std::size_t>(entry.col());
      if (equations.held[column] == 0) border_[c][column] -= entry.value();
    }
  }
}

std::vector<double> RegionConstants::found(QuasidefiniteSolver& factors, std::span<double> x) const {
  std::vector<double> constants(number_.size(), 0.0);
  const auto count = static_cast<Eigen::Index>(border_.size());
  if (count == 0) return constants;
  std::vector<std::vector<double>> solved(border_);
  for (auto& column : solved) factors.solve(column, column);
  Eigen::MatrixXd schur(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& border = border_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j) schur(i, j) = tether::dot(border, solved[static_cast<std::size_t>(j)]);
    right[i] = tether::dot(border, x) - right_[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd c = schur.ldlt().solve(right);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& column = solved[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < column.size(); ++k) x[k] -= column[k] * c[i];
  }
  for (std::size_t r = 0; r < constants.size(); ++r) {
    if (number_[r] >= 0) constants[r] = c[number_[r]];
  }
  return constants;
}

}  // namespace tether::coupled
