// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "base/vec.hpp"
#include "physics/solids/dilatation_modes.hpp"
#include "physics/solids/elements.hpp"

namespace tether::fem {

// Elements whose law sees, in place of the dilatation J = det F at a point, the mean of it over the element, so that a
// material which hardly changes its volume binds each element by one condition (or few), not by one a point: F^ =
// (J-/J)^(1/dim) F goes into any law. With the volumetric and the isochoric part of a law apart these are the elements
// of mean dilatation (J. C. Simo, R. L. Taylor and K. S. Pister, Comput. Methods Appl. Mech. Engrg 51 (1985) 177-208);
// in this form they are those of E. A. de Souza Neto et al. (Int. J. Solids Structures 33 (1996) 3277-3296), here with
// the stress that belongs to the energy sum of w Psi(C^), so that forces have a potential.
//
// The step of the discrete gradient keeps that energy as the plain one does: C^ = r C, r = (J-/J)^(2/dim), and each
// difference of a step is a product of a mean and a difference, down to dC,
//   dC^ = r_m dC + C_m dr,  dr = rho d(J-/J),  d(J-/J) = (J_m dJ- - J-_m dJ)/(J0 J1),  dJ = P : dC,
// with P the discrete derivative of J (P. Betsch, A. Janz and C. Hesch, Comput. Methods Appl. Mech. Engrg 335 (2018)
// 660-696, have that of det C). The mean is J-_k = sum_l Pi_kl J_l, w_k Pi_kl symmetric; from S^ : dC^ follows
//   S_k = r_m S^_k + g_k P_k,  g_k = sum_l Pi_kl alpha_l - sigma_k J-_m,
//   sigma = rho S^ : C_m/(J0 J1),  alpha = sigma J_m.
//
// What the mean leaves out has an energy of its own, c (J - J-)^2/2, where that is too little to resist bending
// (model/dilatation.hpp).

/// The stress at a point, and how it changes: dS = D dE + v dJ- + P dg', g' = sum_l Pi_kl alpha_l, where dJ = j : dE
/// and dalpha = a : dE + b dJ- at each point. s.D is D.
template <int dim>
struct DilatedPoint {
  PointStress<dim> s;
  Symmetric<dim> P, j, a, v;
  double b = 0;
};

/// Numbers of points that an element has at most.
constexpr std::size_t most_points = 27;

/// Computes the stresses at all points of an element by a step's rule, as point_stress() does for one, F0 and F1 of
/// each and X, Y where it is at the start. What is asked for tangents is set where `with_modulus` says.
template <int dim>
void dilated_stresses(StressAt rule, const ElasticLaw& law, std::span<const Square<dim>> F0,
                      std::span<const Square<dim>> F1, std::span<const Vec<2>> places, const DilatationModes& modes,
                      bool with_modulus, std::span<DilatedPoint<dim>> out);

/// F -> F^ at all points, which laws take in place of F. Where `left_out` is given, it is set to J - J-: c times that
/// is a stress in the plane, or in space, and c/2 times its square an energy density, besides those of the law.
template <int dim>
void take_mean_dilatation(const ElasticLaw& law, const DilatationModes& modes, std::span<Square<dim>> F,
                          std::span<double> left_out = {});

}  // namespace tether::fem
