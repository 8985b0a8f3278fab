// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "grid/contact/pair_distance.hpp"
#include "laws/barrier.hpp"
#include "physics/contact/pair_losses.hpp"
#include "physics/contact/pair_rule.hpp"

namespace tether::contact {

// The forces of one pair between the vectors r0 at a step's start and r1 at its end, by a discrete gradient in the
// pair's products g (O. Gonzalez, Comput. Methods Appl. Mech. Engrg 190 (2000) 1763-1783): what depends on products
// alone gives momentum and angular momentum nothing, and as the gradient is the difference of the energies over the
// step, the energy is that of the potential whatever the step.

/// A factor of edges that are nearly parallel, whose nearest places leap: c (2 - c) of c = |r2 x r3|^2 / parallel.
inline double fading(double c) { return c < 1 ? c * (2 - c) : 1; }
/// (fading(c1) - fading(c0)) / (c1 - c0)
inline BarrierSlope fading_quotient(double c0, double c1) {
  if (c0 >= 1 && c1 >= 1) return {};
  if (c0 < 1 && c1 < 1) return {2 - c0 - c1, -1};
  const double way = c1 - c0, value = (fading(c1) - fading(c0)) / way;
  return {value, ((c1 < 1 ? 2 - 2 * c1 : 0) - value) / way};
}

/// |r2 x r3|^2 and its derivative.
inline double crossing(const Products<3>& g) { return g[3] * g[5] - g[4] * g[4]; }
inline Products<3> crossing_slope(const Products<3>& g) {
  return (Products<3>() << 0, 0, 0, g[5], -2 * g[4], g[3]).finished();
}

/// The discrete gradient of the squared distance by the products, and its derivative by those of the end.
template <int count>
struct DistanceGradient {
  Products<count> value;
  ProductMap<count> slope;
};

/// The products at a step's ends, and their change, which is known to its own digits, not to theirs.
template <int count>
struct ProductsOfStep {
  Products<count> start, end, change;
};

template <int dim, int count>
ProductsOfStep<count> products_of_step(const PairVectors<dim, count>& r0, const PairVectors<dim, count>& r1) {
  ProductsOfStep<count> g{products_of<dim, count>(r0), products_of<dim, count>(r1), {}};
  const PairVectors<dim, count> middle = 0.5 * (r0 + r1), way = r1 - r0;
  for (int i = 0; i < count; ++i) {
    for (int j = i; j < count; ++j)
      g.change[product_at(count, i, j)] = middle.col(i).dot(way.col(j)) + way.col(i).dot(middle.col(j));
  }
  return g;
}

/// The mean of the gradient over the way, by Gauss' rule with three points: of short ways it is a discrete gradient to
/// all digits, where differences over the way would be rounding.
template <PairKind kind>
DistanceGradient<vector_count(kind)> mean_gradient(const ProductsOfStep<vector_count(kind)>& g) {
  constexpr int count = vector_count(kind);
  DistanceGradient<count> gradient{Products<count>::Zero(), ProductMap<count>::Zero()};
  const double off = 0.5 * std::sqrt(0.6);
  for (const auto& [at, weight] : {std::pair{0.5 - off, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + off, 5.0 / 18}}) {
    const Products<count> there = g.start + at * g.change;
    const DistanceSlopes<count> slopes = distance_slopes<count>(there, nearest<kind>(there));
    gradient.value += weight * slopes.first, gradient.slope += weight * at * slopes.second;
  }
  return gradient;
}

/// Returns whether the same vectors say what is nearest.
template <int count>
bool alike(const Nearest<count>& a, const Nearest<count>& b) {
  return a.used == b.used && (a.sums - b.sums).cwiseAbs().maxCoeff() < 1e-9;
}

template <PairKind kind>
DistanceGradient<vector_count(kind)> distance_gradient(const ProductsOfStep<vector_count(kind)>& g, double way,
                                                       bool with_slopes) {
  constexpr int count = vector_count(kind);
  constexpr double short_way = 1e-4, none = 1e-12;  // of the products' squares
  const Products<count> middle = 0.5 * (g.start + g.end);
  const double size2 = g.change.squaredNorm(), all = middle.squaredNorm();
  const auto in_middle = nearest<kind>(middle);
  if (size2 <= short_way * all) {
    if (size2 <= none * all || (alike(in_middle, nearest<kind>(g.start)) && alike(in_middle, nearest<kind>(g.end))))
      return mean_gradient<kind>(g);
  }
  const DistanceSlopes<count> there = distance_slopes<count>(middle, in_middle);
  DistanceGradient<count> gradient{there.first, 0.5 * there.second};
  const double lacking = (way - there.first.dot(g.change)) / size2;
  gradient.value += lacking * g.change;
  if (!with_slopes) return gradient;
  const Products<count> at_end = distance_slopes<count>(g.end, nearest<kind>(g.end)).first;
  const Products<count> by =
      (at_end - there.first - 0.5 * there.second.transpose() * g.change - 2 * lacking * g.change) / size2;
  gradient.slope += g.change * by.transpose();
  for (int k = 0; k < product_count<count>; ++k) gradient.slope(k, k) += lacking;
  return gradient;
}

/// Derivative of the energy by the products between both ends, and its derivative by those of the end.
template <PairKind kind>
DistanceGradient<vector_count(kind)> energy_gradient(const PairRule& rule, const PairScale& scale,
                                                     const ProductsOfStep<vector_count(kind)>& g, double s0,
                                                     double s1) {
  const auto &g0 = g.start, &g1 = g.end;
  const double a = s0 / scale.gap2, b = s1 / scale.gap2, strength = scale.strength;
  const BarrierSlope Q = barrier_quotient(a, b);
  DistanceGradient<vector_count(kind)> e = distance_gradient<kind>(g, s1 - s0, rule.with_slopes);
  const auto s1_slope = distance_slopes<vector_count(kind)>(g1, nearest<kind>(g1)).first;
  const auto distance = e.value;
  const double slope = strength * Q.value / scale.gap2, change = strength * Q.change / (scale.gap2 * scale.gap2);
  e.value *= slope;
  e.slope = slope * e.slope + change * distance * s1_slope.transpose();
  if constexpr (kind == PairKind::edges) {
    const double c0 = crossing(g0) / scale.parallel, c1 = crossing(g1) / scale.parallel;
    const double factor = 0.5 * (fading(c0) + fading(c1)), mean = 0.5 * strength * (barrier(a) + barrier(b));
    const BarrierSlope F = fading_quotient(c0, c1);
    const Products<3> D = crossing_slope(0.5 * (g0 + g1)) / scale.parallel, D1 = crossing_slope(g1) / scale.parallel;
    const Products<3> barrier1 = strength * barrier_slope(b) / scale.gap2 * s1_slope;
    const Products<3> fading1 = (c1 < 1 ? 2 - 2 * c1 : 0) * D1;
    e.slope = factor * e.slope + 0.5 * e.value * fading1.transpose() + F.value * D * 0.5 * barrier1.transpose() +
              mean * F.change * D * D1.transpose();
    e.slope(3, 5) += 0.5 * mean * F.value / scale.parallel, e.slope(5, 3) += 0.5 * mean * F.value / scale.parallel;
    e.slope(4, 4) -= mean * F.value / scale.parallel;
    e.value = factor * e.value + mean * F.value * D;
  }
  return e;
}

/// s0 and s1 are the squared distances at both ends [length2].
template <PairKind kind, int dim>
PairForce<dim, vector_count(kind)> pair_force(const PairRule& rule, const PairScale& scale,
                                              const PairVectors<dim, vector_count(kind)>& r0,
                                              const PairVectors<dim, vector_count(kind)>& r1, double s0, double s1) {
  constexpr int count = vector_count(kind);
  const PairVectors<dim, count>& from = rule.at_end ? r1 : r0;
  const auto e = energy_gradient<kind>(rule, scale, products_of_step<dim, count>(from, r1), rule.at_end ? s1 : s0, s1);
  const PairVectors<dim, count> middle = 0.5 * (from + r1);
  const auto by_middle = products_by_vectors<dim, count>(middle), by_end = products_by_vectors<dim, count>(r1);
  PairForce<dim, count> f;
  const Eigen::Matrix<double, dim * count, 1> force = by_middle * e.value;
  f.force = Eigen::Map<const PairVectors<dim, count>>(force.data());
  if (rule.with_slopes) {
    f.slope = by_middle * e.slope * by_end.transpose();
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const double part = (i == j ? 1 : 0.5) * e.value[product_at(count, i, j)];
        for (int k = 0; k < dim; ++k) f.slope(i * dim + k, j * dim + k) += part;
      }
    }
    if (rule.at_end) f.slope *= 2;  // the gradient between two ends depends on both alike
  }
  f.pressing = f.force.col(0).norm();
  if (f.pressing == 0 || (rule.friction <= 0 && !rule.damped)) return f;
  Passing<dim, count> passing = passing_of<kind, dim>(r0, r1, f, rule.with_slopes);
  if (rule.damped) {
    const Products<count> g1 = products_of<dim, count>(r1);
    const Eigen::Matrix<double, 1, dim* count> s1_slope =
        (by_end * distance_slopes<count>(g1, nearest<kind>(g1)).first).transpose();
    add_damping<dim, count>(rule, scale, s1, s1_slope, passing, f);
  }
  f.pressing = passing.pressing, f.slid = passing.way.norm();
  if (rule.friction > 0) add_friction<dim, count>(rule, scale.strength < 0 ? -1 : 1, passing, f);
  return f;
}

/// The energy of a pair at a squared distance s.
template <PairKind kind, int dim>
double pair_energy(const PairScale& scale, const PairVectors<dim, vector_count(kind)>& r, double s) {
  double energy = scale.strength * barrier(s / scale.gap2);
  if constexpr (kind == PairKind::edges) energy *= fading(crossing(products_of<dim, 3>(r)) / scale.parallel);
  return energy;
}

}  // namespace tether::contact
