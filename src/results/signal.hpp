// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace tether {

// Readings off a sampled history. A reading that the samples do not show is NaN.

/// Mean of the smallest and the largest value.
double middle(const std::vector<double>& values);

/// Times at which the values pass through the level, placed by linear interpolation.
std::vector<double> passages(const std::vector<double>& time, const std::vector<double>& values, double level);

/// Twice the mean time between passages through the level.
double period_about(const std::vector<double>& time, const std::vector<double>& values, double level);

struct Reading {
  double time = 0, value = 0;
};

/// The lowest sample before the values climb half of the way back, refined by a parabola through its neighbours.
Reading first_minimum(const std::vector<double>& time, const std::vector<double>& values);
/// The highest sample after `after` before the values fall half of the way back, refined likewise.
Reading first_maximum_after(const std::vector<double>& time, const std::vector<double>& values, double after);

}  // namespace tether
