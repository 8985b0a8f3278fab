// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "grid/contact/pair_distance.hpp"
#include "laws/barrier.hpp"
#include "physics/contact/pair_rule.hpp"

namespace tether::contact {

/// The forces of one pair between the vectors r0 at a step's start and r1 at its end, whose squared distances are s0
/// and s1 [length2]. The source has those of corners and edges in the plane, and of all kinds in space.
template <PairKind kind, int dim>
PairForce<dim, vector_count(kind)> pair_force(const PairRule& rule, const PairScale& scale,
                                              const PairVectors<dim, vector_count(kind)>& r0,
                                              const PairVectors<dim, vector_count(kind)>& r1, double s0, double s1);

/// A factor of edges that are nearly parallel, whose nearest places leap: c (2 - c) of c = |r2 x r3|^2 / parallel.
inline double fading(double c) { return c < 1 ? c * (2 - c) : 1; }

/// The energy of a pair at a squared distance s.
template <PairKind kind, int dim>
double pair_energy(const PairScale& scale, const PairVectors<dim, vector_count(kind)>& r, double s) {
  double energy = scale.strength * barrier(s / scale.gap2);
  if constexpr (kind == PairKind::edges) energy *= fading(crossing(products_of<dim, 3>(r)) / scale.parallel);
  return energy;
}

}  // namespace tether::contact
