// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  SmallMatrix<dim * count, dim* count> slope = decltype(slope)::Zero();
  double pressing = 0;  ///< size of the force across [force]
  double rubbed = 0;    ///< that friction takes in the step [energy]
  double slid = 0;      ///< way of the nearest places past each other, where it was asked [length]
  double rubbing = 0;   ///< size of the friction [force]
};

/// Returns the derivatives of numbers by vectors, a row a number, from those by the vectors' products: g_ij = r_i . r_j
/// changes by r_j with vector i and by r_i with vector j.
template <int dim, int count, class A, int rows>
SmallMatrix<rows, dim * count> by_vectors(const MatrixEntries<A, rows, product_count<count>>& by_products,
                                          const PairVectors<dim, count>& r) {
  auto by = SmallMatrix<rows, dim * count>::Zero();
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const int product = product_at(count, i, j);
      for (int k = 0; k < dim; ++k) {
        const double change = i == j ? 2 * r(k, i) : r(k, j);
        for (int row = 0; row < rows; ++row) by(row, i * dim + k) += by_products(row, product) * change;
      }
    }
  }
  return by;
}

}  // namespace tether::contact
