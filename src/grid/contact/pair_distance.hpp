// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "base/small_matrix.hpp"

namespace tether {

// The distance of a place from a corner, an edge or a triangle, and of two edges, by the products of `count` vectors
// between their corners,
//
//   g_ij = r_i . r_j,  in the order 11, 12, 13, 22, 23, 33,
//
// which do not change as a pair moves and turns as one. count = 1: r1 from the corner to the place. 2: r1 from the
// edge's first corner to the place, r2 to its second corner. 3: r1 from the triangle's first corner to the place, r2
// and r3 to the others; or of edges r1 from the first one's first corner to that of the second, r2 along the first, r3
// along the second.

/// What a pair is made of.
enum class PairKind { corner, edge, triangle, edges };
constexpr int vector_count(PairKind kind) { return kind == PairKind::corner ? 1 : kind == PairKind::edge ? 2 : 3; }

template <int count>
constexpr int product_count = count*(count + 1) / 2;
template <int count>
using Products = SmallMatrix<product_count<count>, 1>;
template <int count>
using ProductMap = SmallMatrix<product_count<count>, product_count<count>>;
template <int dim, int count>
using PairVectors = SmallMatrix<dim, count>;

/// Place of g_ij among `count` vectors' products, i and j from 0.
constexpr int product_at(int count, int i, int j) {
  const int low = i < j ? i : j, high = i < j ? j : i;
  return low * count - low * (low - 1) / 2 + high - low;
}

/// This and what calls it is inlined, as numbers that were just stored one by one are slow to load by twos.
template <int dim, int count>
[[gnu::always_inline]] inline Products<count> products_of(const PairVectors<dim, count>& r) {
  Products<count> g;
#pragma GCC unroll 3
  for (int i = 0; i < count; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < count; ++j) g[product_at(count, i, j)] = r.col(i).dot(r.col(j));
  }
  return g;
}

/// |r2 x r3|^2
inline double crossing(const Products<3>& g) { return g[3] * g[5] - g[4] * g[4]; }
inline Products<3> crossing_slope(const Products<3>& g) { return {0, 0, 0, g[5], -2 * g[4], g[3]}; }

/// Where two things are nearest: `used` vectors of the pair, each a sum of the pair's own, say it all, the distance
/// being that of the first from what the others span. Where as many are used as the pair has, they are its own.
template <int count>
struct Nearest {
  int used = 1;
  SmallMatrix<count, count> sums;  // a column a vector, those that are used
};

