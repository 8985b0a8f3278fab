// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "grid/pair.hpp"
#include "grid/shape_functions.hpp"

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
/// Measured: arcs of .4 cells come out to .5 degrees, and a scatter of 1e-3 cells makes errors below 1 degree.
constexpr Stiffness softest{1e-8, 1e-4};

/// A colour's gradient in r and s.
template <class Color>
Pair color_gradient(const std::array<double, Color::count>& colors, LocalPlace at) {
  const auto slopes = Color::slopes(at);
  Pair sum{};
  for (std::size_t k = 0; k < Color::count; ++k) sum += colors[k] * slopes[k];  // (7.9), (7.14), (7.19)
  return sum;
}

}  // namespace tether::mpm
