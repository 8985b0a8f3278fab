// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/normals.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tether::mpm {
namespace {

template <class Rule, class Color>
Rule mass_matrix(const BackgroundGrid& shape, const Walls& walls, const Method& method, std::size_t most_points) {
  if (method.matrix == MatrixScope::membrane) return MembraneMatrixNormals<Color>(shape, walls, most_points);
  return CellMatrixNormals<Color>(shape, walls, method.lone_point, most_points);
}

template <class Rule>
Rule rule_of(const BackgroundGrid& shape, const Walls& walls, const Method& method, std::size_t most_points) {
  assert(method.normals != NormalRule::connectivity);
  switch (method.normals) {
    case NormalRule::quadratic:
      return QuadraticNormals(shape, walls);
    case NormalRule::cubic:
      return CubicNormals(shape, walls);
    case NormalRule::mass_linear:
      return mass_matrix<Rule, LinearColor>(shape, walls, method, most_points);
    case NormalRule::mass_quadratic:
      return mass_matrix<Rule, QuadraticColor>(shape, walls, method, most_points);
    default:
      return ColorNormals(shape, walls);
  }
}

/// The rules that ask the grid's colour take other points, too.
template <class Rule>
constexpr bool asks_others = requires(Rule rule) {
  rule.update({}, Range{}, std::span<const Slots>{}, Tangents{});
};

}  // namespace

MembraneNormals::MembraneNormals(const BackgroundGrid& shape, const Walls& walls, const Method& method,
                                 std::size_t most_points)
    : rule_(rule_of<decltype(rule_)>(shape, walls, method, most_points)) {}

void MembraneNormals::update(const PlaceArrays& places, Range membrane, std::span<const Slots> others,
                             const Tangents& tangents) {
  std::visit(
      [&]<class Rule>(Rule& rule) {
        if constexpr (asks_others<Rule>) {
          rule.update(places, membrane, others, tangents);
        } else {
          rule.update(places, membrane, tangents);
        }
      },
      rule_);
}

BodyNormals::BodyNormals(const BackgroundGrid& shape, const Walls& walls)
    : nx_(shape.nx), least_(least_color_slope / std::max(shape.dx, shape.dy)), color_(shape, walls) {}

void BodyNormals::take(const PlaceArrays& places, std::span<const std::size_t> points) {
  color_.clear();
  for (const std::size_t p : points) color_.add(places, p);
}

Vec<2> BodyNormals::outward(int node) const {
  const int i = node % nx_, j = node / nx_;
  const Pair inward = color_.gradient(i, j);  // the colour grows into the body
  const double length = std::sqrt(inward[0] * inward[0] + inward[1] * inward[1]);
  if (!(length > least_ * color_.around(i, j))) return {};
  return {-inward[0] / length, -inward[1] / length};
}

}  // namespace tether::mpm
