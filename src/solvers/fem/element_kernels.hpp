// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <type_traits>
#include <variant>

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

/// What a law answers to at F: C, or 1 + 2 eps if it is one of small strains.
template <bool small_strains, int dim>
Symmetric<dim> strain_of(const Square<dim>& F) {
  if constexpr (small_strains) {
    return symmetric<dim>((F + F.transpose() - Square<dim>::Identity()).eval());
  } else {
    return right_cauchy_green<dim>(F);
  }
}

/// What the middle stress lacks along dC to do the work of the energies' difference: s = (2 (Psi1 - Psi0) - S_m : dC) /
/// (dC : dC). For small dC that quotient is all rounding; there the difference is the integral of S : dC / 2 by two
/// points of Gauss, exact but for |dC|^5.
template <int dim, class Respond>
double lacking_stress(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const Symmetric<dim>& middle, double dC2,
                      const Respond& respond) {
  constexpr double small = 1e-6, gauss = 0.21132486540518711775;
  const Symmetric<dim> dC = C1 - C0;
  if (dC2 > small) return (2 * (respond(C1).energy - respond(C0).energy) - contract<dim>(middle, dC)) / dC2;
  const Symmetric<dim> before = respond(Symmetric<dim>(C0 + gauss * dC)).S,
                       behind = respond(Symmetric<dim>(C1 - gauss * dC)).S;
  return contract<dim>(Symmetric<dim>(0.5 * ((before - middle) + (behind - middle))), dC) / dC2;
}

/// Gonzalez' stress between C0 and C1 and its derivative by C1 (O. Gonzalez, Comput. Methods Appl. Mech. Engrg 190
/// (2000) 1763-1783): S_m + s dC. Steps so small that s dC is below rounding do without it, their tangent sooner: what
/// it has of dC is of no use to Newton's method then.
template <int dim, class Respond>
void discrete_gradient(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const Respond& respond,
                       PointStress<dim>& at) {
  constexpr double no_stress = 1e-16, no_tangent = 1e-12;  // of |dC|^2
  const Response<dim> middle = respond(Symmetric<dim>(0.5 * (C0 + C1)));
  const Symmetric<dim> dC = C1 - C0;
  const double dC2 = contract<dim>(dC, dC);
  at.S = middle.S, at.D = 0.5 * middle.D;
  if (dC2 < no_stress) return;
  const double s = lacking_stress<dim>(C0, C1, middle.S, dC2, respond);
  at.S += s * dC;
  if (dC2 < no_tangent) return;
  const Symmetric<dim> w = contraction_weights<dim>();
  // ds by dE1, shears twice: dC1 = 2 dE1
  const Symmetric<dim> ds =
      (2 * (respond(C1).S - middle.S) - 4 * s * dC - 0.5 * middle.D.transpose() * w.cwiseProduct(dC)) / dC2;
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

/// A law of small strains: its energy is quadratic, so that the middle is the discrete gradient, too.
template <int dim, StressAt rule, class Respond>
PointStress<dim> linear_stress(const Square<dim>& F0, const Square<dim>& F1, const Respond& respond) {
  const bool end = rule == StressAt::end;
  const Square<dim> F = end ? F1 : Square<dim>(0.5 * (F0 + F1)), one = Square<dim>::Identity();
  const Response<dim> there = respond(strain_of<true, dim>(F));
  return {one, one, there.S, end ? there.D : SymmetricMap<dim>(0.5 * there.D), 0};
}

/// The stress of any law at a reference place.
template <int dim, StressAt rule>
PointStress<dim> point_stress(const ElasticLaw& any, const Square<dim>& F0, const Square<dim>& F1, double X, double Y) {
  return std::visit(
      [&](const auto& law) -> PointStress<dim> {
        const auto respond = [&](const Symmetric<dim>& C) { return law.template respond<dim>(C, {X, Y}); };
        if constexpr (std::decay_t<decltype(law)>::small_strains) {
          return linear_stress<dim, rule>(F0, F1, respond);
        } else {
          return finite_stress<dim, rule>(F0, F1, respond);
        }
      },
      any);
}

/// Energy density and second Piola-Kirchhoff stress at F.
template <int dim>
Response<dim> response_at(const ElasticLaw& any, const Square<dim>& F, double X, double Y) {
  return std::visit(
      [&](const auto& law) {
        return law.template respond<dim>(strain_of<std::decay_t<decltype(law)>::small_strains, dim>(F), {X, Y});
      },
      any);
}

/// The third direction of a plane body at F.
inline Across across_at(const ElasticLaw& any, const Square<2>& F) {
  return std::visit(
      [&](const auto& law) { return law.template across<2>(strain_of<std::decay_t<decltype(law)>::small_strains, 2>(F)); }, any);
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

/// d2Psi/dF dF of what point_stress() answers: unknown j dim + i is F_ij.
template <int dim>
using GradientModulus = Eigen::Matrix<double, dim * dim, dim * dim>;

template <int dim>
GradientModulus<dim> gradient_modulus(const PointStress<dim>& s) {
  Eigen::Matrix<double, component_count<dim>(), dim * dim> strain;
  for (int j = 0; j < dim; ++j)
    strain.template middleCols<dim>(j * dim) = strain_map<dim>(s.F, Eigen::Matrix<double, dim, 1>::Unit(j));
  GradientModulus<dim> H = strain.transpose() * s.D * strain;
  const Square<dim> S = s.geometric * full<dim>(s.S);
  for (int j = 0; j < dim; ++j) {
    for (int l = 0; l < dim; ++l) {
      for (int i = 0; i < dim; ++i) H(j * dim + i, l * dim + i) += S(j, l);
    }
  }
  return H;
}

/// The nearest positive semi-definite matrix.
template <int dim>
GradientModulus<dim> convex(const GradientModulus<dim>& H) {
  const Eigen::SelfAdjointEigenSolver<GradientModulus<dim>> parts(H);
  if (parts.eigenvalues()[0] >= 0) return H;
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).asDiagonal() * parts.eigenvectors().transpose();
}

}  // namespace tether::fem
