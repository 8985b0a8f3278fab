// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grid/contact/pair_distance.hpp"

namespace tether {

/// First and second derivatives of a pair's squared distance by its products, of which it is a function.
template <int count>
struct DistanceSlopes {
  Products<count> first;
  ProductMap<count> second;
};

namespace pair_distance_detail {

// The square by the products of the vectors that are used is g11 - M/D, the part of the first one that lies along the
// others taken off. Here are its derivatives by these products.

/// M of three vectors, D being crossing(g).
inline double along_others(const Products<3>& g) {
  return g[1] * g[1] * g[5] - 2 * g[1] * g[2] * g[4] + g[2] * g[2] * g[3];
}

inline Products<1> slope_of_used(const Products<1>&) { return {1}; }
inline Products<2> slope_of_used(const Products<2>& g) {
  const double along = g[1] * g[1] / g[2];
  return {1, -(2 * g[1] / g[2]), along / g[2]};
}
inline Products<3> slope_of_used(const Products<3>& g) {
  const double D = crossing(g), part = along_others(g) / D;
  const Products<3> D1 = crossing_slope(g);
  Products<3> slope = {
      0,          2 * (g[1] * g[5] - g[2] * g[4]), 2 * (g[2] * g[3] - g[1] * g[4]), g[2] * g[2], -2 * g[1] * g[2],
      g[1] * g[1]};  // of M
  for (int k = 0; k < 6; ++k) slope[k] = -((slope[k] - part * D1[k]) / D);
  slope[0] = 1;
  return slope;
}

inline ProductMap<1> slope_change_of_used(const Products<1>&, const Products<1>&) { return {0}; }
inline ProductMap<2> slope_change_of_used(const Products<2>& g, const Products<2>& first) {
  const double change = -first[1] / g[2];
  return {0, 0, 0, 0, -(2 / g[2]), change, 0, change, -2 * first[2] / g[2]};
}
inline ProductMap<3> slope_change_of_used(const Products<3>& g, const Products<3>& first) {
  const double D = crossing(g), part = along_others(g) / D;
  const Products<3> D1 = crossing_slope(g);
  auto second = ProductMap<3>::Zero();  // of M - part D
  second.row(1) = SmallMatrix<1, 6>(0, 2 * g[5], -2 * g[4], 0, -2 * g[2], 2 * g[1]);
  second.row(2) = SmallMatrix<1, 6>(0, -2 * g[4], 2 * g[3], 2 * g[2], -2 * g[1], 0);
  second.col(1) = second.row(1).transpose(), second.col(2) = second.row(2).transpose();
  second(3, 5) = second(5, 3) = -part, second(4, 4) = 2 * part;
  for (int j = 1; j < 6; ++j) {
    for (int i = 1; i < 6; ++i) second(i, j) = -(second(i, j) + first[i] * D1[j] + D1[i] * first[j]) / D;
  }
  return second;
}

/// Products of the vectors that are used by those of the pair.
template <int used, int count>
SmallMatrix<product_count<used>, product_count<count>> used_products(const Nearest<count>& nearest) {
  auto products = SmallMatrix<product_count<used>, product_count<count>>::Zero();
  for (int a = 0; a < used; ++a) {
    for (int b = a; b < used; ++b) {
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j)
          products(product_at(used, a, b), product_at(count, i, j)) += nearest.sums(i, a) * nearest.sums(j, b);
      }
    }
  }
  return products;
}

}  // namespace pair_distance_detail

/// The first ones alone.
template <int count>
Products<count> distance_slope(const Products<count>& g, const Nearest<count>& nearest) {
  using namespace pair_distance_detail;
  return with_used<count>(nearest.used, [&](auto n) -> Products<count> {
    constexpr int used = decltype(n)::value;
    if constexpr (used == count) {
      return slope_of_used(g);
    } else {
      const auto products = used_products<used>(nearest);
      return products.transpose() * slope_of_used(Products<used>(products * g));
    }
  });
}

template <int count>
DistanceSlopes<count> distance_slopes(const Products<count>& g, const Nearest<count>& nearest) {
  using namespace pair_distance_detail;
  return with_used<count>(nearest.used, [&](auto n) -> DistanceSlopes<count> {
    constexpr int used = decltype(n)::value;
    if constexpr (used == count) {
      const Products<count> first = slope_of_used(g);
      return {first, slope_change_of_used(g, first)};
    } else {
      const auto products = used_products<used>(nearest);
      const Products<used> p = products * g, first = slope_of_used(p);
      if constexpr (used == 1) return {products.transpose() * first, ProductMap<count>::Zero()};
      return {products.transpose() * first, products.transpose() * slope_change_of_used(p, first) * products};
    }
  });
}

/// The way from one nearest place to the other as a sum of the pair's vectors, and how its parts change with the
/// products.
template <int count>
struct NearestWay {
  SmallMatrix<count, 1> parts;
  SmallMatrix<count, product_count<count>> slopes = decltype(slopes)::Zero();
};

template <int count>
NearestWay<count> nearest_way(const Products<count>& g, const Nearest<count>& nearest) {
  NearestWay<count> way;
  way.parts = nearest.sums.col(0);
  if constexpr (count > 1) {
    if (nearest.used == 2) {
      const auto used = pair_distance_detail::used_products<2>(nearest);
      const Products<2> p = used * g;
      const double t = p[1] / p[2];
      way.parts -= t * nearest.sums.col(1);
      way.slopes = -nearest.sums.col(1) * (used.row(1) - t * used.row(2)) / p[2];
    }
  }
  if constexpr (count == 3) {
    if (nearest.used == 3) {
      const SmallMatrix<2, 2> inverse = SmallMatrix<2, 2>{g[5], -g[4], -g[4], g[3]} / (g[3] * g[5] - g[4] * g[4]);
      const SmallMatrix<2, 1> t = inverse * SmallMatrix<2, 1>{g[1], g[2]};
      const SmallMatrix<2, 6> by = {0, 1, 0, -t[0], -t[1], 0, 0, 0, 1, 0, -t[0], -t[1]};
      way.parts.template block<2, 1>(1, 0) = -t;
      way.slopes.template block<2, 6>(1, 0) = -inverse * by;
    }
  }
  return way;
}

}  // namespace tether
