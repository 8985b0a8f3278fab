// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "physics/rigid/body.hpp"

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
/// step.hpp.
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
  /// Returns the same step with the fixed point as the reference point.
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

struct RigidNewtonRule {
  /// Largest residual, over the sum of its terms' norms, with which a step may end. Iterations go on below it until
  /// rounding stops them: a residual left over in each step is what energy would drift by.
  double tolerance = 1e-12;
  int most_iterations = 20;  ///< up to RigidReport::most
};

/// How a step ended. Where `converged` is false the state is as it was before, and a shorter step may succeed.
struct RigidReport {
  static constexpr int most = 31;
  bool converged = false;
  int iterations = 0;                               ///< corrections made
  std::array<double, most + 1> residuals{};         ///< relative, before each correction and after the last
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< angular velocity of the step: v_i = omega x d_i at n+1/2
  double work = 0;                                  ///< of all loads in the step, dt v_{n+1/2} . F_{n+1/2} [energy]

  double residual() const { return residuals[static_cast<std::size_t>(iterations)]; }
};

/// |part| over |terms|; 0 where there are none.
inline double rigid_ratio(double part, double terms) { return part == 0 ? 0 : part / terms; }

/// Newton's method until rounding stops it. The system gives residual(x, r), which fills r and returns its relative
/// size, and correction(x, r) = tangent^-1 r.
template <class System>
void rigid_newton(const System& system, typename System::Vector& x, const RigidNewtonRule& rule, RigidReport& report) {
  // The terms are counted by bounds of their norms, beside which rounding is smaller than epsilon.
  constexpr double rounding = 0.25 * std::numeric_limits<double>::epsilon();
  const int last = std::min(rule.most_iterations, RigidReport::most);
  typename System::Vector r;
  double before = std::numeric_limits<double>::infinity();
  for (report.iterations = 0;; ++report.iterations) {
    const double now = system.residual(x, r);
    report.residuals[static_cast<std::size_t>(report.iterations)] = now;
    report.converged = now <= rounding || (now <= rule.tolerance && now > before / 2);
    if (report.converged || report.iterations == last || !std::isfinite(now)) return;
    before = now;
    x -= system.correction(x, r);
  }
}

}  // namespace tether::fem
