// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "grid/boxes.hpp"

namespace tether {

/// Cubic B-spline weights, along one axis, of the two nodes before a place and the two after it; r is the place's
/// logical coordinate in its cell, 0 to 1. The products of two axes are the 16-vertex kernel of (7.6).
inline std::array<double, 4> cubic_weights(double r) {
  const double q = 1 - r;
  return {q * q * q / 6, (4 - 3 * r * r * (1 + q)) / 6, (4 - 3 * q * q * (1 + r)) / 6, r * r * r / 6};
}

/// Their derivatives in r (7.7).
inline std::array<double, 4> cubic_slopes(double r) {
  const double q = 1 - r;
  return {-0.5 * q * q, r * (1.5 * r - 2), q * (2 - 1.5 * q), 0.5 * r * r};
}

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

/// Quadratic weights of the cells before, at and after the one that holds the place, along one axis (Table 12);
/// `centred` is the logical coordinate measured from the cell's middle, -0.5 to 0.5.
inline std::array<double, 3> quadratic_weights(double centred) {
  const double before = 0.5 - centred, after = 0.5 + centred;
  return {0.5 * before * before, 0.75 - centred * centred, 0.5 * after * after};
}

/// Their derivatives in the logical coordinate (Table 13); a side of the cell turns them into slopes.
inline std::array<double, 3> quadratic_slopes(double centred) { return {centred - 0.5, -2 * centred, centred + 0.5}; }

// Shape functions between points and nodes, as loops over the nodes that a place touches. A kernel is chosen once and
// is a template argument of every pass: node numbers, values N, gradients G, and the linear field about a point.

/// v and its first-order field about a point: v(x_i) = v + by_x (x_i - x_p) + by_y (y_i - y_p).
struct LinearField {
  Pair v{}, by_x{}, by_y{};
};

/// Bilinear functions of a cell's four nodes, counter-clockwise from the lower left (A.3.1).
struct LinearKernel {
  static constexpr std::size_t size = 4;
  static constexpr int first = 0, last = 1;  // nodes along an axis, from the cell's own
  using Nodes = std::array<std::size_t, size>;
  using Values = std::array<double, size>;
  using Place = CellPlace;

  [[gnu::always_inline]] static Place locate(const Locator& locator, double x, double y) {
    return locator.locate(x, y);
  }
  static Nodes nodes(const Locator& locator, const Place& at) {
    const std::size_t n = locator.lower_left_node(at), nx = static_cast<std::size_t>(locator.nx);
    return {n, n + 1, n + nx + 1, n + nx};
  }
  static Values values(const Place& at) { return LinearShape(at).N; }

  /// sum_i v_i N_i.
  template <class Velocity>
  static Pair value(const Place& at, const Nodes& nodes, const Velocity& v) {
    const LinearShape shape(at);
    Pair sum{};
    for (std::size_t k = 0; k < size; ++k) sum += shape.N[k] * v(nodes[k]);
    return sum;
  }
  /// sum_i v_i (x) G_ip.
  template <class Velocity>
  static LinearField gradient(const Locator& locator, const Place& at, const Nodes& nodes, const Velocity& v) {
    const LinearGradient G(at, locator.per_dx, locator.per_dy);
    const std::array<Pair, size> of{v(nodes[0]), v(nodes[1]), v(nodes[2]), v(nodes[3])};
    return {pair(0, 0), G.by_x(of), G.by_y(of)};
  }
  /// The field that APIC keeps at a point. For multilinear functions it is value and gradient.
  template <class Velocity>
  static LinearField affine(const Locator& locator, const Place& at, const Nodes& nodes, const Velocity& v) {
    LinearField field = gradient(locator, at, nodes, v);
    field.v = value(at, nodes, v);
    return field;
  }
  /// -(a G_ix + b G_iy) added to each node, a and b the columns of V sigma (3.16).
  template <class Add>
  [[gnu::always_inline]] static void minus_divergence(const Locator& locator, const Place& at, const Nodes& nodes,
                                                      Pair a, Pair b, const Add& add) {
    const auto forces = LinearGradient(at, locator.per_dx, locator.per_dy).minus_divergence(a, b);
    for (std::size_t k = 0; k < size; ++k) add(nodes[k], forces[k]);
  }
  /// N_i and the field's value at the node, for each node.
  template <class Add>
  static void spread(const Locator& locator, const Place& at, const Nodes& nodes, const LinearField& field,
                     const Add& add) {
    const LinearShape shape(at);
    const Pair left = field.by_x * (-at.r / locator.per_dx), right = field.by_x * ((1 - at.r) / locator.per_dx);
    const Pair low = field.v + field.by_y * (-at.s / locator.per_dy);
    const Pair high = field.v + field.by_y * ((1 - at.s) / locator.per_dy);
    const std::array<Pair, size> v{low + left, low + right, high + right, high + left};
    for (std::size_t k = 0; k < size; ++k) add(nodes[k], shape.N[k], v[k]);
  }
};

/// Quadratic B-splines at the nodes: the nine nodes around the nearest one (Table 12, centred at nodes). The place's
/// logical coordinates run from -0.5 to 0.5 about the nearest node.
struct SplineKernel {
  static constexpr std::size_t size = 9;
  static constexpr int first = -1, last = 1;  // nodes along an axis, from the nearest one
  using Nodes = std::array<std::size_t, size>;
  using Values = std::array<double, size>;
  struct Place {
    int i = 0, j = 0;
    double r = 0, s = 0;
  };

