// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace tether::fem {

// What integrals over plane elements ask of a shape, as tables: its nodes and points are counted at run time, so that
// an integral is compiled once for all shapes.

inline constexpr std::size_t most_plane_nodes = 9;
/// A number or a vector for each node of an element, the first ones of these.
using PlaneNumbers = std::array<double, most_plane_nodes>;
using PlaneVectors = std::array<Vec<2>, most_plane_nodes>;
/// A matrix by its rows.
using PlaneMatrix = std::array<Vec<2>, 2>;

/// a_ij b_j
inline Vec<2> product(const PlaneMatrix& a, const Vec<2>& b) { return {dot(a[0], b), dot(a[1], b)}; }

/// Functions N of a shape at a place s of the reference element, a point of quadrature or any other.
struct PlanePoint {
  Vec<2> s{};
  double weight = 0;      ///< of the quadrature, 0 elsewhere
  PlaneNumbers N{};       ///< a node
  PlaneVectors slopes{};  ///< dN/ds, a node
};
PlanePoint plane_point(ElementKind kind, const Vec<2>& s);

/// The points of both rules of a shape: for what has slopes, and for products of two functions.
struct PlaneShape {
  std::size_t nodes = 0;
  std::vector<PlanePoint> points = {}, mass_points = {};
};
/// Throws std::logic_error where the kind is not plane.
PlaneShape plane_shape(ElementKind kind);

/// A point of quadrature on a side of a shape, which runs from -1 to 1: weight and slopes of the side's own functions.
struct PlaneSidePoint {
  double s = 0, weight = 0;
  std::vector<double> slopes = {};
};
std::vector<PlaneSidePoint> plane_side_points(ElementKind kind);

/// Two numbers of each of an element's nodes.
PlaneVectors gathered(const Mesh& mesh, std::size_t e, std::span<const double> numbers);

/// sum N_a v_a
inline Vec<2> mean(std::size_t nodes, const PlaneNumbers& N, const PlaneVectors& v) {
  Vec<2> sum{};
  for (std::size_t a = 0; a < nodes; ++a) sum[0] += N[a] * v[a][0], sum[1] += N[a] * v[a][1];
  return sum;
}
/// L_ij = dv_i/dx_j, of the functions' gradients G.
inline PlaneMatrix slopes(std::size_t nodes, const PlaneVectors& v, std::span<const Vec<2>> G) {
  PlaneMatrix L{};
  for (std::size_t a = 0; a < nodes; ++a) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) L[i][j] += v[a][i] * G[a][j];
    }
  }
  return L;
}

/// Of an element's map from its reference element, its nodes at these places: determinant [volume], ds/dx [1/length],
/// and the gradients of its functions, one of each node [1/length].
struct PlaneMap {
  double determinant = 0;
  PlaneMatrix to_reference{};
  PlaneVectors gradients{};
};
PlaneMap plane_map(std::size_t nodes, const PlaneVectors& places, const PlanePoint& at);

}  // namespace tether::fem
