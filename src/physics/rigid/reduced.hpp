// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "physics/rigid/state.hpp"

namespace tether::fem {

/// The step (35) in the discrete null space of its constraints. They hold at n+1 exactly when G(q_{n+1/2}) s = 0, that
/// is when s_i = a x d_i at n+1/2 with one vector a = (dt/2) omega: s = P(q_{n+1/2}) [u, a] with the 12 x 6 matrix
/// P = [I 0; 0 -hat(d_i)], which also takes the constraint forces out of the balance, P^T G^T = 0. From
/// d = d_n + a x d follows d_{n+1/2} = B d_n, B = (I - hat a)^-1, and d_{n+1} = 2 d_{n+1/2} - d_n is Cayley's rotation.
/// The six unknowns are what u and a exceed the step's start by; with a fixed point, which is then made the reference
/// point, the three of a.
template <bool pinned>
class RigidReduced {
 public:
  static constexpr int size = pinned ? 3 : 6;
  using Vector = Eigen::Matrix<double, size, 1>;
  using Matrix = Eigen::Matrix<double, size, size>;

  explicit RigidReduced(const RigidMiddle& middle);

  Vector start() const { return Vector::Zero(); }     ///< the body goes on as it did
  double residual(const Vector& x, Vector& r) const;  ///< returns its relative size
  Matrix tangent(const Vector& x) const;              ///< d residual / d x
  Vector correction(const Vector& x, const Vector& r) const;
  RigidIncrements increments(const Vector& x) const;
  Eigen::Vector3d half_turn(const Vector& x) const { return start_ + x.template tail<3>(); }  ///< (dt/2) omega_{n+1/2}

 private:
  RigidColumns gain(const Vector& x, const Eigen::Matrix3d& d) const;
  Eigen::Matrix3d turning_tangent(const Eigen::Matrix3d& B) const;

  const RigidMiddle middle_;
  Eigen::Vector4d pin_;
  Eigen::Vector3d start_;    ///< a with which the step starts
  Eigen::Matrix3d aside_;    ///< drift_i - start x d_i at n: what the velocities hold beside the rigid motion
  Eigen::Matrix3d given_;    ///< sum d_i (x) (sum E_ij d_j + director momentum + fixed force) at n
  Eigen::Matrix3d turning_;  ///< sum d_i (x) (force that turns) at n
};

}  // namespace tether::fem
