// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/finite_elastic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace tether {
namespace {

Eigen::Matrix2d in_plane(const DeformationGradient& F) {
  return (Eigen::Matrix2d() << F.xx, F.xy, F.yx, F.yy).finished();
}

/// M_11, M_22 and M_12 of M_IK = C_IJKL G_JL, C the modulus D = 2 dS/dC of its components.
std::array<double, 3> contracted(const Eigen::Matrix3d& D, double g11, double g22, double g12) {
  return {D(0, 0) * g11 + (D(0, 2) + D(2, 0)) * g12 + D(2, 2) * g22,
          D(2, 2) * g11 + (D(2, 1) + D(1, 2)) * g12 + D(1, 1) * g22,
          D(0, 2) * g11 + (D(0, 1) + D(2, 2)) * g12 + D(2, 1) * g22};
}

/// The symmetric matrix A = a 1 + b diag(1, -1) + c offdiag(1, 1), of which a and the length of (b, c) say the largest
/// eigenvalue, a + |(b, c)|.
struct Parts {
  double a = 0, b = 0, c = 0;
};

/// Q = F M F^T + (N : tau) 1, M of G = F^T N F.
Parts acoustic(const Eigen::Matrix2d& F, const Eigen::Matrix3d& D, double n11, double n22, double n12, double push) {
  const double a = F(0, 0), b = F(0, 1), c = F(1, 0), d = F(1, 1);
  const auto [m11, m22, m12] =
      contracted(D, n11 * a * a + 2 * n12 * a * c + n22 * c * c, n11 * b * b + 2 * n12 * b * d + n22 * d * d,
                 n11 * a * b + n12 * (a * d + b * c) + n22 * c * d);
  const double q11 = m11 * a * a + 2 * m12 * a * b + m22 * b * b, q22 = m11 * c * c + 2 * m12 * c * d + m22 * d * d;
  return {0.5 * (q11 + q22) + push, 0.5 * (q11 - q22), m11 * a * c + m12 * (a * d + b * c) + m22 * b * d};
}

/// A bound of rho_0 c^2 of plane waves that run in the plane, tau = F S F^T: the largest eigenvalue of Q over all
/// directions n. N = n n^T goes round a circle about 1/2 on which Q is linear and its largest eigenvalue convex:
/// nowhere on it is that larger than at the corners of an octagon around it.
double fastest_wave(const Eigen::Matrix2d& F, const Eigen::Matrix3d& D, const Eigen::Matrix2d& tau) {
  constexpr double far = 0.541196100146197, near = 0.382683432365090;  // 1 / (2 cos(pi/8)), and that over sqrt(2)
  constexpr std::array<std::array<double, 2>, 8> corners{
      {{far, 0}, {near, near}, {0, far}, {-near, near}, {-far, 0}, {-near, -near}, {0, -far}, {near, -near}}};
  const Parts mean = acoustic(F, D, 0.5, 0.5, 0, 0.5 * (tau(0, 0) + tau(1, 1))),
              cosine = acoustic(F, D, 1, -1, 0, tau(0, 0) - tau(1, 1)), sine = acoustic(F, D, 0, 0, 1, 2 * tau(0, 1));
  double largest = 0;
  for (const auto& [x, y] : corners) {
    const double b = mean.b + x * cosine.b + y * sine.b, c = mean.c + x * cosine.c + y * sine.c;
    largest = std::max(largest, mean.a + x * cosine.a + y * sine.a + std::sqrt(b * b + c * c));
  }
  return largest;
}

/// Makes the response of S, the stress S33 along the third direction, its stretch and the modulus in the plane.
FiniteResponse carried(const Eigen::Matrix2d& F, const Symmetric<2>& S, const Across& third, double energy,
                       const Eigen::Matrix3d& D) {
  const Eigen::Matrix2d tau = F * full<2>(S) * F.transpose();
  const double J = F.determinant() * third.stretch, across = third.stretch * third.stretch * third.S;
  return {.stress = {tau(0, 0) / J, tau(1, 1) / J, tau(0, 1) / J, across / J},
          .across = third.stretch,
          .energy = energy,
          .modulus = fastest_wave(F, D, tau)};
}

}  // namespace

FiniteResponse FiniteElastic::respond(const DeformationGradient& gradient) const {
  const Eigen::Matrix2d F = in_plane(gradient);
  const Symmetric<2> C = symmetric<2>((F.transpose() * F).eval());
  return std::visit(
      [&](const auto& of) {
        const Response<2> r = of.template respond<2>(C, {});
        return carried(F, r.S, of.template across<2>(C), r.energy, r.D);
      },
      law);
}

FiniteResponse FiniteElastic::respond_about_axis(const DeformationGradient& gradient) const {
  constexpr std::array<int, 3> plane{0, 1, 3};  // of the six components
  const Eigen::Matrix2d F = in_plane(gradient);
  const Eigen::Matrix2d C = F.transpose() * F;
  Symmetric<3> C3;
  C3 << C(0, 0), C(1, 1), gradient.zz * gradient.zz, C(0, 1), 0, 0;
  return std::visit(
      [&](const auto& of) {
        const Response<3> r = of.template respond<3>(C3, {});
        return carried(F, r.S(plane), {gradient.zz, r.S[2]}, r.energy, r.D(plane, plane));
      },
      law);
}

double FiniteElastic::sound_speed(double density) const {
  const Symmetric<2> rest(1, 1, 0);
  return std::sqrt(std::visit([&](const auto& of) { return of.template respond<2>(rest, {}).D(0, 0); }, law) / density);
}

}  // namespace tether
