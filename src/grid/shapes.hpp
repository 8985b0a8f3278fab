// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/brick.hpp"
#include "grid/mesh.hpp"
#include "grid/simplex.hpp"

namespace tether {

// Shape functions of the finite elements: values and gradients in the reference element, and points and weights of
// their quadrature: one rule for what has gradients, and a `mass_` one that is exact for products of two functions.
// Templates chosen once a run.

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
struct ShapesOf<ElementKind::tri3> : Simplex<2, 1> {
  using Side = Brick<1, 1>;
};
template <>
struct ShapesOf<ElementKind::tri6> : Simplex<2, 2> {
  using Side = Brick<1, 2>;
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
struct ShapesOf<ElementKind::tet4> : Simplex<3, 1> {
  using Side = Simplex<2, 1>;
};
template <>
struct ShapesOf<ElementKind::tet10> : Simplex<3, 2> {
  using Side = Simplex<2, 2>;
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
