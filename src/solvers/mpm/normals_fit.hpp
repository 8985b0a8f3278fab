// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "solvers/mpm/normals_colors.hpp"

// The mass matrix method on the points of one cell. T chi = sum_p N chi_p (7.12) are the normal equations of the least
// squares problem chi(x_p) = chi_p. Here colours are measured from the membrane's: 0 at its points, 1 at the extra one.
//
// Where the points leave T singular or nearly so (Fig. 80) many colours, or none but a saddle, have their contour
// through the points. Wanted is the one that departs least from a linear colour. So the squares of the departures are
// added with a weight that is too small to count where the points decide. A straight line has no departure and comes
// out exact. A fit whose gradient turns round or dies away between the points (a saddle through points that are not
// quite in a line) is no contour of a membrane: it is made again with stiffer colours, in the end linear ones.

namespace tether::mpm {

/// Stiffness grows by this factor from fit to fit; after so many the colour is linear.
constexpr double stiffer = 100;
constexpr int most_rounds = 5;

/// Least squares by rows, which Givens rotations work into a triangle as they come: as T, but with the square root of
/// its condition number, and without keeping the rows.
template <std::size_t n>
class LeastSquares {
 public:
  void add(std::array<double, n> row, double value, double weight = 1) {
    for (double& a : row) a *= weight;
    value *= weight;
    for (std::size_t k = 0; k < n; ++k) {
      if (row[k] != 0) rotate(k, row, value);
    }
  }
  /// The rows must determine all unknowns.
  std::array<double, n> solution() const {
    std::array<double, n> x = values_;
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) x[k] -= triangle_[k][j] * x[j];
      x[k] /= triangle_[k][k];
    }
    return x;
  }

 private:
  void rotate(std::size_t k, std::array<double, n>& row, double& value) {
    const double length = std::hypot(triangle_[k][k], row[k]), c = triangle_[k][k] / length, s = row[k] / length;
    for (std::size_t j = k; j < n; ++j) {
      const double upper = triangle_[k][j], lower = row[j];
      triangle_[k][j] = c * upper + s * lower, row[j] = c * lower - s * upper;
    }
    const double upper = values_[k];
    values_[k] = c * upper + s * value, value = c * value - s * upper;
  }

  std::array<std::array<double, n>, n> triangle_{};
  std::array<double, n> values_{};
};

/// The straight line nearest to some points: their middle, the unit normal and how far they spread along the line, the
/// largest mean square distance over the square of a cell's shorter side.
struct NearestLine {
  LocalPlace middle;
  double nx = 0, ny = 0;
  double spread = 0;
  /// Points that stand this close to each other tell no direction.
  bool one_place() const { return spread < 1e-4; }
};

inline NearestLine nearest_line(std::span<const LocalPlace> places, double dx, double dy) {
  NearestLine line;
  const double share = 1.0 / static_cast<double>(places.size());
  for (const LocalPlace& at : places) line.middle.r += share * at.r, line.middle.s += share * at.s;
  double xx = 0, xy = 0, yy = 0;
  for (const LocalPlace& at : places) {
    const double x = dx * (at.r - line.middle.r), y = dy * (at.s - line.middle.s);
    xx += share * x * x, xy += share * x * y, yy += share * y * y;
  }
  const double half = 0.5 * (xx - yy), radius = std::sqrt(half * half + xy * xy);
  line.spread = (0.5 * (xx + yy) + radius) / std::pow(std::min(dx, dy), 2);
  // Along the line: the eigenvector of the larger eigenvalue, from whichever row does not cancel.
  const double tx = half > 0 ? radius + half : xy, ty = half > 0 ? xy : radius - half;
  const double length = std::sqrt(tx * tx + ty * ty);
  if (length > 0) line.nx = -ty / length, line.ny = tx / length;
  if (!(length > 0)) line.ny = 1;  // no direction is better than another
  return line;
}

/// Where the point of another colour stands (7.8): off the nearest line, on the side that lies deeper in the cell. At
/// such a place a linear colour's contour is the nearest line itself; from the cell's middle or a corner it would be
/// turned, and wherever the place is on the membrane there would be no gradient at all.
struct ExtraPoint {
  LocalPlace at;
  double height = 0;  // above the line along its normal, in parts of a cell's shorter side
};

inline ExtraPoint extra_point(const NearestLine& line, double dx, double dy) {
  constexpr double distance = 0.25;  // measured: arcs come out better than with .5 or 1
  const double side = distance * std::min(dx, dy);
  const auto outside = [](LocalPlace at) { return std::max(std::abs(at.r - 0.5), std::abs(at.s - 0.5)); };
  const LocalPlace up{line.middle.r + side * line.nx / dx, line.middle.s + side * line.ny / dy};
  const LocalPlace down{line.middle.r - side * line.nx / dx, line.middle.s - side * line.ny / dy};
  return outside(up) <= outside(down) ? ExtraPoint{up, distance} : ExtraPoint{down, -distance};
}

/// Whether all gradients go with their mean: at least half as far.
inline bool go_together(std::span<const Pair> gradients) {
  Pair mean{};
  for (const Pair& g : gradients) mean += g;
  mean /= static_cast<double>(gradients.size());
  const double least = 0.5 * (mean[0] * mean[0] + mean[1] * mean[1]);
  return std::all_of(gradients.begin(), gradients.end(),
                     [&](const Pair& g) { return g[0] * mean[0] + g[1] * mean[1] > least; });
}

template <class Color>
std::array<double, Color::count> stiffened(LeastSquares<Color::count> rows, const Stiffness& stiffness) {
  for (const auto& bend : Color::bends) rows.add(bend, 0, std::sqrt(stiffness.bend));
  for (const auto& twist : Color::twists) rows.add(twist, 0, std::sqrt(stiffness.twist));
  return rows.solution();
}

/// Gradients in r and s at the points of one cell, of which not all stand on one spot.
template <class Color>
void fit_gradients(std::span<const LocalPlace> places, LocalPlace extra, std::span<Pair> gradients) {
  LeastSquares<Color::count> rows;
  for (const LocalPlace& at : places) rows.add(Color::weights(at), 0);  // (7.10), (7.18)
  rows.add(Color::weights(extra), 1);
  double factor = 1;
  for (int round = 0; round <= most_rounds; ++round, factor *= stiffer) {
    const auto colors = stiffened<Color>(rows, {factor * softest.bend, factor * softest.twist});
    for (std::size_t k = 0; k < places.size(); ++k) gradients[k] = color_gradient<Color>(colors, places[k]);
    if (go_together(gradients)) return;
  }
}

}  // namespace tether::mpm
