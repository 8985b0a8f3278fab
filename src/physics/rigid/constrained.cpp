// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/constrained.hpp"

#include <Eigen/LU>

#include "physics/rigid/state.hpp"

namespace tether::fem {
namespace {

/// Lambda of (33).
template <class Six>
Eigen::Matrix3d symmetric(const Six& l) {
  Eigen::Matrix3d L;
  L << l[0], l[3], l[4], l[3], l[1], l[5], l[4], l[5], l[2];
  return L;
}

/// G of the six constraints on the three directors: its row for 12 holds d_2 at d_1 and d_1 at d_2.
Eigen::Matrix<double, 6, 9> gradient(const Eigen::Matrix3d& d) {
  constexpr Eigen::Index first[6] = {0, 1, 2, 0, 0, 1}, second[6] = {0, 1, 2, 1, 2, 2};
  Eigen::Matrix<double, 6, 9> G = Eigen::Matrix<double, 6, 9>::Zero();
  for (Eigen::Index k = 0; k < 6; ++k) {
    G.block<1, 3>(k, 3 * first[k]) = d.col(second[k]).transpose();
    G.block<1, 3>(k, 3 * second[k]) = d.col(first[k]).transpose();
  }
  return G;
}

}  // namespace

template <int Pins>
RigidIncrements RigidConstrained<Pins>::increments(const Vector& x) const {
  return {half_step(x), gain(x)};
}

template <int Pins>
double RigidConstrained<Pins>::residual(const Vector& x, Vector& r) const {
  const RigidColumns s = half_step(x), q = middle_.q + s;
  const Eigen::Matrix3d d = q.rightCols<3>(), w = s.rightCols<3>();
  const RigidColumns F = rigid_generalized_forces(middle_.forces, q);
  RigidColumns held = RigidColumns::Zero();
  held.rightCols<3>() = d * symmetric(x.template segment<6>(12));  // (33)
  double pins = 0;
  if constexpr (Pins > 0) {
    held += x.template tail<3>() * middle_.pin.transpose();
    const Eigen::Vector3d slip = s * middle_.pin;
    r.template tail<3>() = slip;
    pins = rigid_ratio(slip.norm(), s.norm() * middle_.pin.norm());
  }
  const RigidColumns balance = gain(x) * middle_.moments - F + held;  // (35)
  // Phi is quadratic: Phi(q_{n+1}) - Phi(q_n) = G(q_{n+1/2}) (q_{n+1} - q_n), without the cancellation.
  const Eigen::Matrix<double, 6, 1> stretch = rigid_constraint_rate(d, w);
  r.template head<12>() = balance.reshaped();
  r.template segment<6>(12) = stretch;
  const double terms = gain(x).norm() * middle_.moments.norm() + held.norm();
  const double linear = rigid_ratio(balance.col(0).norm(), terms + F.col(0).norm());
  const double turning = rigid_ratio(balance.rightCols<3>().norm(), terms + F.norm());
  return linear + turning + rigid_ratio(stretch.norm(), d.norm() * w.norm()) + pins;
}

template <int Pins>
void RigidConstrained<Pins>::momentum_tangent(const Vector& x, Matrix& J) const {
  Eigen::Matrix4d mass = middle_.moments;
  mass.block<3, 3>(1, 1) += symmetric(x.template segment<6>(12));
  mass.bottomRows<3>() -= middle_.forces.turning;  // transposed below: column a of it is the force on column a
  for (Eigen::Index a = 0; a < 4; ++a) {
    for (Eigen::Index b = 0; b < 4; ++b)
      J.template block<3, 3>(3 * a, 3 * b) = mass(b, a) * Eigen::Matrix3d::Identity();
  }
  // The reciprocal vectors change by -(d^i . delta d_j) d^j, the torque's f^i with them.
  const Eigen::Matrix3d d = (middle_.q + half_step(x)).template rightCols<3>();
  const Eigen::Matrix3d per_d = d.inverse(), twisted = 0.5 * rigid_hat(middle_.forces.torque) * per_d.transpose();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) J.template block<3, 3>(3 * i + 3, 3 * j + 3) += twisted.col(j) * per_d.row(i);
  }
}

template <int Pins>
auto RigidConstrained<Pins>::tangent(const Vector& x) const -> Matrix {
  const RigidColumns s = half_step(x);
  Matrix J = Matrix::Zero();
  momentum_tangent(x, J);
  J.template block<9, 6>(3, 12) = gradient((middle_.q + s).template rightCols<3>()).transpose();
  J.template block<6, 9>(12, 3) = gradient((middle_.q + 2 * s).template rightCols<3>());
  if constexpr (Pins > 0) {
    for (Eigen::Index a = 0; a < 4; ++a) {
      const Eigen::Matrix3d hold = middle_.pin[a] * Eigen::Matrix3d::Identity();
      J.template block<3, 3>(3 * a, 18) = hold;
      J.template block<3, 3>(18, 3 * a) = hold;
    }
  }
  return J;
}

template <int Pins>
auto RigidConstrained<Pins>::correction(const Vector& x, const Vector& r) const -> Vector {
  return tangent(x).partialPivLu().solve(r);
}

template <int Pins>
Eigen::Vector3d RigidConstrained<Pins>::half_turn(const Vector& x) const {
  const RigidColumns s = half_step(x);
  return rigid_spin((middle_.q + s).template rightCols<3>(), s.template rightCols<3>());
}

template class RigidConstrained<0>;
template class RigidConstrained<3>;

}  // namespace tether::fem
