// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "solvers/fem/rigid_body.hpp"

namespace tether::fem {

/// What moves. All of it belongs into a checkpoint.
struct RigidState {
  RigidColumns q = RigidColumns::Zero();  ///< phi, d1, d2, d3 [length]
  RigidColumns v = RigidColumns::Zero();  ///< their velocities
  /// What rounding has taken from q and v so far (Kahan's compensation).
  RigidColumns lost_q = RigidColumns::Zero(), lost_v = RigidColumns::Zero();
};

/// A free body in its reference configuration; the velocity is the reference point's, omega the angular velocity
/// [rad/time]: v_i = omega x d_i.
RigidState rigid_start(const RigidBody& body, const Eigen::Vector3d& velocity, const Eigen::Vector3d& omega);
/// A body with a fixed point, which turns about it.
RigidState rigid_start(const RigidBody& body, const Eigen::Vector3d& omega);

/// v . M v / 2 [energy].
double rigid_kinetic_energy(const RigidInertia& inertia, const RigidState& state);
/// Potential of the weight, -M g . (centre of mass): zero where the centre is in the origin [energy].
double rigid_potential_energy(const RigidInertia& inertia, const RigidState& state, const Eigen::Vector3d& g);
/// [mass velocity].
Eigen::Vector3d rigid_linear_momentum(const RigidInertia& inertia, const RigidState& state);
/// About the origin of space [mass length velocity].
Eigen::Vector3d rigid_angular_momentum(const RigidInertia& inertia, const RigidState& state);
/// Angular velocity of that rigid motion, about the fixed point if there is one, which has the state's momenta: the
/// nearest one in the norm of the kinetic energy [rad/time]. What the velocities hold beside it is described in
/// rigid_step.hpp.
Eigen::Vector3d rigid_angular_velocity(const RigidBody& body, const RigidState& state);
/// The velocities of that rigid motion: omega x d_i, and of phi such that the centre of mass has the state's momentum
/// or, with a fixed point, that this rests.
RigidColumns rigid_velocities(const RigidBody& body, const RigidState& state);
/// Angular velocity of directors with the velocities v_i = omega x d_i: sum d^i x v_i / 2, with reciprocal d^i.
Eigen::Vector3d rigid_spin(const Eigen::Matrix3d& directors, const Eigen::Matrix3d& velocities);
/// Power of a torque on it, m . omega = sum v_i . f^i (29) with f^i of the reciprocal vectors [power].
double rigid_torque_power(const Eigen::Vector3d& m, const RigidState& state);

/// d_i . w_i for 11, 22, 33 and d_i . w_j + d_j . w_i for 12, 13, 23, in the order of the multipliers in (33): the
/// gradient of the six constraints at the directors d, times w.
Eigen::Matrix<double, 6, 1> rigid_constraint_rate(const Eigen::Matrix3d& d, const Eigen::Matrix3d& w);
/// The six constraints (31), those of 12, 13, 23 with their mirror images [length^2].
Eigen::Matrix<double, 6, 1> rigid_constraints(const RigidFrame& frame, const RigidColumns& q);

}  // namespace tether::fem
