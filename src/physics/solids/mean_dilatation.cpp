// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solids/mean_dilatation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <variant>

namespace tether::fem {
namespace {

template <int dim>
Symmetric<dim> unit() {
  return symmetric<dim>(Square<dim>::Identity());
}

/// A strain with its shears counted twice.
template <int dim>
Symmetric<dim> doubled(const Symmetric<dim>& a) {
  return contraction_weights<dim>().cwiseProduct(a);
}

/// The derivative of cof A along X, X's shears counted twice: in space A x X (J. Bonet, A. J. Gil and R. Ortigosa,
/// Comput. Methods Appl. Mech. Engrg 283 (2015) 1061-1094), in the plane cof X.
template <int dim>
SymmetricMap<dim> cofactor_slope(const Symmetric<dim>& A) {
  SymmetricMap<dim> M = SymmetricMap<dim>::Zero();
  if constexpr (dim == 2) {
    M(0, 1) = M(1, 0) = 1, M(2, 2) = -0.5;
  } else {
    M(0, 1) = A[2], M(0, 2) = A[1], M(0, 4) = -A[4];
    M(1, 0) = A[2], M(1, 2) = A[0], M(1, 5) = -A[5];
    M(2, 0) = A[1], M(2, 1) = A[0], M(2, 3) = -A[3];
    M(3, 2) = -A[3], M(3, 3) = -0.5 * A[2], M(3, 4) = 0.5 * A[5], M(3, 5) = 0.5 * A[4];
    M(4, 0) = -A[4], M(4, 3) = 0.5 * A[5], M(4, 4) = -0.5 * A[0], M(4, 5) = 0.5 * A[3];
    M(5, 1) = -A[5], M(5, 3) = 0.5 * A[4], M(5, 4) = 0.5 * A[3], M(5, 5) = -0.5 * A[1];
  }
  return M;
}

template <int dim>
Symmetric<dim> cofactor(const Symmetric<dim>& A) {
  const Symmetric<dim> twice = cofactor_slope<dim>(A) * doubled<dim>(A);
  return dim == 2 ? twice : Symmetric<dim>(0.5 * twice);
}

/// P with J1 - J0 = P : (C1 - C0), and its derivative by E1: J = sqrt(det C), and the difference of det C is that of C
/// with cof C_m in the plane, with (cof C0 + cof C1 + 4 cof C_m)/6 in space.
template <int dim>
struct DilatationSlope {
  Symmetric<dim> P, j;  // j = dJ1/dE1
  SymmetricMap<dim> Q;  // dP/dE1
  DilatationSlope(const Symmetric<dim>& C0, const Symmetric<dim>& C1, double J0, double J1) {
    const Symmetric<dim> Cm = 0.5 * (C0 + C1);
    P = cofactor<dim>(Cm);
    SymmetricMap<dim> slope = cofactor_slope<dim>(Cm);
    if constexpr (dim == 3) {
      P = (cofactor<dim>(C0) + cofactor<dim>(C1) + 4 * P) / 6;
      slope = cofactor_slope<dim>((C1 + 2 * Cm) / 3);
    }
    P /= J0 + J1;
    j = cofactor<dim>(C1) / J1;
    Q = (slope - P * j.transpose()) / (J0 + J1);
  }
};

/// r = t^(2/dim), its slope at t1, and the difference of r over that of t with its derivative by t1.
template <int dim>
struct StretchOfRatio {
  double r0, r1, slope, rho, rho_slope;
  StretchOfRatio(double t0, double t1) {
    if constexpr (dim == 2) {
      r0 = t0, r1 = t1, slope = rho = 1, rho_slope = 0;
    } else {
      const double s0 = std::cbrt(t0), s1 = std::cbrt(t1), squares = s0 * s0 + s0 * s1 + s1 * s1;
      r0 = s0 * s0, r1 = s1 * s1, slope = 2 / (3 * s1), rho = (s0 + s1) / squares;
      rho_slope = -(2 * s0 + s1) * s1 / (squares * squares) / (3 * s1 * s1);
    }
  }
};

/// The dilatations of a shape at all points, and their means; of laws of small strains J is tr eps.
template <int dim>
struct Dilatations {
  std::array<double, most_points> J{}, mean{};
  Dilatations(std::span<const Square<dim>> F, const DilatationModes& modes, bool small) {
    for (std::size_t k = 0; k < F.size(); ++k) J[k] = small ? F[k].trace() - dim : std::abs(F[k].determinant());
    modes.average(std::span(J).first(F.size()), std::span(mean).first(F.size()));
  }
};

/// Takes the numbers out of an element that is turned inside out, so that equilibria are not looked for there; long
/// steps of the discrete gradient may go through such shapes.
template <int dim>
void refuse_turned(std::span<const Square<dim>> F, Dilatations<dim>& of) {
  for (std::size_t k = 0; k < F.size(); ++k) {
    if (!(F[k].determinant() > 0) || !(of.mean[k] > 0)) of.mean[k] = std::numeric_limits<double>::quiet_NaN();
  }
}

/// The stress of a law between C^ of two shapes, and its modulus where that is asked.
template <int dim>
PointStress<dim> stress_between(const Symmetric<dim>& C0, const Symmetric<dim>& C1, const ElasticLaw& law,
                                const Vec<2>& place, bool with_modulus) {
  PointStress<dim> hat;
  if (with_modulus) {
    gradient_stress<dim, true>(C0, C1, law, place, hat);
  } else {
    gradient_stress<dim, false>(C0, C1, law, place, hat);
  }
  return hat;
}

/// The step's rule at one point as a discrete gradient between two shapes: the two ends of the step, or twice the same.
template <int dim>
struct Ends {
  Symmetric<dim> C0, C1;
  double J0, J1, mean0, mean1;
};

/// What is needed of all points before g is known at any.
template <int dim>
struct Halfway {
  double sigma = 0, alpha = 0;
  SymmetricMap<dim> Q;
};

/// Sets what there is at a point without g; the terms are those of the derivation in the header, in its order.
template <int dim>
Halfway<dim> respond(const ElasticLaw& law, const Vec<2>& place, const Ends<dim>& at, bool with_modulus,
                     DilatedPoint<dim>& out) {
  const auto& [C0, C1, J0, J1, mean0, mean1] = at;
  const StretchOfRatio<dim> r(mean0 / J0, mean1 / J1);
  const Symmetric<dim> C_hat0 = r.r0 * C0, C_hat1 = r.r1 * C1, Cm = 0.5 * (C0 + C1);
  const double rm = 0.5 * (r.r0 + r.r1), Jm = 0.5 * (J0 + J1), mean_m = 0.5 * (mean0 + mean1);
  const DilatationSlope<dim> J(C0, C1, J0, J1);
  const PointStress<dim> hat = stress_between<dim>(C_hat0, C_hat1, law, place, with_modulus);
  const double across = contract<dim>(hat.S, Cm), per = 1 / (J0 * J1);
  Halfway<dim> half{across * r.rho * per, 0, J.Q};
  half.alpha = half.sigma * Jm;
  out.s.S = rm * hat.S, out.P = J.P, out.j = J.j;
  if (!with_modulus) return half;
  const Symmetric<dim> by_strain = -mean1 / (J1 * J1) * J.j;  // of J-/J
  const double by_mean = 1 / J1;
  const Symmetric<dim> stretched = 0.5 * r.slope * doubled<dim>(C1);
  const SymmetricMap<dim> S_by_strain =
      hat.D * (r.r1 * SymmetricMap<dim>::Identity() + stretched * by_strain.transpose());
  const Symmetric<dim> S_by_mean = hat.D * (by_mean * stretched), weighted = doubled<dim>(Cm);
  const Symmetric<dim> sigma_by_strain = r.rho * per * (S_by_strain.transpose() * weighted + hat.S) +
                                         across * r.rho_slope * per * by_strain - half.sigma / J1 * J.j;
  const double sigma_by_mean = r.rho * per * weighted.dot(S_by_mean) + across * r.rho_slope * per * by_mean;
  out.s.D =
      rm * S_by_strain + 0.5 * r.slope * hat.S * by_strain.transpose() - mean_m * J.P * sigma_by_strain.transpose();
  out.v = rm * S_by_mean + 0.5 * r.slope * by_mean * hat.S - (mean_m * sigma_by_mean + 0.5 * half.sigma) * J.P;
  out.a = Jm * sigma_by_strain + 0.5 * half.sigma * J.j;
  out.b = Jm * sigma_by_mean;
  return half;
}

/// Laws of finite strains.
template <int dim>
void finite_stresses(StressAt rule, const ElasticLaw& law, std::span<const Square<dim>> F0,
                     std::span<const Square<dim>> F1, std::span<const Vec<2>> places, const DilatationModes& modes,
                     bool with_modulus, std::span<DilatedPoint<dim>> out) {
  const std::size_t count = F1.size();
  std::array<Square<dim>, most_points> middle;
  for (std::size_t k = 0; k < count; ++k) middle[k] = 0.5 * (F0[k] + F1[k]);
  const bool one = rule != StressAt::gradient;
  const std::span<const Square<dim>> second =
      rule == StressAt::middle ? std::span<const Square<dim>>(middle).first(count) : F1;
  const std::span<const Square<dim>> first = one ? second : F0;
  Dilatations<dim> of0(first, modes, false), of1(second, modes, false);
  if (one) refuse_turned<dim>(second, of0), refuse_turned<dim>(second, of1);
  std::array<Halfway<dim>, most_points> half;
  std::array<double, most_points> alpha{}, mean_alpha{};
  for (std::size_t k = 0; k < count; ++k) {
    const Ends<dim> ends{symmetric<dim>((first[k].transpose() * first[k]).eval()),
                         symmetric<dim>((second[k].transpose() * second[k]).eval()),
                         of0.J[k],
                         of1.J[k],
                         of0.mean[k],
                         of1.mean[k]};
    half[k] = respond<dim>(law, places[k], ends, with_modulus, out[k]);
    alpha[k] = half[k].alpha;
  }
  modes.average(std::span(alpha).first(count), std::span(mean_alpha).first(count));
  // Of a stress at one shape both ends are that shape: it changes by twice what one end makes.
  const double times = rule == StressAt::end ? 2 : 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double g = mean_alpha[k] - half[k].sigma * 0.5 * (of0.mean[k] + of1.mean[k]);
    // 2 c (J - J-)_m P: the difference of c (J - J-)^2/2, as what the mean leaves out has no mean.
    const double c = modes.stabiliser, left_out = of0.J[k] + of1.J[k] - of0.mean[k] - of1.mean[k];
    PointStress<dim>& s = out[k].s;
    s.S += (g + c * left_out) * out[k].P;
    s.A = rule == StressAt::end ? F1[k] : middle[k], s.F = second[k], s.geometric = rule == StressAt::end ? 1 : 0.5;
    if (!with_modulus) continue;
    s.D = times * (s.D + (g + c * left_out) * half[k].Q + c * out[k].P * out[k].j.transpose());
    out[k].v -= c * out[k].P;
    out[k].a *= times, out[k].b *= times, out[k].v *= times;
  }
}

/// 1 + 2 eps^ with eps^ = eps + (mean of tr eps - tr eps)/dim.
template <int dim>
Square<dim> dilated_strain(const Square<dim>& F, double trace, double mean) {
  return F + F.transpose() + (2 * (mean - trace) / dim - 1) * Square<dim>::Identity();
}

/// Laws of small strains: J is 1 + tr eps, its P is 1 and changes no more.
template <int dim>
void small_stresses(StressAt rule, const ElasticLaw& law, std::span<const Square<dim>> F0,
                    std::span<const Square<dim>> F1, std::span<const Vec<2>> places, const DilatationModes& modes,
                    bool with_modulus, std::span<DilatedPoint<dim>> out) {
  const std::size_t count = F1.size();
  const bool end = rule == StressAt::end;
  const Symmetric<dim> one = unit<dim>();
  std::array<Square<dim>, most_points> F;
  for (std::size_t k = 0; k < count; ++k) F[k] = end ? F1[k] : Square<dim>(0.5 * (F0[k] + F1[k]));
  const Dilatations<dim> of(std::span<const Square<dim>>(F).first(count), modes, true);
  std::array<double, most_points> alpha{}, mean_alpha{};
  for (std::size_t k = 0; k < count; ++k) {
    const Symmetric<dim> C = symmetric<dim>(dilated_strain<dim>(F[k], of.J[k], of.mean[k]));
    PointStress<dim>& s = out[k].s;
    s = stress_between<dim>(C, C, law, places[k], with_modulus);  // its D is half the law's
    s.A = s.F = Square<dim>::Identity(), s.geometric = 0;
    alpha[k] = contract<dim>(s.S, one) / dim;
    out[k].P = out[k].j = one;
    if (!with_modulus) continue;
    const SymmetricMap<dim> D = (end ? 2 : 1) * s.D;
    const Symmetric<dim> by_mean = D * one / dim;
    s.D = D - by_mean * one.transpose();
    out[k].a = s.D.transpose() * one / dim, out[k].b = one.dot(by_mean) / dim;
    const double c = end ? modes.stabiliser : 0.5 * modes.stabiliser;
    s.D -= one * out[k].a.transpose(), out[k].v = by_mean - out[k].b * one;
    s.D += c * one * one.transpose(), out[k].v -= c * one;
  }
  modes.average(std::span(alpha).first(count), std::span(mean_alpha).first(count));
  for (std::size_t k = 0; k < count; ++k)
    out[k].s.S += (mean_alpha[k] - alpha[k] + modes.stabiliser * (of.J[k] - of.mean[k])) * one;
}

}  // namespace

