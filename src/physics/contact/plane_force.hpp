// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "grid/contact/apart.hpp"
#include "physics/contact/pair_force.hpp"

namespace tether::contact {

/// The derivative of the energy of a place near a plane, with friction, and the derivative of that by the place at the
/// step's end.
template <int dim>
struct PlaneForce {
  SmallMatrix<dim, 1> force = SmallMatrix<dim, 1>::Zero();
  SmallMatrix<dim, dim> slope = SmallMatrix<dim, dim>::Zero();
  double pressing = 0;  ///< size of the force across [force]
  double rubbing = 0;   ///< size of the friction [force]
  double rubbed = 0;    ///< that it takes in the step [energy]
};

/// How far a place is from a plane [length].
template <int dim>
double height_over(const SurfacePlane& plane, const double* x) {
  double away = 0;
  for (int i = 0; i < dim; ++i) away += plane.normal[at(i)] * (x[i] - plane.place[at(i)]);
  return away;
}

/// Coulomb's friction along the plane.
template <int dim>
void add_friction(const PairRule& rule, const SmallMatrix<dim, 1>& n, const SmallMatrix<dim, 1>& way,
                  const SmallMatrix<dim, 1>& by_pressing, PlaneForce<dim>& f) {
  const SmallMatrix<dim, 1> along = way - n * n.dot(way);
  const double size = along.norm(), y = size / rule.come_up, most = rule.friction * f.pressing;
  const double over_way = friction_over_way(y) / rule.come_up;
  const SmallMatrix<dim, 1> rub = most * over_way * along;
  f.force += rub, f.rubbed = rub.dot(along), f.rubbing = rub.norm();
  if (!rule.with_slopes) return;
  f.slope += most * over_way * (SmallMatrix<dim, dim>::Identity() - n * n.transpose());
  if (size > 0)
    f.slope += most * friction_over_way_slope(y) / (rule.come_up * rule.come_up * size) * along * along.transpose();
  f.slope += rub / f.pressing * by_pressing.transpose();
}

/// The distance is linear in the place, so that the discrete gradient is a quotient of energies along the normal. x0
/// and x1 have dim numbers.
template <int dim>
PlaneForce<dim> plane_force(const PairRule& rule, const PairScale& scale, const SurfacePlane& plane, const double* x0,
                            const double* x1) {
  using Vector = SmallMatrix<dim, 1>;
  const double d0 = height_over<dim>(plane, x0), d1 = height_over<dim>(plane, x1);
  const double from_height = rule.at_end ? d1 : d0, s1 = d1 * d1 / scale.gap2;
  const BarrierSlope Q = barrier_quotient(from_height * from_height / scale.gap2, s1);
  const BarrierSlope c = rule.damped ? barrier_damping(s1) : BarrierSlope{};
  const double mean = (from_height + d1) / scale.gap2, pushing = scale.strength * Q.value * mean;
  const double across = d1 - d0, push = pushing + scale.strength * c.value / scale.gap2 * across;
  const Vector n = column_at<dim>(plane.normal.data());
  PlaneForce<dim> f;
  f.force = push * n, f.pressing = std::max(0.0, -push);
  const double by_end = (rule.at_end ? 2 : 1) * scale.strength * (Q.change * 2 * d1 * mean + Q.value) / scale.gap2;
  const double slope = by_end + scale.strength * (c.value + c.change * 2 * d1 * across / scale.gap2) / scale.gap2;
  if (rule.with_slopes) f.slope = slope * n * n.transpose();
  if (rule.friction > 0 && f.pressing > 0)
    add_friction<dim>(rule, n, column_at<dim>(x1) - column_at<dim>(x0), -slope * n, f);
  return f;
}

}  // namespace tether::contact
