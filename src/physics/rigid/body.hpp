// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

namespace tether::fem {

// A rigid body as the continuum paper, section 2.2, describes it: a reference point phi and three directors d_1, d_2,
// d_3 that need be neither orthogonal nor of unit length, [phi d1 d2 d3] in R^12. A body point has constant convective
// coordinates theta^i: x = phi + theta^i d_i (18).

/// Three rows x, y, z and a column for each of phi, d1, d2, d3; by columns it is the paper's vector of 12.
using RigidColumns = Eigen::Matrix<double, 3, 4>;

/// Where the body's coordinates are counted from, in the reference configuration [length]. The point may lie anywhere,
/// also outside of the body; the directors may be of either hand.
struct RigidFrame {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Matrix3d directors = Eigen::Matrix3d::Identity();  ///< d_i in column i

  /// theta^i of a point of the reference configuration (18): position = point + theta^i d_i.
  Eigen::Vector3d convective(const Eigen::Vector3d& position) const;
  RigidColumns columns() const;
};

/// Moments of the mass in convective coordinates (24, 25): a 4 x 4 matrix whose corner is the total mass M_phi, whose
/// edges are the first moments e_i and whose rest are the second moments E_ij [mass, with theta as theta is].
struct RigidInertia {
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();

  double mass() const { return moments(0, 0); }
  Eigen::Vector3d first() const { return moments.block<3, 1>(1, 0); }
  Eigen::Matrix3d second() const { return moments.block<3, 3>(1, 1); }
  /// The constant mass matrix (24): each moment times the 3 x 3 identity.
  Eigen::Matrix<double, 12, 12> matrix() const;
  /// The body's centre of mass when its columns are q [length].
  Eigen::Vector3d centre(const RigidColumns& q) const { return q * moments.col(0) / mass(); }
  /// Moments about the body point theta, in the same directors.
  RigidInertia about(const Eigen::Vector3d& theta) const;
};

/// The second moments' tensor of inertia about phi, J omega = sum E_ij d_i x (omega x d_j) [mass length^2].
Eigen::Matrix3d rigid_inertia_tensor(const Eigen::Matrix3d& second, const Eigen::Matrix3d& directors);

/// Inertia of mass points: x, y, z of each one after another [length], and their masses. The quadrature points of any
/// mesh, with mass = rho w det J, give just the moments (25) of its consistent mass matrix by the same quadrature.
/// Throws InputError where the directors are dependent, where there is no mass or where all of it lies on one line.
RigidInertia rigid_inertia(const RigidFrame& frame, std::span<const double> positions, std::span<const double> masses);

/// Entries M_AB of a consistent mass matrix (9) without its identity: value[k] stands in row[k], column[k]; both halves
/// are listed.
struct RigidNodalMass {
  std::span<const std::size_t> row, column;
  std::span<const double> value;
};

/// Inertia (25) of a mesh from its nodes' places (x, y, z of each) and its consistent mass. Throws as above.
RigidInertia rigid_inertia(const RigidFrame& frame, std::span<const double> nodes, const RigidNodalMass& mass);

/// What stays as it is while the body moves.
struct RigidBody {
  RigidFrame frame;
  RigidInertia inertia;
  std::optional<Eigen::Vector3d> pin;  ///< convective coordinates of the point that is held, if one is

  /// Units in which columns, moments and forces are of order one: a length for phi, a length for each director, an
  /// inertia. Powers of two, so that to divide by them rounds nothing.
  Eigen::Vector4d unit = Eigen::Vector4d::Ones();
  double unit_of_inertia = 1;
};

/// A free body. Throws InputError where frame or inertia cannot be a rigid body's (see above).
RigidBody rigid_body(const RigidFrame& frame, const RigidInertia& inertia);
/// A body held at one point, given by its place in the reference configuration; the body turns about it without
/// friction. The point need not be part of the mesh.
RigidBody rigid_body(const RigidFrame& frame, const RigidInertia& inertia, const Eigen::Vector3d& pin);

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
