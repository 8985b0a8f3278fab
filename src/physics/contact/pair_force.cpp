// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/pair_force.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grid/contact/distance_slopes.hpp"
#include "physics/contact/pair_losses.hpp"

namespace tether::contact {

// The forces of one pair by a discrete gradient between a step's start and its end in the pair's products g (O.
// Gonzalez, Comput. Methods Appl. Mech. Engrg 190 (2000) 1763-1783): what depends on products alone gives momentum and
// angular momentum nothing, and as the gradient is the difference of the energies over the step, the energy is that of
// the potential whatever the step.

namespace {

/// (fading(c1) - fading(c0)) / (c1 - c0)
BarrierSlope fading_quotient(double c0, double c1) {
  if (c0 >= 1 && c1 >= 1) return {};
  if (c0 < 1 && c1 < 1) return {2 - c0 - c1, -1};
  const double way = c1 - c0, value = (fading(c1) - fading(c0)) / way;
  return {value, ((c1 < 1 ? 2 - 2 * c1 : 0) - value) / way};
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
  if (a.used != b.used) return false;
  for (int i = 0; i < a.used; ++i) {
    for (int j = 0; j < count; ++j) {
      if (!(std::abs(a.sums(j, i) - b.sums(j, i)) < 1e-9)) return false;
    }
  }
  return true;
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
  const Products<count> at_end = distance_slope<count>(g.end, nearest<kind>(g.end));
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
  const auto s1_slope = distance_slope<vector_count(kind)>(g1, nearest<kind>(g1));
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

}  // namespace

template <PairKind kind, int dim>
PairForce<dim, vector_count(kind)> pair_force(const PairRule& rule, const PairScale& scale,
                                              const PairVectors<dim, vector_count(kind)>& r0,
                                              const PairVectors<dim, vector_count(kind)>& r1, double s0, double s1) {
  constexpr int count = vector_count(kind);
  const PairVectors<dim, count>& from = rule.at_end ? r1 : r0;
  const auto e = energy_gradient<kind>(rule, scale, products_of_step<dim, count>(from, r1), rule.at_end ? s1 : s0, s1);
  const PairVectors<dim, count> middle = 0.5 * (from + r1);
  PairForce<dim, count> f;
  const auto force = by_vectors<dim, count>(e.value.transpose(), middle);
  for (int k = 0; k < count; ++k) f.force.col(k) = force.template block<1, dim>(0, k * dim).transpose();
  if (rule.with_slopes) {
    f.slope = by_vectors<dim, count>(by_vectors<dim, count>(e.slope.transpose(), middle).transpose(), r1);
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
    const auto s1_slope = by_vectors<dim, count>(distance_slope<count>(g1, nearest<kind>(g1)).transpose(), r1);
    add_damping<dim, count>(rule, scale, s1, s1_slope, passing, f);
  }
  f.pressing = passing.pressing, f.slid = passing.way.norm();
  if (rule.friction > 0) add_friction<dim, count>(rule, scale.strength < 0 ? -1 : 1, passing, f);
  return f;
}

template PairForce<2, 1> pair_force<PairKind::corner, 2>(const PairRule&, const PairScale&, const PairVectors<2, 1>&,
                                                         const PairVectors<2, 1>&, double, double);
template PairForce<2, 2> pair_force<PairKind::edge, 2>(const PairRule&, const PairScale&, const PairVectors<2, 2>&,
                                                       const PairVectors<2, 2>&, double, double);
template PairForce<3, 1> pair_force<PairKind::corner, 3>(const PairRule&, const PairScale&, const PairVectors<3, 1>&,
                                                         const PairVectors<3, 1>&, double, double);
template PairForce<3, 2> pair_force<PairKind::edge, 3>(const PairRule&, const PairScale&, const PairVectors<3, 2>&,
                                                       const PairVectors<3, 2>&, double, double);
template PairForce<3, 3> pair_force<PairKind::triangle, 3>(const PairRule&, const PairScale&, const PairVectors<3, 3>&,
                                                           const PairVectors<3, 3>&, double, double);
template PairForce<3, 3> pair_force<PairKind::edges, 3>(const PairRule&, const PairScale&, const PairVectors<3, 3>&,
                                                        const PairVectors<3, 3>&, double, double);

}  // namespace tether::contact
