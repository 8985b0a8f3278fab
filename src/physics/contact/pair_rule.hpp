// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "grid/contact/pair_distance.hpp"

namespace tether::contact {

/// What the forces of pairs are made of, one for all of a step.
struct PairRule {
  bool at_end = false;       ///< forces are those of the step's end: an equilibrium's
  bool damped = false;       ///< what comes nearer or parts is damped
  double friction = 0;       ///< Coulomb's coefficient
  double come_up = 1;        ///< way in a step over which friction comes up [length]
  bool with_slopes = false;  ///< whether the derivative is asked
};

/// A pair's energy is strength times barrier(squared distance / gap2).
struct PairScale {
  double strength = 0;  ///< [energy], negative of what other pairs count twice
  double gap2 = 1;      ///< [length2]
  double parallel = 0;  ///< of edges: the square of their cross product below which the energy fades [length4]
};

/// The derivative of a pair's energy by its vectors: forces, a column a vector, with what friction does; and the
/// derivative of these by the vectors at the end.
template <int dim, int count>
struct PairForce {
  PairVectors<dim, count> force = PairVectors<dim, count>::Zero();
  Eigen::Matrix<double, dim * count, dim* count> slope = decltype(slope)::Zero();
  double pressing = 0;  ///< size of the force across [force]
  double rubbed = 0;    ///< that friction takes in the step [energy]
  double slid = 0;      ///< way of the nearest places past each other, where it was asked [length]
  double rubbing = 0;   ///< size of the friction [force]
};

/// The derivative of products by vectors: column g_ij has r_j for vector i and r_i for vector j.
template <int dim, int count>
Eigen::Matrix<double, dim * count, product_count<count>> products_by_vectors(const PairVectors<dim, count>& r) {
  Eigen::Matrix<double, dim * count, product_count<count>> by = decltype(by)::Zero();
  for (int i = 0; i < count; ++i) {
    for (int j = i; j < count; ++j) {
      by.template block<dim, 1>(i * dim, product_at(count, i, j)) += r.col(j);
      by.template block<dim, 1>(j * dim, product_at(count, i, j)) += r.col(i);
    }
  }
  return by;
}

}  // namespace tether::contact