template <int dim>
void dilated_stresses(StressAt rule, const ElasticLaw& law, std::span<const Square<dim>> F0,
                      std::span<const Square<dim>> F1, std::span<const Vec<2>> places, const DilatationModes& modes,
                      bool with_modulus, std::span<DilatedPoint<dim>> out) {
  assert(F1.size() <= most_points);
  const auto stresses = small_strains(law) ? small_stresses<dim> : finite_stresses<dim>;
  stresses(rule, law, F0, F1, places, modes, with_modulus, out);
}

template <int dim>
void take_mean_dilatation(const ElasticLaw& law, const DilatationModes& modes, std::span<Square<dim>> F,
                          std::span<double> left_out) {
  const bool small = small_strains(law);
  const Dilatations<dim> of(F, modes, small);
  for (std::size_t k = 0; k < F.size(); ++k) {
    if (small) {
      F[k] += (of.mean[k] - of.J[k]) / dim * Square<dim>::Identity();
    } else {
      F[k] *= std::pow(of.mean[k] / of.J[k], 1.0 / dim);
    }
    if (!left_out.empty()) left_out[k] = of.J[k] - of.mean[k];
  }
}

template void dilated_stresses<2>(StressAt, const ElasticLaw&, std::span<const Square<2>>, std::span<const Square<2>>,
                                  std::span<const Vec<2>>, const DilatationModes&, bool, std::span<DilatedPoint<2>>);
template void dilated_stresses<3>(StressAt, const ElasticLaw&, std::span<const Square<3>>, std::span<const Square<3>>,
                                  std::span<const Vec<2>>, const DilatationModes&, bool, std::span<DilatedPoint<3>>);
template void take_mean_dilatation<2>(const ElasticLaw&, const DilatationModes&, std::span<Square<2>>,
                                      std::span<double>);
template void take_mean_dilatation<3>(const ElasticLaw&, const DilatationModes&, std::span<Square<3>>,
                                      std::span<double>);

}  // namespace tether::fem
