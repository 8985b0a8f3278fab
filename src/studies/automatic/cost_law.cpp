// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/cost_law.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tether::automatic {
namespace {

/// How much the expected powers count, in runs that differ by a factor e.
constexpr double trust = 0.02;

/// Below them a run that is finer would seem to cost nothing more: small runs cost what they cost to start.
constexpr double least_power_of_space = 0.3, least_power_of_time = 0.05;

}  // namespace

CostLaw::CostLaw(std::span<const Expense> runs, const Resolution& expected) {
  if (runs.empty()) throw std::invalid_argument("a law of the cost of no runs");
  Eigen::Matrix3d A = Eigen::Vector3d(1e-6, trust, trust).asDiagonal();
  Eigen::Vector3d b = Eigen::Vector3d(0, trust * expected.space, trust * expected.time);
  double most = least_seconds;
  for (const Expense& run : runs) most = std::max(most, run.seconds);
  for (const Expense& run : runs) {
    const Eigen::Vector3d x(1, std::log(run.at.space), std::log(run.at.time));
    const double seconds = std::max(run.seconds, least_seconds), weight = std::sqrt(seconds / most);
    A += weight * x * x.transpose();
    b += weight * x * std::log(seconds);
  }
  const Eigen::Vector3d law = A.ldlt().solve(b);
  log_one_ = law[0];
  powers_.space = std::max(law[1], std::min(expected.space, least_power_of_space));
  powers_.time = std::max(law[2], std::min(expected.time, least_power_of_time));
}

double CostLaw::seconds(const Resolution& at) const {
  return std::exp(log_one_ + powers_.space * std::log(at.space) + powers_.time * std::log(at.time));
}

}  // namespace tether::automatic
