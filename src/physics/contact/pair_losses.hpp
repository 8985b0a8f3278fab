// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "grid/contact/distance_slopes.hpp"
#include "laws/barrier.hpp"
#include "physics/contact/pair_rule.hpp"

namespace tether::contact {

// What takes energy from a pair in a step: friction along, and damping across where contact is damped.

/// How the nearest places of a pair pass each other in a step, where they lie in its middle: u = sum of parts_k (r1_k -
/// r0_k), and n along the force across; and how both change with the vectors at the end.
template <int dim, int count>
struct Passing {
  static constexpr int unknowns = dim * count;
  SmallMatrix<count, 1> parts;
  SmallMatrix<dim, 1> way, n;
  SmallMatrix<count, unknowns> parts_slope;
  SmallMatrix<dim, 1> apart;  ///< from one nearest place to the other, in the middle
  SmallMatrix<dim, unknowns> way_slope, n_slope, apart_slope;
  double pressing = 0;  ///< force across, with what is damped; 0 where that would pull [force]
  SmallMatrix<1, unknowns> pressing_slope;
};

template <PairKind kind, int dim>
Passing<dim, vector_count(kind)> passing_of(const PairVectors<dim, vector_count(kind)>& r0,
                                            const PairVectors<dim, vector_count(kind)>& r1,
                                            const PairForce<dim, vector_count(kind)>& f, bool with_slopes) {
  constexpr int count = vector_count(kind), unknowns = dim * count;
  using Square = SmallMatrix<dim, dim>;
  const PairVectors<dim, count> ways = r1 - r0;
  const Products<count> g = 0.5 * (products_of<dim, count>(r0) + products_of<dim, count>(r1));
  const NearestWay<count> at = nearest_way<count>(g, nearest<kind>(g));
  Passing<dim, count> passing;
  passing.parts = at.parts, passing.way = ways * at.parts, passing.n = f.force.col(0) / f.pressing;
  const PairVectors<dim, count> middle = 0.5 * (r0 + r1);
  passing.pressing = f.pressing, passing.apart = middle * at.parts;
  if (!with_slopes) return passing;
  const SmallMatrix<dim, unknowns> pressing = f.slope.template block<dim, unknowns>(0, 0);
  passing.n_slope = (Square::Identity() - passing.n * passing.n.transpose()) * pressing / f.pressing;
  passing.pressing_slope = passing.n.transpose() * pressing;
  passing.parts_slope = by_vectors<dim, count>(0.5 * at.slopes, r1);
  passing.way_slope = ways * passing.parts_slope, passing.apart_slope = middle * passing.parts_slope;
  for (int k = 0; k < count; ++k) {
    passing.way_slope.template block<dim, dim>(0, k * dim) += at.parts[k] * Square::Identity();
    passing.apart_slope.template block<dim, dim>(0, k * dim) += 0.5 * at.parts[k] * Square::Identity();
  }
  return passing;
}

/// Adds a force at the nearest places, against their way, and its derivative.
template <int dim, int count>
void add_against(const Passing<dim, count>& passing, const SmallMatrix<dim, 1>& force,
                 const SmallMatrix<dim, dim * count>& slope, bool with_slopes, PairForce<dim, count>& f) {
  f.force += force * passing.parts.transpose();
  if (!with_slopes) return;
  for (int k = 0; k < count; ++k)
    f.slope.template block<dim, dim * count>(k * dim, 0) +=
        passing.parts[k] * slope + force * passing.parts_slope.row(k);
}

/// Coulomb's friction: -mu N friction(|u_t|) u_t/|u_t|, u_t the way less its part across.
template <int dim, int count>
void add_friction(const PairRule& rule, double sign, const Passing<dim, count>& passing, PairForce<dim, count>& f) {
  using Vector = SmallMatrix<dim, 1>;
  using Square = SmallMatrix<dim, dim>;
  if (passing.pressing == 0) return;
  const Vector &n = passing.n, along = passing.way - n * n.dot(passing.way);
  const double size = along.norm(), y = size / rule.come_up, most = sign * rule.friction * passing.pressing;
  const double over_way = friction_over_way(y) / rule.come_up;
  const Vector rub = most * over_way * along;
  SmallMatrix<dim, dim * count> slope;
  if (rule.with_slopes) {
    Square by_along = most * over_way * Square::Identity();
    if (size > 0)
      by_along += most * friction_over_way_slope(y) / (rule.come_up * rule.come_up * size) * along * along.transpose();
    slope = by_along * (passing.way_slope - n * (n.transpose() * passing.way_slope) -
                        n.dot(passing.way) * passing.n_slope - n * (passing.way.transpose() * passing.n_slope)) +
            rub / passing.pressing * passing.pressing_slope;
  }
  f.rubbed = rub.dot(passing.way), f.rubbing = rub.norm();
  add_against<dim, count>(passing, rub, slope, rule.with_slopes, f);
}

/// Damping of the way across, which only the nearest thing to a point is asked for: bodies that slide over a mesh would
/// lose energy from facet to facet. `s1_slope` is the derivative of the squared distance at the end by the vectors.
template <int dim, int count>
void add_damping(const PairRule& rule, const PairScale& scale, double s1, const SmallMatrix<1, dim * count>& s1_slope,
                 Passing<dim, count>& passing, PairForce<dim, count>& f) {
  using Row = SmallMatrix<1, dim * count>;
  const BarrierSlope c = barrier_damping(s1 / scale.gap2);
  const double size = scale.strength * c.value / scale.gap2, apart = passing.apart.norm();
  if (apart == 0) return;
  const SmallMatrix<dim, 1> n = passing.apart / apart;
  const double across = n.dot(passing.way);
  SmallMatrix<dim, dim * count> slope;
  if (rule.with_slopes) {
    const SmallMatrix<dim, dim* count> n_slope =
        (passing.apart_slope - n * (n.transpose() * passing.apart_slope)) / apart;
    const Row by_across = passing.way.transpose() * n_slope + n.transpose() * passing.way_slope;
    const Row by_size = scale.strength * c.change / (scale.gap2 * scale.gap2) * s1_slope;
    slope = size * (n * by_across + across * n_slope) + across * n * by_size;
    passing.pressing_slope -= size * by_across + across * by_size;
  }
  passing.pressing = std::max(0.0, passing.pressing - size * across);
  add_against<dim, count>(passing, size * across * n, slope, rule.with_slopes, f);
}

}  // namespace tether::contact
