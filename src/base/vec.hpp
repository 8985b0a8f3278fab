// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace tether {

/// A place, a velocity, a force: a component an axis.
template <int dim>
using Vec = std::array<double, std::size_t{dim}>;

/// Multiplies vectors of the plane or of space.
inline double dot(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double dot(const Vec<3>& a, const Vec<3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec<3> minus(const Vec<3>& a, const Vec<3>& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A box with sides along the axes, from its lowest to its highest coordinates [length].
template <int dim>
struct Box {
  Vec<dim> low{}, high{};

  /// Returns whether a place lies in it or, as near as rounding shows, on its edge.
  bool contains(const Vec<dim>& place) const {
    for (std::size_t i = 0; i < low.size(); ++i) {
      const double slack = rounding * (high[i] - low[i]);
      if (place[i] < low[i] - slack || place[i] > high[i] + slack) return false;
    }
    return true;
  }
  /// Returns whether the two have a place in common, be it of their edges.
  bool meets(const Box& other) const {
    for (std::size_t i = 0; i < low.size(); ++i)
      if (low[i] > other.high[i] || high[i] < other.low[i]) return false;
    return true;
  }
  /// Grows until it holds the other.
  void add(const Box& other) {
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (other.low[i] < low[i]) low[i] = other.low[i];
      if (other.high[i] > high[i]) high[i] = other.high[i];
    }
  }
  /// Grows until it holds the place.
  void add(const Vec<dim>& place) { add(Box{place, place}); }

  static constexpr double rounding = 1e-9;  // of its sides
};

}  // namespace tether
