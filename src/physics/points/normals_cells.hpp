// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "grid/boxes.hpp"
#include "grid/kernels.hpp"
#include "laws/walls.hpp"
#include "loops/points.hpp"
#include "model/method.hpp"
#include "physics/points/normals_grid.hpp"

namespace tether::mpm {

/// A place in a cell, from 0 to 1 in both directions, or near it.
struct LocalPlace {
  double r = 0, s = 0;
};

/// Colours at a cell's four nodes with the linear shape functions (7.13), nodes counter-clockwise from the lower left.
struct LinearColor {
  static constexpr std::size_t count = 4;
  using Row = std::array<double, count>;
  /// Steps from the first colour of a cell to each, along x and along y.
  static constexpr std::array<std::array<int, 2>, count> steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

  static Row weights(LocalPlace at) { return LinearShape({0, 0, at.r, at.s}).N; }
  /// Their derivatives in r and s.
  static std::array<Pair, count> slopes(LocalPlace at) {
    return LinearGradient({0, 0, at.r, at.s}, 1, 1).minus_divergence(pair(-1, 0), pair(0, -1));
  }
  /// What is zero for colours that are linear in r and s: the part r s.
  static constexpr std::array<Row, 1> bends{{{1, -1, 1, -1}}};
  static constexpr std::array<Row, 0> twists{};
};

using ThreeValues = std::array<double, 3>;
using NineValues = std::array<double, 9>;

/// Products of what stands along r with what stands along s.
constexpr NineValues nine(const ThreeValues& along_r, const ThreeValues& along_s) {
  NineValues values{};
  for (std::size_t k = 0; k < 9; ++k) values[k] = along_r[k % 3] * along_s[k / 3];
  return values;
}

/// Takes one of three colours in a row, or a difference of them.
namespace taking {
constexpr ThreeValues first{1, 0, 0}, middle{0, 1, 0}, last{0, 0, 1};
constexpr ThreeValues rise{-1, 1, 0}, next_rise{0, -1, 1}, bend{1, -2, 1};
}  // namespace taking

/// Colours at nine cells' centres with the quadratic functions (7.18), row by row from the lower left.
struct QuadraticColor {
  static constexpr std::size_t count = 9;
  using Row = NineValues;
  static constexpr std::array<std::array<int, 2>, count> steps{
      {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}};

  static Row weights(LocalPlace at) { return nine(quadratic_weights(at.r - 0.5), quadratic_weights(at.s - 0.5)); }
  static std::array<Pair, count> slopes(LocalPlace at) {
    const Row by_r = nine(quadratic_slopes(at.r - 0.5), quadratic_weights(at.s - 0.5));
    const Row by_s = nine(quadratic_weights(at.r - 0.5), quadratic_slopes(at.s - 0.5));
    std::array<Pair, count> of;
    for (std::size_t k = 0; k < count; ++k) of[k] = pair(by_r[k], by_s[k]);
    return of;
  }

