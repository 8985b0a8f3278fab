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

/// Returns the points of a triangle whose edges are cut into so many parts.
template <class Side>
std::vector<SidePoint<2>> triangle_points(int parts) {
  using Rule = Simplex<2, Side::order>;
  const double size = 1.0 / parts;
  std::vector<SidePoint<2>> points;
  const auto add = [&](double x, double y, double turn) {  // one of the small triangles, from its corner at x, y
    for (int k = 0; k < Rule::mass_points; ++k) {
      const auto s = Rule::mass_place(k);
      points.push_back({{x + turn * size * s[0], y + turn * size * s[1]}, size * size * Rule::mass_weight(k)});
    }
  };
  for (int row = 0; row < parts; ++row) {
    for (int i = 0; i < parts - row; ++i) {
      add(i * size, row * size, 1);
      if (i + row + 1 < parts) add((i + 1) * size, (row + 1) * size, -1);
    }
  }
  return points;
}

/// The points of a side of which each line is cut into so many parts, each with points of its own. The lines of a
/// triangle are cut into twice as many, or four times with order 2: its rules have fewer points.
template <class Side>
std::vector<SidePoint<Side::dim>> side_points(int parts) {
  constexpr int d = Side::dim;
  if constexpr (Side::is_simplex) {
    return triangle_points<Side>((Side::order == 1 ? 2 : 4) * parts);
  } else {
    const GaussRule rule(points_a_line(d + 1, Side::order));
    std::vector<double> places, weights;
    for (int part = 0; part < parts; ++part) {
      for (std::size_t k = 0; k < rule.places.size(); ++k) {
        places.push_back((2 * part + 1 + rule.places[k]) / parts - 1);
        weights.push_back(rule.weights[k] / parts);
      }
    }
    std::vector<SidePoint<d>> points;
    for (std::size_t j = 0; j < (d == 2 ? places.size() : 1); ++j) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        Vec<d> place;
        place[0] = places[i];
        if constexpr (d == 2) place[1] = places[j];
        points.push_back({place, weights[i] * (d == 2 ? weights[j] : 1)});
      }
    }
    return points;
  }
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
