// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/elements.hpp"

#include <Eigen/LU>
#include <variant>

#include "algebra/convex.hpp"
#include "algebra/dense.hpp"

namespace tether::fem {
namespace {

template <int dim>
Symmetric<dim> right_cauchy_green(const Square<dim>& F) {
  return symmetric<dim>((F.transpose() * F).eval());
}

/// A law at a place of the shape at the start, as one that answers to C: what follows is compiled once for all laws.
/// What is not asked of it is not computed.
template <int dim>
struct LawAt {
  const ElasticLaw& law;
  ReferencePlace place;

  Response<dim> response(const Symmetric<dim>& C) const {
    return std::visit([&](const auto& one) { return one.template respond<dim>(C, place); }, law);
  }
  Symmetric<dim> stress(const Symmetric<dim>& C) const {
    return std::visit([&](const auto& one) { return one.template respond<dim>(C, place).S; }, law);
  }
  double energy(const Symmetric<dim>& C) const {
    return std::visit([&](const auto& one) { return one.template respond<dim>(C, place).energy; }, law);
  }
  /// S and, where it is asked, D.
  template <bool with_modulus>
  void answer(const Symmetric<dim>& C, PointStress<dim>& at) const {
    if constexpr (with_modulus) {
      const Response<dim> there = response(C);
      at.S = there.S, at.D = there.D;
    } else {
      at.S = stress(C);
    }
  }
};

/// Returns what the middle stress lacks along dC to do the work of the energies' difference: s = (2 (Psi1 - Psi0) - S_m
/// : dC) / (dC : dC). For small dC that quotient is all rounding; there the difference is the integral of S : dC / 2 by
/// two points of Gauss, exact but for |dC|^5.
template <int dim>
double lacking_stress(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const Symmetric<dim>& middle, double dC2,
                      const LawAt<dim>& law) {
  constexpr double small = 1e-6, gauss = 0.21132486540518711775;
  const Symmetric<dim> dC = C1 - C0;
  if (dC2 > small) return (2 * (law.energy(C1) - law.energy(C0)) - contract<dim>(middle, dC)) / dC2;
  const Symmetric<dim> before = law.stress(C0 + gauss * dC), after = law.stress(C1 - gauss * dC);
  return contract<dim>(Symmetric<dim>(0.5 * ((before - middle) + (after - middle))), dC) / dC2;
}

/// Gonzalez' stress between C0 and C1 and its derivative by C1 (O. Gonzalez, Comput. Methods Appl. Mech. Engrg 190
/// (2000) 1763-1783): S_m + s dC. Steps so small that s dC is below rounding do without it, their tangent sooner: what
/// it has of dC is of no use to Newton's method then.
template <bool with_modulus, int dim>
void discrete_gradient(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const LawAt<dim>& law,
                       PointStress<dim>& at) {
  constexpr double no_stress = 1e-16, no_tangent = 1e-12;  // of |dC|^2
  law.template answer<with_modulus>(0.5 * (C0 + C1), at);
  const Symmetric<dim> dC = C1 - C0, middle = at.S;
  const double dC2 = contract<dim>(dC, dC), s = dC2 < no_stress ? 0 : lacking_stress<dim>(C0, C1, middle, dC2, law);
  if (dC2 >= no_stress) at.S += s * dC;
  if constexpr (with_modulus) {
    const SymmetricMap<dim> D = at.D;
    at.D = 0.5 * D;
    if (dC2 < no_tangent) return;
    const Symmetric<dim> w = contraction_weights<dim>();
    // ds by dE1, shears twice: dC1 = 2 dE1
    const Symmetric<dim> ds =
        (2 * (law.stress(C1) - middle) - 4 * s * dC - 0.5 * D.transpose() * w.cwiseProduct(dC)) / dC2;
    at.D += dC * ds.transpose();
    for (int k = 0; k < component_count<dim>(); ++k) at.D(k, k) += 2 * s / w[k];
  }
}

/// A law of finite strains by the step's rule.
template <bool with_modulus, int dim>
PointStress<dim> finite_stress(StressAt rule, const Square<dim>& F0, const Square<dim>& F1, const LawAt<dim>& law) {
  PointStress<dim> at;
  if (rule == StressAt::end) {
    law.template answer<with_modulus>(right_cauchy_green<dim>(F1), at);
    at.A = at.F = F1, at.geometric = 1;
    return at;
  }
  const Square<dim> middle = 0.5 * (F0 + F1);
  at.A = middle, at.geometric = 0.5;
  if (rule == StressAt::middle) {
    law.template answer<with_modulus>(right_cauchy_green<dim>(middle), at);
    at.F = middle;
    if constexpr (with_modulus) at.D *= 0.5;
  } else {
    at.F = F1;
    discrete_gradient<with_modulus, dim>(right_cauchy_green<dim>(F0), right_cauchy_green<dim>(F1), law, at);
  }
  return at;
}

/// 1 + 2 eps, to which a law of small strains answers.
template <int dim>
Symmetric<dim> small_strain(const Square<dim>& F) {
  return symmetric<dim>((F + F.transpose() - Square<dim>::Identity()).eval());
}

/// A law of small strains: its energy is quadratic, so that the middle is the discrete gradient, too.
template <bool with_modulus, int dim>
PointStress<dim> linear_stress(StressAt rule, const Square<dim>& F0, const Square<dim>& F1, const LawAt<dim>& law) {
  const bool end = rule == StressAt::end;
  PointStress<dim> at;
  law.template answer<with_modulus>(small_strain<dim>(end ? F1 : Square<dim>(0.5 * (F0 + F1))), at);
  if constexpr (with_modulus) at.D *= end ? 1 : 0.5;
  at.A = at.F = Square<dim>::Identity(), at.geometric = 0;
  return at;
}

/// Returns what a law answers to at F.
template <int dim>
Symmetric<dim> strain_of(const ElasticLaw& law, const Square<dim>& F) {
  return small_strains(law) ? small_strain<dim>(F) : right_cauchy_green<dim>(F);
}

/// Returns where the component i, j of a symmetric tensor stands.
template <int dim>
constexpr int component(int i, int j) {
  if (i == j) return i;
  return dim == 2 ? 2 : i + j == 2 ? 5 : i + j == 1 ? 3 : 4;
}

}  // namespace

template <int dim, bool with_modulus>
PointStress<dim> point_stress(StressAt rule, const ElasticLaw& law, const Square<dim>& F0, const Square<dim>& F1,
                              double X, double Y) {
  const LawAt<dim> here{law, {X, Y}};
  return small_strains(law) ? linear_stress<with_modulus>(rule, F0, F1, here)
                            : finite_stress<with_modulus>(rule, F0, F1, here);
}

template <int dim, bool with_modulus>
void gradient_stress(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const ElasticLaw& law, const Vec<2>& place,
                     PointStress<dim>& at) {
  discrete_gradient<with_modulus, dim>(C0, C1, LawAt<dim>{law, {place[0], place[1]}}, at);
}

template <int dim>
Response<dim> response_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y) {
  return LawAt<dim>{law, {X, Y}}.response(strain_of<dim>(law, F));
}

