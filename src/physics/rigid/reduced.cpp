// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/reduced.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "physics/rigid/state.hpp"

namespace tether::fem {
namespace {

/// sum x_k x y_k of A = sum x_k (x) y_k.
Eigen::Vector3d cross_sum(const Eigen::Matrix3d& A) {
  return {A(1, 2) - A(2, 1), A(2, 0) - A(0, 2), A(0, 1) - A(1, 0)};
}

/// B = (I - hat a)^-1: d = B d_n solves d = d_n + a x d.
Eigen::Matrix3d to_middle(const Eigen::Vector3d& a) {
  return (Eigen::Matrix3d::Identity() + rigid_hat(a) + a * a.transpose()) / (1 + a.squaredNorm());
}

/// d cross_sum(B A) / d a, given X = B A: from delta d = B (delta a x d) follows sum_k hat(e_k) B hat(x_k) with the
/// columns x_k of X.
Eigen::Matrix3d cross_sum_tangent(const Eigen::Matrix3d& B, const Eigen::Matrix3d& X) {
  Eigen::Matrix3d T = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) T += rigid_hat(Eigen::Vector3d::Unit(k)) * B * rigid_hat(X.col(k));
  return T;
}

}  // namespace

template <bool pinned>
RigidReduced<pinned>::RigidReduced(const RigidMiddle& middle)
    : middle_(pinned ? middle.about_pin() : middle), pin_(middle.pin) {
  const Eigen::Matrix3d d = middle_.q.template rightCols<3>(), drift = middle_.drift.template rightCols<3>();
  start_ = rigid_spin(d, drift);
  aside_ = drift - rigid_hat(start_) * d;
  const RigidColumns momentum = middle_.drift * middle_.moments + middle_.forces.fixed;
  given_ = d * (d * middle_.moments.template bottomRightCorner<3, 3>() + momentum.template rightCols<3>()).transpose();
  turning_ = d * (d * middle_.forces.turning.template rightCols<3>()).transpose();
}

template <bool pinned>
RigidColumns RigidReduced<pinned>::gain(const Vector& x, const Eigen::Matrix3d& d) const {
  // z_i = a x d_i - drift_i from small terms only: with d - d_n = a x d no part of the rotation itself is left.
  const Eigen::Vector3d more = x.template tail<3>();
  RigidColumns z;
  z.rightCols<3>() = rigid_hat(more) * d + rigid_hat(start_) * (rigid_hat(start_ + more) * d) - aside_;
  if constexpr (pinned)
    z.col(0).setZero();
  else
    z.col(0) = x.template head<3>();
  return z;
}

template <bool pinned>
double RigidReduced<pinned>::residual(const Vector& x, Vector& r) const {
  const Eigen::Matrix3d d = to_middle(half_turn(x)) * middle_.q.template rightCols<3>();
  const RigidColumns z = gain(x, d), force = middle_.forces.fixed + d * middle_.forces.turning;
  const RigidColumns balance = z * middle_.moments - force;
  const Eigen::Vector3d turn = cross_sum(d * balance.rightCols<3>().transpose()) - middle_.forces.torque;
  const double terms = z.norm() * middle_.moments.norm();
  const double turning = rigid_ratio(turn.norm(), d.norm() * (terms + force.norm()) + middle_.forces.torque.norm());
  r.template tail<3>() = turn;
  if constexpr (pinned) {
    return turning;
  } else {
    r.template head<3>() = balance.col(0);
    return turning + rigid_ratio(balance.col(0).norm(), terms + force.col(0).norm());
  }
}

template <bool pinned>
Eigen::Matrix3d RigidReduced<pinned>::turning_tangent(const Eigen::Matrix3d& B) const {
  // sum E_ij d_i x s_j = - sum E_ij d_i x (d_j at n): but for the forces that turn and the linear motion the residual
  // is
  // - cross_sum(B given_).
  const Eigen::Matrix3d turning = B * turning_ * B.transpose();
  return -cross_sum_tangent(B, B * given_ + turning - turning.transpose());
}

template <bool pinned>
auto RigidReduced<pinned>::tangent(const Vector& x) const -> Matrix {
  const Eigen::Matrix3d B = to_middle(half_turn(x));
  Matrix J;
  J.template bottomRightCorner<3, 3>() = turning_tangent(B);
  if constexpr (!pinned) {
    const Eigen::Matrix3d d = B * middle_.q.template rightCols<3>();
    const Eigen::Vector3d u = middle_.drift.col(0) + x.template head<3>();
    const Eigen::Vector3d c = d * middle_.moments.template block<3, 1>(1, 0), force = d * middle_.forces.turning.col(0);
    const Eigen::Matrix3d turned = B * rigid_hat(c);  // - dc/da
    J.template topLeftCorner<3, 3>() = middle_.moments(0, 0) * Eigen::Matrix3d::Identity();
    J.template topRightCorner<3, 3>() = B * rigid_hat(force) - turned;
    J.template bottomLeftCorner<3, 3>() = rigid_hat(c);
    J.template bottomRightCorner<3, 3>() += rigid_hat(u) * turned;
  }
  return J;
}

template <bool pinned>
auto RigidReduced<pinned>::correction(const Vector& x, const Vector& r) const -> Vector {
  const Matrix J = tangent(x);
  if constexpr (pinned) {
    return J.inverse() * r;
  } else {
    // The block of u is M times the identity: it is eliminated first.
    const double per_mass = 1 / middle_.moments(0, 0);
    const Eigen::Matrix3d C = per_mass * J.template bottomLeftCorner<3, 3>();
    const Eigen::Matrix3d D = J.template bottomRightCorner<3, 3>() - C * J.template topRightCorner<3, 3>();
    const Eigen::Vector3d linear = r.template head<3>(), turn = r.template tail<3>();
    const Eigen::Vector3d da = D.inverse() * (turn - C * linear);
    Vector dx;
    dx << per_mass * (linear - J.template topRightCorner<3, 3>() * da), da;
    return dx;
  }
}

template <bool pinned>
RigidIncrements RigidReduced<pinned>::increments(const Vector& x) const {
  const Eigen::Vector3d a = half_turn(x);
  const Eigen::Matrix3d d = to_middle(a) * middle_.q.template rightCols<3>();
  RigidIncrements both{{}, gain(x, d)};
  both.half_step << middle_.drift.col(0) + both.gain.col(0), rigid_hat(a) * d;
  if constexpr (pinned) {  // back to the body's own reference point
    both.half_step.col(0) = -both.half_step.template rightCols<3>() * pin_.template tail<3>();
    both.gain.col(0) = -both.gain.template rightCols<3>() * pin_.template tail<3>();
  }
  return both;
}

template class RigidReduced<false>;
template class RigidReduced<true>;

}  // namespace tether::fem
