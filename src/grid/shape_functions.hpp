// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "grid/background_grid.hpp"
#include "grid/pair.hpp"

namespace tether {

/// The four bilinear shape functions of a cell, nodes counter-clockwise from the lower left (A.3.1). The thesis prints
/// N4 = (1-s) r; with its own node order it is (1-r) s.
struct LinearShape {
  std::array<double, 4> N;
  explicit LinearShape(const CellPlace& at)
      : N{(1 - at.r) * (1 - at.s), at.r * (1 - at.s), at.r * at.s, (1 - at.r) * at.s} {}
};

/// Their derivatives in global axes [1/length] (A.3.1), kept as factors: G_1 = (-(1-s)/dx, -(1-r)/dy),
/// G_2 = ((1-s)/dx, -r/dy), G_3 = (s/dx, r/dy), G_4 = (-s/dx, (1-r)/dy). Nodes that share an edge share a factor, which
/// halves the work of the sums below. The thesis prints G4x and G4y in places with N4's misprint.
struct LinearGradient {
  double r, s, per_dx, per_dy;
  LinearGradient(const CellPlace& at, double per_dx_, double per_dy_)
      : r(at.r), s(at.s), per_dx(per_dx_), per_dy(per_dy_) {}

  /// sum_i v_i G_ix of the four nodes' v_i.
  Pair by_x(const std::array<Pair, 4>& v) const { return ((v[1] - v[0]) * (1 - s) + (v[2] - v[3]) * s) * per_dx; }
  /// sum_i v_i G_iy.
  Pair by_y(const std::array<Pair, 4>& v) const { return ((v[3] - v[0]) * (1 - r) + (v[2] - v[1]) * r) * per_dy; }

  /// -(a G_ix + b G_iy) for the four nodes: with the columns a, b of V sigma the nodal forces of a point (3.16).
  std::array<Pair, 4> minus_divergence(Pair a, Pair b) const {
    a *= per_dx, b *= per_dy;
    const Pair a0 = a * (1 - s), a1 = a * s, b0 = b * (1 - r), b1 = b * r;
    return {a0 + b0, b1 - a0, -a1 - b1, a1 - b0};
  }
};

/// Quadratic weights of the cells before, at and behind the one that holds the place, along one axis (Table 12);
/// `centred` is the logical coordinate measured from the cell's middle, -0.5 to 0.5.
inline std::array<double, 3> quadratic_weights(double centred) {
  const double before = 0.5 - centred, behind = 0.5 + centred;
  return {0.5 * before * before, 0.75 - centred * centred, 0.5 * behind * behind};
}

/// Their derivatives in the logical coordinate (Table 13); a side of the cell turns them into slopes.
inline std::array<double, 3> quadratic_slopes(double centred) { return {centred - 0.5, -2 * centred, centred + 0.5}; }

}  // namespace tether
