// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

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
using Products = Eigen::Matrix<double, product_count<count>, 1>;
template <int count>
using ProductMap = Eigen::Matrix<double, product_count<count>, product_count<count>>;
template <int dim, int count>
using PairVectors = Eigen::Matrix<double, dim, count>;

/// Place of g_ij among `count` vectors' products, i and j from 0.
constexpr int product_at(int count, int i, int j) {
  const int low = i < j ? i : j, high = i < j ? j : i;
  return low * count - low * (low - 1) / 2 + high - low;
}

template <int dim, int count>
Products<count> products_of(const PairVectors<dim, count>& r) {
  Products<count> g;
  for (int i = 0; i < count; ++i) {
    for (int j = i; j < count; ++j) g[product_at(count, i, j)] = r.col(i).dot(r.col(j));
  }
  return g;
}

/// Where two things are nearest: `used` vectors of the pair, each a sum of the pair's own, say it all, the distance
/// being that of the first from what the others span. `at` are the places along the pair's second and third vector.
template <int count>
struct Nearest {
  int used = 1;
  Eigen::Matrix<double, count, count> sums = Eigen::Matrix<double, count, count>::Zero();  // a row a vector
  std::array<double, 2> at{};
};

namespace pair_distance_detail {

template <int count>
Nearest<count> nearest_of(int used, const std::array<std::array<double, 3>, 3>& sums) {
  Nearest<count> nearest;
  nearest.used = used;
  for (int i = 0; i < used; ++i) {
    for (int j = 0; j < count; ++j) nearest.sums(i, j) = sums[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
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

/// The square of the distance, from the vectors themselves, whose products would leave few digits of a small one
/// [length2].
template <int dim, int count>
double squared_distance(const PairVectors<dim, count>& r, const Nearest<count>& nearest) {
  const PairVectors<dim, count> v = r * nearest.sums.transpose();
  if (nearest.used == 1) return v.col(0).squaredNorm();
  if constexpr (count > 1) {
    if (nearest.used == 2) {
      const double t = v.col(0).dot(v.col(1)) / v.col(1).squaredNorm();
      return (v.col(0) - t * v.col(1)).squaredNorm();
    }
  }
  if constexpr (count > 2 && dim == 3) {
    const Eigen::Vector3d n = Eigen::Vector3d(v.col(1)).cross(Eigen::Vector3d(v.col(2)));
    const double across = v.col(0).dot(n);
    return across * across / n.squaredNorm();
  }
  return 0;
}

/// First and second derivatives of that square by the pair's products, of which it is a function.
template <int count>
struct DistanceSlopes {
  Products<count> first = Products<count>::Zero();
  ProductMap<count> second = ProductMap<count>::Zero();
};

namespace pair_distance_detail {

/// Returns them by the products of the vectors that are used: g11 - M/D, the part of the first one that lies along the
/// others taken off.
inline DistanceSlopes<3> slopes_of_used(int used, const Products<3>& g) {
  DistanceSlopes<3> slopes;
  slopes.first[0] = 1;
  if (used == 1) return slopes;
  double M = g[1] * g[1], D = g[3];
  Products<3> M1 = Products<3>::Zero(), D1 = Products<3>::Zero();
  ProductMap<3> M2 = ProductMap<3>::Zero(), D2 = ProductMap<3>::Zero();
  if (used == 2) {
    M1[1] = 2 * g[1], M2(1, 1) = 2, D1[3] = 1;
  } else {
    M = g[1] * g[1] * g[5] - 2 * g[1] * g[2] * g[4] + g[2] * g[2] * g[3], D = g[3] * g[5] - g[4] * g[4];
    M1 << 0, 2 * (g[1] * g[5] - g[2] * g[4]), 2 * (g[2] * g[3] - g[1] * g[4]), g[2] * g[2], -2 * g[1] * g[2],
        g[1] * g[1];
    D1 << 0, 0, 0, g[5], -2 * g[4], g[3];
    M2.row(1) << 0, 2 * g[5], -2 * g[4], 0, -2 * g[2], 2 * g[1];
    M2.row(2) << 0, -2 * g[4], 2 * g[3], 2 * g[2], -2 * g[1], 0;
    M2(3, 2) = M2(2, 3), M2(4, 1) = M2(1, 4), M2(4, 2) = M2(2, 4), M2(5, 1) = M2(1, 5);
    D2(3, 5) = D2(5, 3) = 1, D2(4, 4) = -2;
  }
  const double part = M / D;
  const Products<3> by = (M1 - part * D1) / D;
  slopes.first -= by;
  slopes.second = -(M2 - by * D1.transpose() - D1 * by.transpose() - part * D2) / D;
  return slopes;
}

}  // namespace pair_distance_detail

/// Products of the vectors that are used, of as many as three, by those of the pair.
template <int count>
Eigen::Matrix<double, 6, product_count<count>> used_products(const Nearest<count>& nearest) {
  Eigen::Matrix<double, 6, product_count<count>> used = decltype(used)::Zero();
  for (int a = 0; a < nearest.used; ++a) {
    for (int b = a; b < nearest.used; ++b) {
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j)
          used(product_at(3, a, b), product_at(count, i, j)) += nearest.sums(a, i) * nearest.sums(b, j);
      }
    }
  }
  return used;
}

template <int count>
DistanceSlopes<count> distance_slopes(const Products<count>& g, const Nearest<count>& nearest) {
  const auto used = used_products<count>(nearest);
  const DistanceSlopes<3> slopes = pair_distance_detail::slopes_of_used(nearest.used, used * g);
  return {used.transpose() * slopes.first, used.transpose() * slopes.second * used};
}

/// The way from one nearest place to the other as a sum of the pair's vectors, and how its parts change with the
/// products.
template <int count>
struct NearestWay {
  Eigen::Matrix<double, count, 1> parts;
  Eigen::Matrix<double, count, product_count<count>> slopes = decltype(slopes)::Zero();
};

template <int count>
NearestWay<count> nearest_way(const Products<count>& g, const Nearest<count>& nearest) {
  NearestWay<count> way;
  way.parts = nearest.sums.row(0).transpose();
  if (nearest.used == 1) return way;
  const auto used = used_products<count>(nearest);
  const Eigen::Matrix<double, 6, 1> p = used * g;
  if (nearest.used == 2) {
    const double t = p[1] / p[3];
    way.parts -= t * nearest.sums.row(1).transpose();
    way.slopes = -nearest.sums.row(1).transpose() * (used.row(1) - t * used.row(3)) / p[3];
    return way;
  }
  const Eigen::Matrix2d inverse =
      (Eigen::Matrix2d() << p[5], -p[4], -p[4], p[3]).finished() / (p[3] * p[5] - p[4] * p[4]);
  const Eigen::Vector2d t = inverse * Eigen::Vector2d(p[1], p[2]);
  Eigen::Matrix<double, 2, product_count<count>> by;
  by.row(0) = used.row(1) - t[0] * used.row(3) - t[1] * used.row(4);
  by.row(1) = used.row(2) - t[0] * used.row(4) - t[1] * used.row(5);
  const auto others = nearest.sums.template bottomRows<count - 1>().transpose();
  if constexpr (count == 3) {
    way.parts -= others * t;
    way.slopes = -others * inverse * by;
  }
  return way;
}

}  // namespace tether