namespace pair_distance_detail {

template <int count>
Nearest<count> nearest_of(int used, const std::array<std::array<double, 3>, 3>& sums) {
  Nearest<count> nearest;
  nearest.used = used;
  for (int i = 0; i < used; ++i) {
    for (int j = 0; j < count; ++j) nearest.sums(j, i) = sums[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return nearest;
}

}  // namespace pair_distance_detail

inline Nearest<1> nearest_to_corner() { return pair_distance_detail::nearest_of<1>(1, {{{1, 0, 0}}}); }

inline Nearest<2> nearest_on_edge(const Products<2>& g) {
  using pair_distance_detail::nearest_of;
  if (g[1] <= 0) return nearest_of<2>(1, {{{1, 0, 0}}});
  if (g[1] >= g[2]) return nearest_of<2>(1, {{{1, -1, 0}}});
  return nearest_of<2>(2, {{{1, 0, 0}, {0, 1, 0}}});
}

/// The regions of a triangle by the products alone (C. Ericson, Real-Time Collision Detection, 2005, 5.1.5).
inline Nearest<3> nearest_on_triangle(const Products<3>& g) {
  using pair_distance_detail::nearest_of;
  const double d1 = g[1], d2 = g[2];  // along both edges from the first corner,
  if (d1 <= 0 && d2 <= 0) return nearest_of<3>(1, {{{1, 0, 0}}});
  const double d3 = g[1] - g[3], d4 = g[2] - g[4];  // the second
  if (d3 >= 0 && d4 <= d3) return nearest_of<3>(1, {{{1, -1, 0}}});
  const double c = d1 * d4 - d3 * d2;
  if (c <= 0 && d1 >= 0 && d3 <= 0) return nearest_of<3>(2, {{{1, 0, 0}, {0, 1, 0}}});
  const double d5 = g[1] - g[4], d6 = g[2] - g[5];  // and the third
  if (d6 >= 0 && d5 <= d6) return nearest_of<3>(1, {{{1, 0, -1}}});
  const double b = d5 * d2 - d1 * d6;
  if (b <= 0 && d2 >= 0 && d6 <= 0) return nearest_of<3>(2, {{{1, 0, 0}, {0, 0, 1}}});
  const double a = d3 * d6 - d5 * d4;
  if (a <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return nearest_of<3>(2, {{{1, -1, 0}, {0, -1, 1}}});
  return nearest_of<3>(3, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
}

/// Two edges, each clamped to its ends (as before, 5.1.9); parallel ones by their ends.
inline Nearest<3> nearest_of_edges(const Products<3>& g) {
  using pair_distance_detail::nearest_of;
  constexpr double parallel = 1e-10;                                // square of the sine
  const double a = g[3], e = g[5], b = g[4], c = -g[1], f = -g[2];  // by the way back, from the second's corner
  const double span = a * e - b * b;
  double s = span > parallel * a * e ? std::clamp((b * f - c * e) / span, 0.0, 1.0) : 0;
  double t = (b * s + f) / e;
  if (t < 0) {
    t = 0, s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1, s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  const bool s_ends = s <= 0 || s >= 1, t_ends = t <= 0 || t >= 1;
  if (s_ends && t_ends) return nearest_of<3>(1, {{{1, -s, t}}});
  if (s_ends) return nearest_of<3>(2, {{{1, -s, 0}, {0, 0, 1}}});
  if (t_ends) return nearest_of<3>(2, {{{1, 0, t}, {0, 1, 0}}});
  return nearest_of<3>(3, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
}

template <PairKind kind>
Nearest<vector_count(kind)> nearest(const Products<vector_count(kind)>& g) {
  if constexpr (kind == PairKind::corner) {
    return nearest_to_corner();
  } else if constexpr (kind == PairKind::edge) {
    return nearest_on_edge(g);
  } else if constexpr (kind == PairKind::triangle) {
    return nearest_on_triangle(g);
  } else {
    return nearest_of_edges(g);
  }
}

namespace pair_distance_detail {

/// Calls f with how many vectors are used as a constant.
template <int count, class Function>
[[gnu::always_inline]] inline auto with_used(int used, const Function& f) {
  if constexpr (count > 1) {
    if (used < count) return with_used<count - 1>(used, f);
  }
  return f(std::integral_constant<int, count>{});
}

/// The square of the first vector less the part of it that lies along the others.
template <int dim, int used>
[[gnu::always_inline]] inline double squared_across(const SmallMatrix<dim, used>& v) {
  if constexpr (used == 1) return v.squaredNorm();
  if constexpr (used == 2) {
    const double t = v.col(0).dot(v.col(1)) / v.col(1).squaredNorm();
    return (v.col(0) - t * v.col(1)).squaredNorm();
  }
  if constexpr (used == 3) {
    const SmallMatrix<3, 1> n = cross(v.col(1), v.col(2));
    const double across = v.col(0).dot(n);
    return across * across / n.squaredNorm();
  }
}

}  // namespace pair_distance_detail

/// The square of the distance, from the vectors themselves, whose products would leave few digits of a small one
/// [length2].
template <int dim, int count>
double squared_distance(const PairVectors<dim, count>& r, const Nearest<count>& nearest) {
  using namespace pair_distance_detail;
  return with_used<count>(nearest.used, [&](auto n) {
    constexpr int used = decltype(n)::value;
    if constexpr (used == count) return squared_across(r);
    return squared_across<dim, used>(r * nearest.sums.template block<count, used>(0, 0));
  });
}

}  // namespace tether
