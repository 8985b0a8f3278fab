// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tether::chart {

// What a chart says of its runs, from their numbers alone. Errors, costs and sizes are positive; what is not a number
// belongs to a run that failed, and counts nowhere.

/// A run as a chart sees it.
struct Point {
  double cost = 0;   ///< [s] of the processor, or [MB]
  double error = 0;  ///< over the answer
};

/// Returns for each run, the coarsest first, the largest error from it on: one that finer runs do not keep was chance.
std::vector<double> lasting(std::span<const double> error);

/// The runs that no other one beats: none is as cheap and as accurate and better in one of the two. By ascending cost.
std::vector<std::size_t> front(std::span<const Point> runs);

/// The cheapest run whose error is at most `tolerance`; of equal ones the first. None where there is none.
std::optional<std::size_t> cheapest(std::span<const Point> runs, double tolerance);

/// How errors fall with the size of a cell, or of a step.
struct Order {
  double order = 0;       ///< of the error as a power of the size, by least squares over the range
  std::size_t first = 0;  ///< the coarsest run of the range; it ends with the finest
  bool asymptotic = false;
};

/// The order over the finest runs: as many of them, three at least, as have orders from run to run of 0.5 or more that
/// differ by at most `spread`. Where there are none, errors do not fall as a power of the size, and the order is that
/// of all runs. `size` descends. An order is not a number of fewer than two runs.
Order order_of(std::span<const double> size, std::span<const double> error, double spread = 0.5);

/// What values at sizes that fall by a constant ratio lead to.
struct Limit {
  double value = 0;
  double bound = 0;       ///< of what it may be off: its distance from the finest value
  double order = 0;       ///< with which the values come near it
  bool converges = true;  ///< whether each value's distance from the one before falls
};

/// Richardson's extrapolation of the three finest values; `size` descends. Throws std::invalid_argument for fewer.
Limit limit_of(std::span<const double> size, std::span<const double> value);

}  // namespace tether::chart
