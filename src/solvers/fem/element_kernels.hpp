// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "laws/materials/hyperelastic.hpp"
#include "solvers/fem/elements.hpp"

// What a step does at one point of quadrature, from the deformation gradients at the step's start and end. Templates
// chosen once a run; nothing here allocates.

namespace tether::fem {

template <int dim>
using Square = Eigen::Matrix<double, dim, dim>;

/// At a point: f_A += w A S grad N_A, with tangent w [a (grad N_A . S grad N_B) 1 + B_A(A)^T D B_B(F)], where B(F) maps
/// a change of place to the change of E = (F^T F - 1)/2, shears counted twice.
template <int dim>
struct PointStress {
  Square<dim> A, F;
  Symmetric<dim> S;
  SymmetricMap<dim> D;
  double geometric = 0;  // a
};

template <int dim>
Symmetric<dim> right_cauchy_green(const Square<dim>& F) {
  return symmetric<dim>((F.transpose() * F).eval());
}

/// Gonzalez' stress between C0 and C1 and its derivative by C1 (O. Gonzalez, Comput. Methods Appl. Mech. Engrg 190
/// (2000) 1763-1783): S_m + s dC with s such that S : dC / 2 is the difference of the energies. Below |dC|^2 = 1e-24
/// the quotient is all rounding and its limit, S_m, is taken.
template <int dim, class Respond>
void discrete_gradient(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const Respond& respond,
                       PointStress<dim>& at) {
  constexpr double too_small = 1e-24;
  const Response<dim> middle = respond(Symmetric<dim>(0.5 * (C0 + C1)));
  const Symmetric<dim> dC = C1 - C0;
  const double dC2 = contract<dim>(dC, dC);
  at.S = middle.S, at.D = 0.5 * middle.D;
  if (dC2 < too_small) return;
  const Response<dim> end = respond(C1);
  const double s = (2 * (end.energy - respond(C0).energy) - contract<dim>(middle.S, dC)) / dC2;
  const Symmetric<dim> w = contraction_weights<dim>();
  // ds by dE1, shears twice: dC1 = 2 dE1
  const Symmetric<dim> ds =
      (2 * (end.S - middle.S) - 4 * s * dC - 0.5 * middle.D.transpose() * w.cwiseProduct(dC)) / dC2;
  at.S += s * dC;
  at.D += dC * ds.transpose();
  for (int k = 0; k < component_count<dim>(); ++k) at.D(k, k) += 2 * s / w[k];
}

/// A law of finite strains by the chosen rule; `respond` answers C.
template <int dim, StressAt rule, class Respond>
PointStress<dim> finite_stress(const Square<dim>& F0, const Square<dim>& F1, const Respond& respond) {
  PointStress<dim> at;
  if constexpr (rule == StressAt::end) {
    const Response<dim> end = respond(right_cauchy_green<dim>(F1));
    at = {F1, F1, end.S, end.D, 1};
  } else {
    const Square<dim> middle = 0.5 * (F0 + F1);
    at.A = middle, at.geometric = 0.5;
    if constexpr (rule == StressAt::middle) {
      const Response<dim> there = respond(right_cauchy_green<dim>(middle));
      at.F = middle, at.S = there.S, at.D = 0.5 * there.D;
    } else {
      at.F = F1;
      discrete_gradient<dim>(right_cauchy_green<dim>(F0), right_cauchy_green<dim>(F1), respond, at);
    }
  }
  return at;
}

/// The linear law: its energy is quadratic, so that the middle is the discrete gradient, too.
template <int dim, StressAt rule>
PointStress<dim> linear_stress(const Square<dim>& F0, const Square<dim>& F1, const LinearElastic& linear) {
  const bool end = rule == StressAt::end;
  const Square<dim> F = end ? F1 : Square<dim>(0.5 * (F0 + F1)), one = Square<dim>::Identity();
  const Response<dim> there = linear.law.respond<dim>(symmetric<dim>((F + F.transpose() - one).eval()));  // 1 + 2 eps
  return {one, one, there.S, end ? there.D : SymmetricMap<dim>(0.5 * there.D), 0};
}

/// The stress of any law at the reference place X, Y.
template <int dim, StressAt rule>
PointStress<dim> point_stress(const ElasticLaw& law, const Square<dim>& F0, const Square<dim>& F1, double X, double Y) {
  if (const auto* linear = std::get_if<LinearElastic>(&law)) return linear_stress<dim, rule>(F0, F1, *linear);
  if (const auto* svk = std::get_if<StVenantKirchhoff>(&law))
    return finite_stress<dim, rule>(F0, F1, [&](const Symmetric<dim>& C) { return svk->respond<dim>(C); });
  if (const auto* neo = std::get_if<NeoHookean>(&law))
    return finite_stress<dim, rule>(F0, F1, [&](const Symmetric<dim>& C) { return neo->respond<dim>(C); });
  const auto& fibre = *std::get_if<HoopFibre>(&law);
  return finite_stress<dim, rule>(F0, F1, [&](const Symmetric<dim>& C) { return fibre.respond<dim>(C, X, Y); });
}

/// Energy density and second Piola-Kirchhoff stress at F.
template <int dim>
Response<dim> response_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y) {
  const Symmetric<dim> C = right_cauchy_green<dim>(F);
  if (const auto* linear = std::get_if<LinearElastic>(&law))
    return linear->law.respond<dim>(symmetric<dim>((F + F.transpose() - Square<dim>::Identity()).eval()));
  if (const auto* svk = std::get_if<StVenantKirchhoff>(&law)) return svk->respond<dim>(C);
  if (const auto* neo = std::get_if<NeoHookean>(&law)) return neo->respond<dim>(C);
  return std::get_if<HoopFibre>(&law)->respond<dim>(C, X, Y);
}

/// B_A(F): change of E (shears twice) by the place of a node whose shape function has the gradient g.
template <int dim>
Eigen::Matrix<double, component_count<dim>(), dim> strain_map(const Square<dim>& F,
                                                              const Eigen::Matrix<double, dim, 1>& g) {
  Eigen::Matrix<double, component_count<dim>(), dim> B;
  for (int i = 0; i < dim; ++i) {
    for (int k = 0; k < dim; ++k) B(k, i) = F(i, k) * g[k];
    if constexpr (dim == 2) {
      B(2, i) = F(i, 0) * g[1] + F(i, 1) * g[0];
    } else {
      B(3, i) = F(i, 0) * g[1] + F(i, 1) * g[0];
      B(4, i) = F(i, 1) * g[2] + F(i, 2) * g[1];
      B(5, i) = F(i, 0) * g[2] + F(i, 2) * g[0];
    }
  }
  return B;
}

}  // namespace tether::fem
