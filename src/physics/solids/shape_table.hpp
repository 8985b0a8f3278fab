// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "grid/shapes.hpp"

namespace tether::fem {

/// Nodes that an element of this dimension has at most. None has more points of quadrature.
template <int dim>
constexpr std::size_t most_nodes = [] {
  int most = 0;
  for (const ElementRow& row : element_rows) most = row.dim == dim ? std::max(most, row.nodes) : most;
  return at(most);
}();

/// An element's shape functions as numbers where integrals ask for them. How many nodes and points it has is known at
/// run time, so that the elements of a dimension are compiled once and not for each shape.
struct ShapeTable {
  /// Shape functions at some places, `nodes` numbers each, and what each point of quadrature adds to a field there,
  /// `points` numbers each.
  struct Carried {
    std::vector<double> values, parts;
  };

  std::size_t nodes = 0, points = 0, mass_points = 0, samples = 0;
  int order = 0;
  bool is_simplex = false;
  std::vector<double> values, mass_values;    ///< at the points of each rule, `nodes` numbers a point
  std::vector<double> parts, parts_of_whole;  ///< of the points at each node, as Shapes::to_place() has them
  Carried at_samples, at_middle;
  /// Returns a point's part of an element's volume, and sets the gradients in space, dim numbers a node [1/length].
  double (*weight)(const Mesh& mesh, std::size_t element, int point, double* gradients) = nullptr;
  double (*mass_weight)(const Mesh& mesh, std::size_t element, int point) = nullptr;
};

inline void append(std::span<const double> numbers, std::vector<double>& to) {
  to.insert(to.end(), numbers.begin(), numbers.end());
}

/// Appends what is carried to a place.
template <class Shapes>
void append_place(const Vec<Shapes::dim>& place, ShapeTable::Carried& to) {
  append(Shapes::values(place), to.values);
  append(Shapes::to_place(place, false), to.parts);
}

template <class Shapes>
ShapeTable table_of() {
  static_assert(at(Shapes::points) <= most_nodes<Shapes::dim>);
  ShapeTable table;
  table.nodes = at(Shapes::nodes);
  table.points = at(Shapes::points);
  table.mass_points = at(Shapes::mass_points);
  table.samples = at(Shapes::samples);
  table.order = Shapes::order;
  table.is_simplex = Shapes::is_simplex;
  for (int k = 0; k < Shapes::points; ++k) append(Shapes::values(Shapes::place(k)), table.values);
  for (int k = 0; k < Shapes::mass_points; ++k) append(Shapes::values(Shapes::mass_place(k)), table.mass_values);
  for (int a = 0; a < Shapes::nodes; ++a) {
    append(Shapes::to_place(Shapes::node_place(a), false), table.parts);
    append(Shapes::to_place(Shapes::node_place(a), true), table.parts_of_whole);
  }
  for (int s = 0; s < Shapes::samples; ++s) append_place<Shapes>(Shapes::sample_place(s), table.at_samples);
  append_place<Shapes>(Shapes::middle(), table.at_middle);
  table.weight = [](const Mesh& mesh, std::size_t element, int point, double* gradients) {
    const auto map = jacobian_at<Shapes>(mesh, element, Shapes::place(point));
    std::ranges::copy(map.gradients, gradients);
    return map.determinant * Shapes::weight(point);
  };
  table.mass_weight = [](const Mesh& mesh, std::size_t element, int point) {
    return jacobian_at<Shapes>(mesh, element, Shapes::mass_place(point)).determinant * Shapes::mass_weight(point);
  };
  return table;
}

}  // namespace tether::fem