  [[gnu::always_inline]] static Place locate(const Locator& locator, double x, double y) {
    const double a = (x - locator.x0) * locator.per_dx, b = (y - locator.y0) * locator.per_dy;
    // the nearest node; a place on the grid is at least 0
    const int i = static_cast<int>(a + 0.5), j = static_cast<int>(b + 0.5);  // NOLINT(bugprone-incorrect-roundings)
    return {i, j, a - i, b - j};
  }
  static Nodes nodes(const Locator& locator, const Place& at) {
    const auto nx = static_cast<std::size_t>(locator.nx);
    const std::size_t n = (static_cast<std::size_t>(at.j) - 1) * nx + static_cast<std::size_t>(at.i) - 1;
    const std::size_t m = n + nx, o = m + nx;
    return {n, n + 1, n + 2, m, m + 1, m + 2, o, o + 1, o + 2};
  }
  static Values values(const Place& at) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    return {wx[0] * wy[0], wx[1] * wy[0], wx[2] * wy[0], wx[0] * wy[1], wx[1] * wy[1],
            wx[2] * wy[1], wx[0] * wy[2], wx[1] * wy[2], wx[2] * wy[2]};
  }
  /// Derivatives of the three weights along an axis [1/length].
  static std::array<double, 3> slopes(double r, double per_h) {
    return {(r - 0.5) * per_h, -2 * r * per_h, (r + 0.5) * per_h};
  }

  template <class Velocity>
  static Pair value(const Place& at, const Nodes& nodes, const Velocity& v) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    Pair sum{};
    for (std::size_t j = 0; j < 3; ++j) sum += wy[j] * row(wx, v, nodes, j);
    return sum;
  }
  template <class Velocity>
  static LinearField gradient(const Locator& locator, const Place& at, const Nodes& nodes, const Velocity& v) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    const auto gx = slopes(at.r, locator.per_dx), gy = slopes(at.s, locator.per_dy);
    LinearField field;
    for (std::size_t j = 0; j < 3; ++j) {
      field.by_x += wy[j] * row(gx, v, nodes, j);
      field.by_y += gy[j] * row(wx, v, nodes, j);
    }
    return field;
  }
  /// C = 4/h^2 sum N_i v_i (x_i - x_p).
  template <class Velocity>
  static LinearField affine(const Locator& locator, const Place& at, const Nodes& nodes, const Velocity& v) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    const auto mx = moments(wx, at.r, locator.per_dx);
    LinearField field;
    for (std::size_t j = 0; j < 3; ++j) {
      const Pair mean = wy[j] * row(wx, v, nodes, j);
      field.v += mean;
      field.by_x += wy[j] * row(mx, v, nodes, j);
      field.by_y += (4 * locator.per_dy * (static_cast<double>(j) - 1 - at.s)) * mean;
    }
    return field;
  }
  template <class Add>
  static void minus_divergence(const Locator& locator, const Place& at, const Nodes& nodes, Pair a, Pair b,
                               const Add& add) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    const auto gx = slopes(at.r, locator.per_dx), gy = slopes(at.s, locator.per_dy);
    for (std::size_t j = 0; j < 3; ++j) {
      const Pair aj = -wy[j] * a, bj = -gy[j] * b;
      for (std::size_t i = 0; i < 3; ++i) add(nodes[3 * j + i], gx[i] * aj + wx[i] * bj);
    }
  }
  template <class Add>
  static void spread(const Locator& locator, const Place& at, const Nodes& nodes, const LinearField& field,
                     const Add& add) {
    const auto wx = quadratic_weights(at.r), wy = quadratic_weights(at.s);
    const Pair step = field.by_x * (1 / locator.per_dx), first = field.v - (1 + at.r) * step;
    for (std::size_t j = 0; j < 3; ++j) {
      const Pair v = first + ((static_cast<double>(j) - 1 - at.s) / locator.per_dy) * field.by_y;
      add(nodes[3 * j], wx[0] * wy[j], v);
      add(nodes[3 * j + 1], wx[1] * wy[j], v + step);
      add(nodes[3 * j + 2], wx[2] * wy[j], v + step + step);
    }
  }

 private:
  template <class Velocity>
  static Pair row(const std::array<double, 3>& w, const Velocity& v, const Nodes& nodes, std::size_t j) {
    return w[0] * v(nodes[3 * j]) + w[1] * v(nodes[3 * j + 1]) + w[2] * v(nodes[3 * j + 2]);
  }
  /// 4/h^2 N_i (x_i - x_p) along an axis [1/length].
  static std::array<double, 3> moments(const std::array<double, 3>& w, double r, double per_h) {
    return {-4 * per_h * (1 + r) * w[0], -4 * per_h * r * w[1], 4 * per_h * (1 - r) * w[2]};
  }
};

}  // namespace tether
