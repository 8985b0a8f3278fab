// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/signal.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace tether {
namespace {

/// Vertex of the parabola through samples k - 1, k, k + 1.
Reading refined(const std::vector<double>& t, const std::vector<double>& v, std::size_t k) {
  if (k == 0 || k + 1 >= v.size()) return {t[k], v[k]};
  const double left = (v[k] - v[k - 1]) / (t[k] - t[k - 1]), right = (v[k + 1] - v[k]) / (t[k + 1] - t[k]);
  const double curve = (right - left) / (t[k + 1] - t[k - 1]);
  if (curve == 0) return {t[k], v[k]};
  const double slope = left + curve * (t[k] - t[k - 1]);
  const double shift = -0.5 * slope / curve;
  return {t[k] + shift, v[k] + 0.5 * slope * shift};
}

}  // namespace

double middle(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return 0.5 * (*low + *high);
}

std::vector<double> passages(const std::vector<double>& time, const std::vector<double>& values, double level) {
  std::vector<double> times;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double a = values[k - 1] - level, b = values[k] - level;
    if ((a > 0) != (b > 0)) times.push_back(time[k - 1] + (time[k] - time[k - 1]) * a / (a - b));
  }
  return times;
}

double period_about(const std::vector<double>& time, const std::vector<double>& values, double level) {
  const auto times = passages(time, values, level);
  if (times.size() < 2) return no_number;
  return 2 * (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

Reading first_minimum(const std::vector<double>& time, const std::vector<double>& values) {
  std::size_t lowest = 0;
  bool climbed = false;
  for (std::size_t k = 1; k < values.size() && !climbed; ++k) {
    if (values[k] < values[lowest]) lowest = k;
    climbed = values[k] - values[lowest] > 0.5 * (values.front() - values[lowest]);
  }
  return climbed ? refined(time, values, lowest) : Reading{no_number, no_number};
}

Reading first_maximum_after(const std::vector<double>& time, const std::vector<double>& values, double after) {
  const auto start = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), after) - time.begin());
  if (std::isnan(after) || start >= values.size()) return {no_number, no_number};
  std::size_t highest = start;
  bool fell = false;
  for (std::size_t k = start; k < values.size() && !fell; ++k) {
    if (values[k] > values[highest]) highest = k;
    fell = highest > start && values[highest] - values[k] > 0.5 * (values[highest] - values[start]);
  }
  return fell ? refined(time, values, highest) : Reading{no_number, no_number};
}

}  // namespace tether
