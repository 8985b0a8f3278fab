// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "grid/lagrange.hpp"
#include "grid/mesh.hpp"

namespace tether {

/// Of an element's map from its reference element: determinant, and gradients of the shape functions in space, numbers
/// dim a .. dim a + dim - 1 of node a [1/length].
template <class Shapes>
struct Jacobian {
  double determinant = 0;
  std::array<double, static_cast<std::size_t>(Shapes::nodes* Shapes::dim)> gradients{};
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
Jacobian<Shapes> jacobian_at(const Mesh& mesh, std::size_t e, const std::array<double, Shapes::dim>& s) {
  constexpr int dim = Shapes::dim;
  const auto G = Shapes::gradients(s);
  const int* nodes = mesh.element(e);
  std::array<double, static_cast<std::size_t>(dim * dim)> J{};  // dx_i / ds_j
  for (int a = 0; a < Shapes::nodes; ++a) {
    const double* x = &mesh.x[static_cast<std::size_t>(nodes[a]) * dim];
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) J[i * dim + j] += x[i] * G[a * dim + j];
    }
  }
  Jacobian<Shapes> result;
  result.determinant = invert(J);
  for (int a = 0; a < Shapes::nodes; ++a) {
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) result.gradients[a * dim + i] += G[a * dim + j] * J[j * dim + i];
    }
  }
  return result;
}

}  // namespace tether
