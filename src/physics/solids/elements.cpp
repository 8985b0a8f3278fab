// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/elements.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <variant>

namespace tether::fem {
namespace {

template <int dim>
Symmetric<dim> right_cauchy_green(const Square<dim>& F) {
  return symmetric<dim>((F.transpose() * F).eval());
}

/// A law at a place of the shape at the start, as one that answers to C: what follows is compiled once for all laws.
template <int dim>
struct LawAt {
  const ElasticLaw& law;
  ReferencePlace place;

  Response<dim> operator()(const Symmetric<dim>& C) const {
    return std::visit([&](const auto& one) { return one.template respond<dim>(C, place); }, law);
  }
};

/// What the middle stress lacks along dC to do the work of the energies' difference: s = (2 (Psi1 - Psi0) - S_m : dC) /
/// (dC : dC). For small dC that quotient is all rounding; there the difference is the integral of S : dC / 2 by two
/// points of Gauss, exact but for |dC|^5.
template <int dim>
double lacking_stress(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const Symmetric<dim>& middle, double dC2,
                      const LawAt<dim>& respond) {
  constexpr double small = 1e-6, gauss = 0.21132486540518711775;
  const Symmetric<dim> dC = C1 - C0;
  if (dC2 > small) return (2 * (respond(C1).energy - respond(C0).energy) - contract<dim>(middle, dC)) / dC2;
  const Symmetric<dim> before = respond(Symmetric<dim>(C0 + gauss * dC)).S,
                       after = respond(Symmetric<dim>(C1 - gauss * dC)).S;
  return contract<dim>(Symmetric<dim>(0.5 * ((before - middle) + (after - middle))), dC) / dC2;
}

/// Gonzalez' stress between C0 and C1 and its derivative by C1 (O. Gonzalez, Comput. Methods Appl. Mech. Engrg 190
/// (2000) 1763-1783): S_m + s dC. Steps so small that s dC is below rounding do without it, their tangent sooner: what
/// it has of dC is of no use to Newton's method then.
template <int dim>
void discrete_gradient(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const LawAt<dim>& respond,
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

/// A law of finite strains by the step's rule.
template <int dim>
PointStress<dim> finite_stress(StressAt rule, const Square<dim>& F0, const Square<dim>& F1, const LawAt<dim>& respond) {
  if (rule == StressAt::end) {
    const Response<dim> end = respond(right_cauchy_green<dim>(F1));
    return {F1, F1, end.S, end.D, 1};
  }
  PointStress<dim> at;
  const Square<dim> middle = 0.5 * (F0 + F1);
  at.A = middle, at.geometric = 0.5;
  if (rule == StressAt::middle) {
    const Response<dim> there = respond(right_cauchy_green<dim>(middle));
    at.F = middle, at.S = there.S, at.D = 0.5 * there.D;
  } else {
    at.F = F1;
    discrete_gradient<dim>(right_cauchy_green<dim>(F0), right_cauchy_green<dim>(F1), respond, at);
  }
  return at;
}

/// 1 + 2 eps, to which a law of small strains answers.
template <int dim>
Symmetric<dim> small_strain(const Square<dim>& F) {
  return symmetric<dim>((F + F.transpose() - Square<dim>::Identity()).eval());
}

/// A law of small strains: its energy is quadratic, so that the middle is the discrete gradient, too.
template <int dim>
PointStress<dim> linear_stress(StressAt rule, const Square<dim>& F0, const Square<dim>& F1, const LawAt<dim>& respond) {
  const bool end = rule == StressAt::end;
  const Square<dim> F = end ? F1 : Square<dim>(0.5 * (F0 + F1)), one = Square<dim>::Identity();
  const Response<dim> there = respond(small_strain<dim>(F));
  return {one, one, there.S, end ? there.D : SymmetricMap<dim>(0.5 * there.D), 0};
}

bool small_strains(const ElasticLaw& any) {
  return std::visit([](const auto& law) { return law.small_strains; }, any);
}

/// What a law answers to at F.
template <int dim>
Symmetric<dim> strain_of(const ElasticLaw& law, const Square<dim>& F) {
  return small_strains(law) ? small_strain<dim>(F) : right_cauchy_green<dim>(F);
}

}  // namespace

template <int dim>
PointStress<dim> point_stress(StressAt rule, const ElasticLaw& law, const Square<dim>& F0, const Square<dim>& F1,
                              double X, double Y) {
  const LawAt<dim> respond{law, {X, Y}};
  return small_strains(law) ? linear_stress<dim>(rule, F0, F1, respond) : finite_stress<dim>(rule, F0, F1, respond);
}

template <int dim>
Response<dim> response_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y) {
  return LawAt<dim>{law, {X, Y}}(strain_of<dim>(law, F));
}

Across across_at(const ElasticLaw& any, const Square<2>& F) {
  const Symmetric<2> C = strain_of<2>(any, F);
  return std::visit([&](const auto& law) { return law.template across<2>(C); }, any);
}

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

template <int dim>
GradientModulus<dim> convex(const GradientModulus<dim>& H) {
  const Eigen::SelfAdjointEigenSolver<GradientModulus<dim>> parts(H);
  if (parts.eigenvalues()[0] >= 0) return H;
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).asDiagonal() * parts.eigenvectors().transpose();
}

template PointStress<2> point_stress<2>(StressAt, const ElasticLaw&, const Square<2>&, const Square<2>&, double,
                                        double);
template PointStress<3> point_stress<3>(StressAt, const ElasticLaw&, const Square<3>&, const Square<3>&, double,
                                        double);
template Response<2> response_at<2>(const ElasticLaw&, const Square<2>&, double, double);
template Response<3> response_at<3>(const ElasticLaw&, const Square<3>&, double, double);
template GradientModulus<2> gradient_modulus<2>(const PointStress<2>&);
template GradientModulus<3> gradient_modulus<3>(const PointStress<3>&);
template GradientModulus<2> convex<2>(const GradientModulus<2>&);
template GradientModulus<3> convex<3>(const GradientModulus<3>&);

}  // namespace tether::fem