  /// Second differences, zero for colours that are linear in r and s.
  static constexpr std::array<Row, 10> bends{
      nine(taking::bend, taking::first),     nine(taking::bend, taking::middle),
      nine(taking::bend, taking::last),      nine(taking::first, taking::bend),
      nine(taking::middle, taking::bend),    nine(taking::last, taking::bend),
      nine(taking::rise, taking::rise),      nine(taking::rise, taking::next_rise),
      nine(taking::next_rise, taking::rise), nine(taking::next_rise, taking::next_rise)};
  /// Third and fourth differences, zero for colours whose contours are conics.
  static constexpr std::array<Row, 5> twists{nine(taking::bend, taking::rise), nine(taking::bend, taking::next_rise),
                                             nine(taking::rise, taking::bend), nine(taking::next_rise, taking::bend),
                                             nine(taking::bend, taking::bend)};
};

/// How much a colour's departure from a linear one counts beside its error at a point: squares of bends and of twists.
struct Stiffness {
  double bend = 0, twist = 0;
};
/// Measured: arcs of 0.4 cells come out to 0.5 degrees, and a scatter of 1e-3 cells makes errors below 1 degree.
constexpr Stiffness softest{1e-8, 1e-4};

/// A colour's gradient in r and s.
template <class Color>
Pair color_gradient(const std::array<double, Color::count>& colors, LocalPlace at) {
  const auto slopes = Color::slopes(at);
  Pair sum{};
  for (std::size_t k = 0; k < Color::count; ++k) sum += colors[k] * slopes[k];  // (7.9), (7.14), (7.19)
  return sum;
}

// The mass matrix method on the points of one cell. T chi = sum_p N chi_p (7.12) are the normal equations of the least
// squares problem chi(x_p) = chi_p. Here colours are measured from the membrane's: 0 at its points, 1 at the extra one.
//
// Where the points leave T singular or nearly so (Fig. 80) many colours, or none but a saddle, have their contour
// through the points. Wanted is the one that departs least from a linear colour. So the squares of the departures are
// added with a weight that is too small to count where the points decide. A straight line has no departure and comes
// out exact. A fit whose gradient turns round or dies away between the points (a saddle through points that are not
// quite in a line) is no contour of a membrane: it is made again with stiffer colours, in the end linear ones.

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
  /// Points that stand this close to each other show no direction.
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
  constexpr double distance = 0.25;  // measured: arcs come out better than with 0.5 or 1
  const double side = distance * std::min(dx, dy);
  const auto outside = [](LocalPlace at) { return std::max(std::abs(at.r - 0.5), std::abs(at.s - 0.5)); };
  const LocalPlace up{line.middle.r + side * line.nx / dx, line.middle.s + side * line.ny / dy};
  const LocalPlace down{line.middle.r - side * line.nx / dx, line.middle.s - side * line.ny / dy};
  return outside(up) <= outside(down) ? ExtraPoint{up, distance} : ExtraPoint{down, -distance};
}

/// Returns whether all gradients go with their mean: at least half as far.
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

/// A membrane's points by cell.
class MembraneCells {
 public:
  struct Member {
    CellPlace at;
    std::size_t point;
  };
  struct Cell {
    int i, j;
    std::size_t begin, end;  // of its members
  };

  MembraneCells(const BackgroundGrid& shape, const Walls& walls, std::size_t most_points);
  void sort(const PlaceArrays& places, Range membrane);

  std::span<const Cell> cells() const { return cells_; }
  std::span<const Member> members(const Cell& cell) const {
    return std::span(members_).subspan(cell.begin, cell.end - cell.begin);
  }
  /// Null where the cell holds no point of the membrane.
  const Cell* find(int i, int j) const;
  /// Places in four cells as one (Fig. 88), the two by two that are nearest to the first point of `cell`: first its own
  /// points, then the others, and images behind a mirror.
  void ghost_places(const Cell& cell, std::vector<LocalPlace>& places) const;

 private:
  BackgroundGrid shape_;
  bool left_, right_, bottom_, top_;  // mirrors
  std::vector<Member> members_;
  std::vector<Cell> cells_;
};

/// The mass matrix method cell by cell (7.8)-(7.14), (7.18), (7.19). It sees only which points share a cell: two sheets
/// of one membrane in a cell come out as one, and two points of a curve have their chord's normal.
template <class Color>
class CellMatrixNormals {
 public:
  CellMatrixNormals(const BackgroundGrid& shape, const Walls& walls, LonePoint alone, std::size_t most_points);
  void update(const PlaceArrays& places, Range membrane, const Tangents& tangents);

 private:
  using Cell = MembraneCells::Cell;
  void fit_cell(const Cell& cell, const Tangents& tangents);
  void fit_ghost(const Cell& cell, const Tangents& tangents);

  double dx_, dy_;
  LonePoint alone_;
  MembraneCells cells_;
  std::vector<LocalPlace> places_;
  std::vector<Pair> gradients_;
};

}  // namespace tether::mpm
