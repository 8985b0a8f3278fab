// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/mixed_rounds.hpp"

#include <Eigen/QR>

namespace tether::fem {

std::vector<double> MixedRounds::next(std::span<const double> q0, std::span<const double> q1) {
  constexpr std::size_t most = 6;
  using Map = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(q1.size());
  ends_.emplace_back(Map(q1.data(), size));
  ways_.emplace_back(ends_.back() - Map(q0.data(), size));
  if (ends_.size() > most) ends_.pop_front(), ways_.pop_front();
  Eigen::VectorXd mixed = ends_.back();
  const auto before = static_cast<Eigen::Index>(ends_.size()) - 1;
  if (before > 0) {
    Eigen::MatrixXd of_ways(size, before), of_ends(size, before);
    for (Eigen::Index k = 0; k < before; ++k) {
      const auto n = static_cast<std::size_t>(k);
      of_ways.col(k) = ways_[n + 1] - ways_[n], of_ends.col(k) = ends_[n + 1] - ends_[n];
    }
    mixed -= of_ends * of_ways.colPivHouseholderQr().solve(ways_.back());
  }
  return {mixed.begin(), mixed.end()};
}

}  // namespace tether::fem
