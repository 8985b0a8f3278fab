// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "grid/element_sides.hpp"
#include "grid/jacobian.hpp"

namespace tether::fem {

template <int n>
constexpr std::size_t index_count = static_cast<std::size_t>(n);

/// A point of quadrature on a side of a mesh, as its element sees it.
template <class V>
struct SidePoint {
  std::size_t element = 0;
  std::array<double, 2> place;           ///< in the reference element
  Eigen::Vector2d normal;                ///< outward, as long as the point's part of the side [length]
  Eigen::Matrix<double, V::nodes, 1> N;  ///< all of the element's functions there
  Eigen::Matrix<double, 2, V::nodes> G;  ///< and their gradients [1/length]
};

/// An element's side, 0 to 3 as add_sides() counts them.
struct ElementSide {
  std::size_t element = 0;
  int number = 0;
};

/// The elements' sides by their first and last node.
inline std::map<std::pair<int, int>, ElementSide> sides_by_ends(const Mesh& mesh) {
  const auto per_side = static_cast<std::size_t>(side_node_count_of(mesh.kind));
  std::map<std::pair<int, int>, ElementSide> found;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Sides sides;
    add_sides(mesh.kind, mesh.element(e), sides);
    for (int k = 0; k < 4; ++k) {
      const std::size_t first = static_cast<std::size_t>(k) * per_side;
      found[{sides[first], sides[first + per_side - 1]}] = {e, k};
    }
  }
  return found;
}

/// Appends the points of quadrature of these sides of a mesh of quadrilaterals.
template <class V>
void add_side_points(const Mesh& mesh, const Sides& sides, std::vector<SidePoint<V>>& points) {
  using Line = Box<1, V::line - 1>;
  const auto by_ends = sides_by_ends(mesh);
  const auto per_side = static_cast<std::size_t>(V::line);
  for (std::size_t first = 0; first < sides.size(); first += per_side) {
    const ElementSide of = by_ends.at({sides[first], sides[first + per_side - 1]});
    const int axis = of.number / 2, end = of.number % 2;
    const double along = (axis == 0) == (end == 1) ? 1 : -1;  // whether the side runs with the element's coordinate
    for (int k = 0; k < Line::points; ++k) {
      const double t = Line::place(k)[0];
      std::array<double, 2> s;
      s[static_cast<std::size_t>(axis)] = end == 1 ? 1 : -1, s[static_cast<std::size_t>(1 - axis)] = along * t;
      const auto slopes = Line::gradients({t});
      Eigen::Vector2d tangent = Eigen::Vector2d::Zero();
      for (std::size_t a = 0; a < per_side; ++a)
        tangent +=
            slopes[a] * Eigen::Map<const Eigen::Vector2d>(&mesh.x[2 * static_cast<std::size_t>(sides[first + a])]);
      const auto map = jacobian_at<V>(mesh, of.element, s);
      SidePoint<V> at;
      at.element = of.element, at.place = s;
      at.normal = Line::weight(k) * Eigen::Vector2d(tangent[1], -tangent[0]);
      at.N = Eigen::Map<const Eigen::Matrix<double, V::nodes, 1>>(V::values(s).data());
      at.G = Eigen::Map<const Eigen::Matrix<double, 2, V::nodes>>(map.gradients.data());
      points.push_back(at);
    }
  }
}

}  // namespace tether::fem
