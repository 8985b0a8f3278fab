// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "base/numbers.hpp"
#include "base/vec.hpp"
#include "grid/shapes.hpp"

namespace tether {

// How a side of an element is parted for contact: points of quadrature, and facets between its corners and middles.

/// Gauss' rule with `n` points on -1 .. 1.
struct GaussRule {
  std::vector<double> places, weights;
  explicit GaussRule(int n) {
    for (const double x : boost::math::legendre_p_zeros<double>(n)) {  // those that are not below 0
      const double slope = boost::math::legendre_p_prime(n, x), weight = 2 / ((1 - x * x) * slope * slope);
      places.push_back(x), weights.push_back(weight);
      if (x > 0) places.push_back(-x), weights.push_back(weight);
    }
  }
};

/// A place of quadrature on a reference side.
template <int d>
struct SidePoint {
  Vec<d> place;
  double weight;
};

/// So many points a line of a side of order 1 or 2.
constexpr int points_a_line(int dim, int order) { return dim == 2 ? (order == 1 ? 5 : 8) : (order == 1 ? 4 : 6); }

template <class Side>
std::vector<SidePoint<Side::dim>> side_points() {
  constexpr int d = Side::dim;
  std::vector<SidePoint<d>> points;
  if constexpr (Side::is_simplex) {
    using Rule = Simplex<2, Side::order>;  // on each of the four triangles between corners and middles
    for (int part = 0; part < 4; ++part) {
      for (int k = 0; k < Rule::mass_points; ++k) {
        const auto s = Rule::mass_place(k);
        const double turn = part == 3 ? -0.5 : 0.5;
        const Vec<2> from{part == 1 ? 0.5 : part == 3 ? 0.5 : 0, part == 2 ? 0.5 : part == 3 ? 0.5 : 0};
        points.push_back({{from[0] + turn * s[0], from[1] + turn * s[1]}, 0.25 * Rule::mass_weight(k)});
      }
    }
  } else {
    const GaussRule rule(points_a_line(d + 1, Side::order));
    for (std::size_t j = 0; j < (d == 2 ? rule.places.size() : 1); ++j) {
      for (std::size_t i = 0; i < rule.places.size(); ++i) {
        Vec<d> place;
        place[0] = rule.places[i];
        if constexpr (d == 2) place[1] = rule.places[j];
        points.push_back({place, rule.weights[i] * (d == 2 ? rule.weights[j] : 1)});
      }
    }
  }
  return points;
}

/// What a side's pressing facets hang between: sums of its nodes, and the node that names each, so that sides which
/// share it share the place; -1 of a place that the side has alone.
struct SideCorner {
  std::vector<double> shares;
  int node = -1;
};
struct SideFacets {
  std::vector<SideCorner> corners;
  std::vector<std::array<int, 3>> facets;
  std::vector<std::array<int, 2>> edges;  ///< of the whole side, by numbers of nodes: from corner to corner
};

/// The middle of an edge: 4/3 of its node less a sixth of both ends.
inline void add_middle(std::size_t nodes, int a, int middle, int b, SideFacets& side) {
  SideCorner corner{std::vector<double>(nodes, 0.0), middle};
  corner.shares[at(middle)] = 4.0 / 3, corner.shares[at(a)] = corner.shares[at(b)] = -1.0 / 6;
  side.corners.push_back(std::move(corner));
}

inline void add_corner(std::size_t nodes, int node, SideFacets& side) {
  side.corners.push_back({std::vector<double>(nodes, 0.0), node});
  side.corners.back().shares[at(node)] = 1;
}

/// Parts a side of four corners. With order 2 nodes stand in three rows of three. Eight triangles meet in the middle,
/// whose place follows from the nodes' shares of a constant pressure, 1/36, 4/36 and 16/36, as those of the edges'
/// middles do.
inline SideFacets facets_of_square(int order) {
  SideFacets side;
  if (order == 1) {
    for (int a = 0; a < 4; ++a) add_corner(4, a, side);
    side.corners.push_back({std::vector<double>(4, 0.25), -1});
    side.facets = {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}}, side.edges = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    return side;
  }
  constexpr std::array<std::array<int, 3>, 4> edges{{{0, 1, 2}, {2, 5, 8}, {8, 7, 6}, {6, 3, 0}}};
  for (const auto& [a, middle, b] : edges) {
    const int first = static_cast<int>(side.corners.size());
    add_corner(9, a, side), add_middle(9, a, middle, b, side);
    side.facets.push_back({first, first + 1, 8}), side.facets.push_back({first + 1, (first + 2) % 8, 8});
    side.edges.push_back({a, b});
  }
  SideCorner centre{std::vector<double>(9, 0.0), -1};
  for (const int a : {0, 2, 6, 8}) centre.shares[at(a)] = -1.0 / 12;
  centre.shares[4] = 4.0 / 3;
  side.corners.push_back(std::move(centre));
  return side;
}

template <class Side>
SideFacets facets_of() {
  SideFacets side;
  constexpr auto nodes = std::size_t{Side::nodes};
  if constexpr (Side::dim == 1) {
    side.facets = {{0, 1, -1}}, side.edges = {{0, Side::nodes - 1}};
    add_corner(nodes, 0, side);
    if (Side::order == 2) add_middle(nodes, 0, 1, 2, side), side.facets.push_back({1, 2, -1});
    add_corner(nodes, Side::nodes - 1, side);
  } else if constexpr (!Side::is_simplex) {
    side = facets_of_square(Side::order);
  } else {
    for (int a = 0; a < 3; ++a) add_corner(nodes, a, side), side.edges.push_back({a, (a + 1) % 3});
    side.facets = {{0, 1, 2}};
    if constexpr (Side::order == 2) {
      std::array<int, 3> middle{};  // of the edge from corner a to the next
      for (int a = 0; a < 3; ++a) {
        const auto from = Side::node_place(a), to = Side::node_place((a + 1) % 3);
        for (int m = 3; m < 6; ++m) {
          const auto place = Side::node_place(m);
          if (std::abs(2 * place[0] - from[0] - to[0]) + std::abs(2 * place[1] - from[1] - to[1]) < 1e-9)
            middle[at(a)] = m;
        }
        add_middle(nodes, a, middle[at(a)], (a + 1) % 3, side);
      }
      side.facets = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    }
  }
  return side;
}

}  // namespace tether
