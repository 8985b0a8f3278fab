// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "solvers/fem/rigid_body.hpp"

namespace tether::fem {

/// Generalized forces on phi and on the directors (27, 28). Loads add and scale: what depends on time is a sum of them,
/// each times a factor that the caller takes at the middle of the step.
struct RigidForces {
  /// Forces that keep their direction in space, a column for each of phi, d1, d2, d3 [force, force theta].
  RigidColumns fixed = RigidColumns::Zero();
  /// Forces that turn with the body: column a holds the components on d1, d2, d3 of its force [force / length].
  RigidColumns turning = RigidColumns::Zero();
  /// A torque m whose direction in space is kept [force length].
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();

  /// *this += factor * load.
  RigidForces& add(const RigidForces& load, double factor = 1);
};

/// Whether a force keeps its direction in space or turns with the body.
enum class RigidDirection { fixed, turning };

/// Forces at body points (26)-(28). Positions in the reference configuration [length] and forces there [force], x, y, z
/// of each one after another: forces at single points, or volume forces and tractions at quadrature points times the
/// weight, B w det J and T w dA.
RigidForces rigid_point_forces(const RigidFrame& frame, std::span<const double> positions,
                               std::span<const double> forces, RigidDirection direction);

/// Pressures [force / area] at quadrature points of the surface, whose area vectors w n dA [area] point outwards in the
/// reference configuration and turn with the body: the forces are -p n dA.
RigidForces rigid_pressure(const RigidFrame& frame, std::span<const double> positions,
                           std::span<const double> area_vectors, std::span<const double> pressures);

/// The body's weight, a volume force rho g (28); g [acceleration].
RigidForces rigid_gravity(const RigidInertia& inertia, const Eigen::Vector3d& g);

/// A torque about any point [force length].
RigidForces rigid_torque(const Eigen::Vector3d& m);

/// The columns f^phi, f^1, f^2, f^3 (27) of the loads on a body whose columns are q. A torque acts on the directors by
/// f^i = (m x d^i)/2 with the reciprocal vectors d^i . d_j = delta_ij. (30) prints d_i, which is the same in
/// orthonormal frames alone: only with d^i are sum f^i . (omega x d_i) = m . omega and sum d_i x f^i = m in all others.
RigidColumns rigid_generalized_forces(const RigidForces& load, const RigidColumns& q);

}  // namespace tether::fem
