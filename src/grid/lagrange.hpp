// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "grid/mesh.hpp"

// Shape functions of the finite elements: values and gradients in the reference element, and points and weights of
// their quadrature. Templates chosen once a run.

namespace tether {

/// One-dimensional Lagrange functions of order p over -1 .. 1, nodes from left to right.
template <int p>
struct Line {
  static constexpr int nodes = p + 1;
  static std::array<double, nodes> values(double s) {
    if constexpr (p == 1) {
      return {0.5 * (1 - s), 0.5 * (1 + s)};
    } else {
      return {0.5 * s * (s - 1), 1 - s * s, 0.5 * s * (s + 1)};
    }
  }
  static std::array<double, nodes> slopes(double s) {
    if constexpr (p == 1) {
      return {-0.5, 0.5};
    } else {
      return {s - 0.5, -2 * s, s + 0.5};
    }
  }
  /// Gauss points p + 1: exact to order 2 p + 1, which is what a mass matrix of these functions needs.
  static std::array<double, nodes> gauss_places() {
    if constexpr (p == 1) {
      const double s = 1 / std::sqrt(3.0);
      return {-s, s};
    } else {
      const double s = std::sqrt(0.6);
      return {-s, 0, s};
    }
  }
  static std::array<double, nodes> gauss_weights() {
    if constexpr (p == 1) {
      return {1, 1};
    } else {
      return {5.0 / 9, 8.0 / 9, 5.0 / 9};
    }
  }
};

/// Product of `d` lines: quadrilaterals and hexahedra.
template <int d, int p>
struct Box {
  static constexpr int dim = d, line = p + 1;
  static constexpr int nodes = d == 1 ? line : d == 2 ? line * line : line * line * line;
  static constexpr int points = nodes;

  static std::array<double, nodes> values(const std::array<double, d>& s) {
    std::array<std::array<double, line>, d> N;
    for (int k = 0; k < d; ++k) N[k] = Line<p>::values(s[k]);
    std::array<double, nodes> product;
    for (int a = 0; a < nodes; ++a) {
      product[a] = 1;
      for (int k = 0, rest = a; k < d; ++k, rest /= line) product[a] *= N[k][rest % line];
    }
    return product;
  }
  /// Gradient of node a: numbers d a .. d a + d - 1.
  static std::array<double, std::size_t{nodes} * d> gradients(const std::array<double, d>& s) {
    std::array<std::array<double, line>, d> N, dN;
    for (int k = 0; k < d; ++k) N[k] = Line<p>::values(s[k]), dN[k] = Line<p>::slopes(s[k]);
    std::array<double, std::size_t{nodes} * d> product;
    for (int a = 0; a < nodes; ++a) {
      for (int i = 0; i < d; ++i) {
        double value = 1;
        for (int k = 0, rest = a; k < d; ++k, rest /= line) value *= k == i ? dN[k][rest % line] : N[k][rest % line];
        product[a * d + i] = value;
      }
    }
    return product;
  }
  static std::array<double, d> place(int point) {
    const auto at = Line<p>::gauss_places();
    std::array<double, d> s;
    for (int k = 0, rest = point; k < d; ++k, rest /= line) s[k] = at[rest % line];
    return s;
  }
  static double weight(int point) {
    const auto w = Line<p>::gauss_weights();
    double product = 1;
    for (int k = 0, rest = point; k < d; ++k, rest /= line) product *= w[rest % line];
    return product;
  }
};

/// Linear triangles and tetrahedra over the corner of the unit cube; d + 1 points, exact to order 2.
template <int d>
struct Simplex {
  static constexpr int dim = d, nodes = d + 1, points = d == 1 ? 2 : d + 1;

  static std::array<double, nodes> values(const std::array<double, d>& s) {
    std::array<double, nodes> N{1};
    for (int k = 0; k < d; ++k) N[0] -= s[k], N[k + 1] = s[k];
    return N;
  }
  static std::array<double, std::size_t{nodes} * d> gradients(const std::array<double, d>&) {
    std::array<double, std::size_t{nodes} * d> G{};
    for (int k = 0; k < d; ++k) G[k] = -1, G[(k + 1) * d + k] = 1;
    return G;
  }
  /// Source: the symmetric rules of order 2 (A. H. Stroud, Approximate Calculation of Multiple Integrals, 1971).
  static std::array<double, d> place(int point) {
    const double near = d == 2 ? 2.0 / 3 : (5 + 3 * std::sqrt(5.0)) / 20, far = (1 - near) / d;
    std::array<double, d> s;
    for (int k = 0; k < d; ++k) s[k] = point == k + 1 ? near : far;
    return s;
  }
  static double weight(int) { return d == 2 ? 1.0 / 6 : 1.0 / 24; }
};

/// The shape functions of a kind of element, and of its sides.
template <ElementKind kind>
struct ShapesOf;
template <>
struct ShapesOf<ElementKind::quad4> : Box<2, 1> {
  using Side = Box<1, 1>;
};
template <>
struct ShapesOf<ElementKind::quad9> : Box<2, 2> {
  using Side = Box<1, 2>;
};
template <>
struct ShapesOf<ElementKind::tri3> : Simplex<2> {
  using Side = Box<1, 1>;
};
template <>
struct ShapesOf<ElementKind::hex8> : Box<3, 1> {
  using Side = Box<2, 1>;
};
template <>
struct ShapesOf<ElementKind::hex27> : Box<3, 2> {
  using Side = Box<2, 2>;
};
template <>
struct ShapesOf<ElementKind::tet4> : Simplex<3> {
  using Side = Simplex<2>;
};

/// Calls f with the shapes of the kind: the one place where a kind becomes a template.
template <class Function>
auto with_shapes(ElementKind kind, const Function& f) {
  switch (kind) {
    case ElementKind::quad4:
      return f(ShapesOf<ElementKind::quad4>{});
    case ElementKind::quad9:
      return f(ShapesOf<ElementKind::quad9>{});
    case ElementKind::tri3:
      return f(ShapesOf<ElementKind::tri3>{});
    case ElementKind::hex8:
      return f(ShapesOf<ElementKind::hex8>{});
    case ElementKind::hex27:
      return f(ShapesOf<ElementKind::hex27>{});
    case ElementKind::tet4:
      break;
  }
  return f(ShapesOf<ElementKind::tet4>{});
}

}  // namespace tether
