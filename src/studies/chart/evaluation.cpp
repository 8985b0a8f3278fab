// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "base/numbers.hpp"

namespace tether::chart {
namespace {

/// Errors that fall by less than this hardly fall: something else than the size keeps them up.
constexpr double least_order = 0.5;

bool counts(const Point& run) { return std::isfinite(run.cost) && std::isfinite(run.error); }

/// Slope of log(error) over log(size), by least squares.
double slope(std::span<const double> size, std::span<const double> error) {
  double x = 0, y = 0, xx = 0, xy = 0, count = 0;
  for (std::size_t k = 0; k < size.size(); ++k) {
    if (!(error[k] > 0) || !std::isfinite(error[k])) continue;
    const double log_size = std::log(size[k]), log_error = std::log(error[k]);
    x += log_size, y += log_error, xx += log_size * log_size, xy += log_size * log_error, count += 1;
  }
  const double spread = count * xx - x * x;
  return spread > 0 ? (count * xy - x * y) / spread : no_number;
}

/// The number p with ((s0/s1)^p - 1)/(1 - (s2/s1)^p) = ratio, that of distances which errors as s^p have.
double order_of_distances(double s0, double s1, double s2, double ratio) {
  const auto excess = [&](double p) {
    return (std::pow(s0 / s1, p) - 1) / (1 - std::pow(s2 / s1, p)) - ratio;  // grows with p
  };
  double low = 1e-3, high = 20;
  if (!(excess(low) < 0) || !(excess(high) > 0)) return no_number;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<double> lasting(std::span<const double> error) {
  std::vector<double> all(error.begin(), error.end());
  double largest = 0;
  for (std::size_t k = all.size(); k-- > 0;) {
    if (std::isfinite(all[k])) all[k] = largest = std::max(largest, all[k]);
  }
  return all;
}

std::vector<std::size_t> front(std::span<const Point> runs) {
  std::vector<std::size_t> by_cost;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (counts(runs[k])) by_cost.push_back(k);
  }
  std::stable_sort(by_cost.begin(), by_cost.end(), [&](std::size_t a, std::size_t b) {
    return runs[a].cost != runs[b].cost ? runs[a].cost < runs[b].cost : runs[a].error < runs[b].error;
  });
  std::vector<std::size_t> best;
  for (const std::size_t k : by_cost) {
    if (best.empty() || runs[k].error < runs[best.back()].error) best.push_back(k);
  }
  return best;
}

std::optional<std::size_t> cheapest(std::span<const Point> runs, double tolerance) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!counts(runs[k]) || runs[k].error > tolerance) continue;
    if (!found || runs[k].cost < runs[*found].cost) found = k;
  }
  return found;
}

Order order_of(std::span<const double> size, std::span<const double> error, double spread) {
  const std::size_t count = size.size();
  if (count < 2) return {no_number, 0, false};
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  std::size_t first = count - 1;
  while (first > 0) {
    const double here = slope(size.subspan(first - 1, 2), error.subspan(first - 1, 2));
    if (!(here >= least_order)) break;
    least = std::min(least, here), largest = std::max(largest, here);
    if (largest - least > spread) break;
    --first;
  }
  const bool asymptotic = count - first >= 3;
  if (!asymptotic) first = 0;
  return {slope(size.subspan(first), error.subspan(first)), first, asymptotic};
}

Limit limit_of(std::span<const double> size, std::span<const double> value) {
  if (size.size() < 3 || value.size() != size.size()) throw std::invalid_argument("a limit needs three values");
  const std::size_t n = size.size();
  const double before = value[n - 2] - value[n - 3], last = value[n - 1] - value[n - 2];
  const double order = order_of_distances(size[n - 3], size[n - 2], size[n - 1], before / last);
  if (last == 0) return {value[n - 1], 0, no_number, true};
  if (std::isnan(order)) return {value[n - 1], std::max(std::abs(before), std::abs(last)), no_number, false};
  const double farther = last / (std::pow(size[n - 2] / size[n - 1], order) - 1);
  return {value[n - 1] + farther, std::abs(farther), order, true};
}

}  // namespace tether::chart
