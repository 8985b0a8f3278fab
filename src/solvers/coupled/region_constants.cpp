// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/coupled/region_constants.hpp"

#include <Eigen/Cholesky>

#include "algebra/gmres.hpp"
#include "base/index.hpp"

namespace tether::coupled {

ConstantPressures::ConstantPressures(const CoupledEquations& equations) {
  std::vector<int> number;
  int count = 0;
  for (std::size_t r = 0; r < equations.closed.size(); ++r)
    number.push_back(equations.closed[r] != 0 && equations.loose[r] == 0 ? count++ : -1);
  for (const int region : equations.region) of_.push_back(number[at(region)]);
  cells_.assign(at(count), 0.0);
  add_sums(std::vector<double>(of_.size(), 1.0), cells_);
}

void ConstantPressures::add_sums(std::span<const double> x, std::span<double> sums) const {
  for (std::size_t k = 0; k < of_.size(); ++k) {
    if (of_[k] >= 0) sums[at(of_[k])] += x[k];
  }
}

void ConstantPressures::add(std::span<const double> c, std::span<double> p) const {
  for (std::size_t k = 0; k < of_.size(); ++k) {
    if (of_[k] >= 0) p[k] += c[at(of_[k])];
  }
}

std::vector<double> ConstantPressures::take_means(std::span<double> p) const {
  std::vector<double> means(count(), 0.0), back;
  add_sums(p, means);
  for (std::size_t c = 0; c < means.size(); ++c) means[c] /= cells_[c], back.push_back(-means[c]);
  add(back, p);
  return means;
}

RegionConstants::RegionConstants(const CoupledEquations& equations, const ReducedEquations& with)
    : constants_(equations),
      border_(constants_.count(), std::vector<double>(with.b.size() + equations.cells, 0.0)),
      right_(constants_.count(), 0.0) {
  constants_.add_sums(with.r, right_);
  for (std::size_t p = 0; p < with.r.size(); ++p) {
    if (constants_.of(p) < 0) continue;
    auto& border = border_[at(constants_.of(p))];
    for (CouplingMatrix::InnerIterator entry(equations.B, static_cast<std::int64_t>(p)); entry; ++entry) {
      const auto column = static_cast<std::size_t>(entry.col());
      if (equations.held[column] == 0) border[column] -= entry.value();
    }
  }
}

std::vector<double> RegionConstants::found(QuasidefiniteSolver& factors, std::span<double> x) const {
  const auto count = static_cast<Eigen::Index>(border_.size());
  if (count == 0) return {};
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
  return {c.begin(), c.end()};
}

}  // namespace tether::coupled
