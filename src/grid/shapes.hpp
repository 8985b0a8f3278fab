// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether {

// Shape functions of the finite elements: values and gradients in the reference element, and points and weights of
// their quadrature. Templates chosen once a run.

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
  static constexpr int dim = d, line = p + 1;
  static constexpr int nodes = d == 1 ? line : d == 2 ? line * line : line * line * line;
  static constexpr int points = nodes;

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
  /// Returns what each point of quadrature adds to a field at node a: the product of polynomials of order 1, in which
  /// derivatives of these functions are most exact, or, with `whole`, of order p.
  static Values<points> to_node(int a, bool whole) {
    Values<points> parts;
    for (int point = 0; point < points; ++point) {
      parts[at(point)] = 1;
      for (int k = 0, rest = point, node = a; k < d; ++k, rest /= line, node /= line)
        parts[at(point)] *= nearest_polynomial<p>(whole ? p : 1, rest % line, -1 + 2.0 * (node % line) / p);
    }
    return parts;
  }
};

/// Linear triangles and tetrahedra over the corner of the unit cube; d + 1 points, exact to order 2.
template <int d>
struct Simplex {
  static constexpr int dim = d, nodes = d + 1, points = d == 1 ? 2 : d + 1;

  static Values<nodes> values(const Vec<d>& s) {
    Values<nodes> N{1};
    for (int k = 0; k < d; ++k) N[0] -= s[at(k)], N[at(k + 1)] = s[at(k)];
    return N;
  }
  static Values<nodes * d> gradients(const Vec<d>&) {
    Values<nodes * d> G{};
    for (int k = 0; k < d; ++k) G[at(k)] = -1, G[at((k + 1) * d + k)] = 1;
    return G;
  }
  /// Source: the symmetric rules of order 2 (A. H. Stroud, Approximate Calculation of Multiple Integrals, 1971).
  static Vec<d> place(int point) {
    const double near = d == 2 ? 2.0 / 3 : (5 + 3 * std::sqrt(5.0)) / 20, far = (1 - near) / d;
    Vec<d> s;
    for (int k = 0; k < d; ++k) s[at(k)] = point == k + 1 ? near : far;
    return s;
  }
  static double weight(int) { return d == 2 ? 1.0 / 6 : 1.0 / 24; }
  /// Returns what each point of quadrature adds to a field at any node: derivatives of linear functions have one value.
  static Values<points> to_node(int, bool) {
    Values<points> parts;
    parts.fill(1.0 / points);
    return parts;
  }
};

/// The shape functions of a kind of element, and of its sides.
template <ElementKind kind>
struct ShapesOf;
template <>
struct ShapesOf<ElementKind::quad4> : Brick<2, 1> {
  using Side = Brick<1, 1>;
};
template <>
struct ShapesOf<ElementKind::quad9> : Brick<2, 2> {
  using Side = Brick<1, 2>;
};
template <>
struct ShapesOf<ElementKind::tri3> : Simplex<2> {
  using Side = Brick<1, 1>;
};
template <>
struct ShapesOf<ElementKind::hex8> : Brick<3, 1> {
  using Side = Brick<2, 1>;
};
template <>
struct ShapesOf<ElementKind::hex27> : Brick<3, 2> {
  using Side = Brick<2, 2>;
};
template <>
struct ShapesOf<ElementKind::tet4> : Simplex<3> {
  using Side = Simplex<2>;
};

/// Calls f with the shapes of the kind: the one place where a kind becomes a template. Of plane elements alone where
/// `dim` is 2, as a flow has them. Throws std::logic_error where there are no such shapes.
template <int dim = 0, class Function>
auto with_shapes(ElementKind kind, const Function& f) {
  using First = std::conditional_t<dim == 3, ShapesOf<ElementKind::hex8>, ShapesOf<ElementKind::quad4>>;
  using Result = decltype(f(First{}));
  const auto call = [&]<std::size_t k>(auto& self, std::integral_constant<std::size_t, k>) -> Result {
    if constexpr (k == element_rows.size()) {
      throw std::logic_error("a kind of element without shapes");
    } else {
      constexpr ElementRow row = element_rows[k];
      if constexpr (dim == 0 || dim == row.dim) {
        if (row.kind == kind) return f(ShapesOf<row.kind>{});
      }
      return self(self, std::integral_constant<std::size_t, k + 1>{});
    }
  };
  return call(call, std::integral_constant<std::size_t, 0>{});
}

/// Of an element's map from its reference element: determinant, and gradients of the shape functions in space, numbers
/// dim a .. dim a + dim - 1 of node a [1/length].
template <class Shapes>
struct Jacobian {
  double determinant = 0;
  Values<Shapes::nodes * Shapes::dim> gradients{};
};

/// Inverse (in place) and determinant of a 2 x 2 or 3 x 3 matrix, row-major.
inline double invert(std::array<double, 4>& m) {
  const double det = m[0] * m[3] - m[1] * m[2];
  m = {m[3] / det, -m[1] / det, -m[2] / det, m[0] / det};
  return det;
}
inline double invert(std::array<double, 9>& m) {
  const double c0 = m[4] * m[8] - m[5] * m[7], c1 = m[5] * m[6] - m[3] * m[8], c2 = m[3] * m[7] - m[4] * m[6];
  const double det = m[0] * c0 + m[1] * c1 + m[2] * c2;
  m = {c0 / det, (m[2] * m[7] - m[1] * m[8]) / det, (m[1] * m[5] - m[2] * m[4]) / det,
       c1 / det, (m[0] * m[8] - m[2] * m[6]) / det, (m[2] * m[3] - m[0] * m[5]) / det,
       c2 / det, (m[1] * m[6] - m[0] * m[7]) / det, (m[0] * m[4] - m[1] * m[3]) / det};
  return det;
}

template <class Shapes>
Jacobian<Shapes> jacobian_at(const Mesh& mesh, std::size_t e, const Vec<Shapes::dim>& s) {
  constexpr int dim = Shapes::dim;
  const auto G = Shapes::gradients(s);
  const int* nodes = mesh.element(e);
  Values<dim * dim> J{};  // dx_i / ds_j
  for (int a = 0; a < Shapes::nodes; ++a) {
    const double* x = &mesh.x[at(nodes[a]) * dim];
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) J[at(i * dim + j)] += x[i] * G[at(a * dim + j)];
    }
  }
  Jacobian<Shapes> result;
  result.determinant = invert(J);
  for (int a = 0; a < Shapes::nodes; ++a) {
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) result.gradients[at(a * dim + i)] += G[at(a * dim + j)] * J[at(j * dim + i)];
    }
  }
  return result;
}

}  // namespace tether
