// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "solvers/fem/rigid_loads.hpp"
#include "solvers/fem/rigid_state.hpp"

namespace tether::fem {

/// One mid-point step (35) in the body's units (`RigidBody::unit`), in which its numbers are of order one. The momentum
/// balance is multiplied by (dt/2)^2 and holds between increments:
///   half step  s = q_{n+1/2} - q_n = (dt/2) v_{n+1/2},   gain  z = (dt/2) (v_{n+1/2} - v_n),   s = drift + z.
struct RigidMiddle {
  Eigen::Matrix4d moments;  ///< M_phi, e_i, E_ij
  RigidColumns q;           ///< q_n
  RigidColumns drift;       ///< (dt/2) v_n
  RigidForces forces;       ///< (dt/2)^2 times the loads at n+1/2
  Eigen::Vector4d pin;      ///< [1, theta] of the fixed point, [1, 0] without one

  RigidMiddle(const RigidBody& body, const RigidForces& loads, const RigidState& state, double dt);
  /// The same step with the fixed point as the reference point.
  RigidMiddle about_pin() const;
};

/// What a system makes of its solution, in the body's units.
struct RigidIncrements {
  RigidColumns half_step, gain;  ///< s and z
};

/// Ends the step: q_{n+1} = q_n + 2 s, v_{n+1} = v_n + 2 z/(dt/2).
void rigid_advance(const RigidBody& body, const RigidIncrements& increments, double dt, RigidState& state);

/// The cross product's matrix: hat(a) b = a x b.
inline Eigen::Matrix3d rigid_hat(const Eigen::Vector3d& a) {
  Eigen::Matrix3d hat;
  hat << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return hat;
}

}  // namespace tether::fem