template <int dim>
double energy_at(const ElasticLaw& law, const Square<dim>& F, double X, double Y) {
  return LawAt<dim>{law, {X, Y}}.energy(strain_of<dim>(law, F));
}

Across across_at(const ElasticLaw& any, const Square<2>& F) {
  const Symmetric<2> C = strain_of<2>(any, F);
  return std::visit([&](const auto& law) { return law.template across<2>(C); }, any);
}

/// Column l dim + m is dP by F_ml: A dS, and what the shape's turning adds.
template <int dim>
GradientModulus<dim> gradient_modulus(const PointStress<dim>& s) {
  const Square<dim> S = s.geometric * full<dim>(s.S);
  GradientModulus<dim> H;
  for (int l = 0; l < dim; ++l) {
    for (int m = 0; m < dim; ++m) {
      Symmetric<dim> dS = Symmetric<dim>::Zero();
      for (int n = 0; n < dim; ++n) dS += s.F(m, n) * s.D.col(component<dim>(n, l));
      Eigen::Map<Square<dim>> dP(&H(0, l * dim + m));
      dP.noalias() = s.A * full<dim>(dS);
      dP.row(m) += S.row(l);
    }
  }
  return H;
}

template <int dim>
GradientModulus<dim> convex(const GradientModulus<dim>& H) {
  return is_convex(H) ? H : GradientModulus<dim>(convex_part(H));
}

void make_convex(int n, std::span<double> matrix) {
  Eigen::Map<Eigen::MatrixXd> K(matrix.data(), n, n);
  K = convex_part(K);
}

template PointStress<2> point_stress<2, true>(StressAt, const ElasticLaw&, const Square<2>&, const Square<2>&, double,
                                              double);
template PointStress<2> point_stress<2, false>(StressAt, const ElasticLaw&, const Square<2>&, const Square<2>&, double,
                                               double);
template PointStress<3> point_stress<3, true>(StressAt, const ElasticLaw&, const Square<3>&, const Square<3>&, double,
                                              double);
template PointStress<3> point_stress<3, false>(StressAt, const ElasticLaw&, const Square<3>&, const Square<3>&, double,
                                               double);
template void gradient_stress<2, true>(const Symmetric<2>&, const Symmetric<2>&, const ElasticLaw&, const Vec<2>&,
                                       PointStress<2>&);
template void gradient_stress<2, false>(const Symmetric<2>&, const Symmetric<2>&, const ElasticLaw&, const Vec<2>&,
                                        PointStress<2>&);
template void gradient_stress<3, true>(const Symmetric<3>&, const Symmetric<3>&, const ElasticLaw&, const Vec<2>&,
                                       PointStress<3>&);
template void gradient_stress<3, false>(const Symmetric<3>&, const Symmetric<3>&, const ElasticLaw&, const Vec<2>&,
                                        PointStress<3>&);
template Response<2> response_at<2>(const ElasticLaw&, const Square<2>&, double, double);
template Response<3> response_at<3>(const ElasticLaw&, const Square<3>&, double, double);
template double energy_at<2>(const ElasticLaw&, const Square<2>&, double, double);
template double energy_at<3>(const ElasticLaw&, const Square<3>&, double, double);
template GradientModulus<2> gradient_modulus<2>(const PointStress<2>&);
template GradientModulus<3> gradient_modulus<3>(const PointStress<3>&);
template GradientModulus<2> convex<2>(const GradientModulus<2>&);
template GradientModulus<3> convex<3>(const GradientModulus<3>&);

}  // namespace tether::fem
