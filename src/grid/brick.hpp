// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/numbers.hpp"
#include "base/vec.hpp"

namespace tether {

/// A number a node, or a number a point of quadrature.
template <int count>
using Values = std::array<double, std::size_t{count}>;

/// One-dimensional Lagrange functions of order p over -1 .. 1, nodes from left to right.
template <int p>
struct Line {
  static constexpr int nodes = p + 1;
  static Values<nodes> values(double s) {
    if constexpr (p == 1) {
      return {0.5 * (1 - s), 0.5 * (1 + s)};
    } else {
      return {0.5 * s * (s - 1), 1 - s * s, 0.5 * s * (s + 1)};
    }
  }
  static Values<nodes> slopes(double s) {
    if constexpr (p == 1) {
      return {-0.5, 0.5};
    } else {
      return {s - 0.5, -2 * s, s + 0.5};
    }
  }
  /// Gauss points p + 1: exact to order 2 p + 1, which is what a mass matrix of these functions needs.
  static Values<nodes> gauss_places() {
    if constexpr (p == 1) {
      const double s = 1 / std::sqrt(3.0);
      return {-s, s};
    } else {
      const double s = std::sqrt(0.6);
      return {-s, 0, s};
    }
  }
  static Values<nodes> gauss_weights() {
    if constexpr (p == 1) {
      return {1, 1};
    } else {
      return {5.0 / 9, 8.0 / 9, 5.0 / 9};
    }
  }
};

/// Returns what point k of the rule adds at s to the polynomial of order q <= p that is nearest to the values at all
/// points, in the mean over the line: by Legendre's polynomials, which the rule's p + 1 points integrate exactly.
template <int p>
double nearest_polynomial(int q, int k, double s) {
  const double at_point = Line<p>::gauss_places()[at(k)], weight = Line<p>::gauss_weights()[at(k)];
  const auto second = [](double x) { return 0.5 * (3 * x * x - 1); };
  double sum = 0.5;
  if (q > 0) sum += 1.5 * s * at_point;
  if (q > 1) sum += 2.5 * second(s) * second(at_point);
  return weight * sum;
}

/// Product of `d` lines: quadrilaterals and hexahedra.
template <int d, int p>
struct Brick {
  static constexpr int dim = d, order = p, line = p + 1;
  static constexpr int nodes = d == 1 ? line : d == 2 ? line * line : line * line * line;
  static constexpr int points = nodes, mass_points = nodes, corners = 1 << d;
  static constexpr bool is_simplex = false;

  static Vec<d> corner(int k) {
    Vec<d> s;
    for (int i = 0; i < d; ++i) s[at(i)] = (k >> i & 1) == 1 ? 1 : -1;
    return s;
  }
  static Vec<d> node_place(int a) {
    Vec<d> s;
    for (int k = 0, rest = a; k < d; ++k, rest /= line) s[at(k)] = -1 + 2.0 * (rest % line) / p;
    return s;
  }

  static Values<nodes> values(const Vec<d>& s) {
    std::array<Values<line>, std::size_t{d}> N;
    for (int k = 0; k < d; ++k) N[at(k)] = Line<p>::values(s[at(k)]);
    Values<nodes> product;
    for (int a = 0; a < nodes; ++a) {
      product[at(a)] = 1;
      for (int k = 0, rest = a; k < d; ++k, rest /= line) product[at(a)] *= N[at(k)][at(rest % line)];
    }
    return product;
  }
  /// Gradient of node a: numbers d a .. d a + d - 1.
  static Values<nodes * d> gradients(const Vec<d>& s) {
    std::array<Values<line>, std::size_t{d}> N, dN;
    for (int k = 0; k < d; ++k) N[at(k)] = Line<p>::values(s[at(k)]), dN[at(k)] = Line<p>::slopes(s[at(k)]);
    Values<nodes * d> product;
    for (int a = 0; a < nodes; ++a) {
      for (int i = 0; i < d; ++i) {
        double value = 1;
        for (int k = 0, rest = a; k < d; ++k, rest /= line)
          value *= k == i ? dN[at(k)][at(rest % line)] : N[at(k)][at(rest % line)];
        product[at(a * d + i)] = value;
      }
    }
    return product;
  }
  static Vec<d> place(int point) {
    const auto places = Line<p>::gauss_places();
    Vec<d> s;
    for (int k = 0, rest = point; k < d; ++k, rest /= line) s[at(k)] = places[at(rest % line)];
    return s;
  }
  static double weight(int point) {
    const auto w = Line<p>::gauss_weights();
    double product = 1;
    for (int k = 0, rest = point; k < d; ++k, rest /= line) product *= w[at(rest % line)];
    return product;
  }
  static Vec<d> mass_place(int point) { return place(point); }
  static double mass_weight(int point) { return weight(point); }
  static Vec<d> middle() { return {}; }
  /// Places where derivatives of these functions are most exact: the middle, or of order 2 the points of Gauss' rule
  /// with two a line (J. Barlow, Int. J. Numer. Methods Engrg 10 (1976) 243-251).
  static constexpr int samples = p == 1 ? 1 : 1 << d;
  static Vec<d> sample_place(int sample) {
    Vec<d> s = middle();
    for (int k = 0; k < d && p == 2; ++k) s[at(k)] = (sample >> k & 1 ? 1 : -1) / std::sqrt(3.0);
    return s;
  }
  /// Returns what each point of quadrature adds to a field at s: the product of polynomials of order 1, in which
  /// derivatives of these functions are most exact, or, with `whole`, of order p.
  static Values<points> to_place(const Vec<d>& s, bool whole) {
    Values<points> parts;
    for (int point = 0; point < points; ++point) {
      parts[at(point)] = 1;
      for (int k = 0, rest = point; k < d; ++k, rest /= line)
        parts[at(point)] *= nearest_polynomial<p>(whole ? p : 1, rest % line, s[at(k)]);
    }
    return parts;
  }
};

}  // namespace tether
