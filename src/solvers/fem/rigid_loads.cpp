// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/rigid_loads.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cassert>
#include <cstddef>

namespace tether::fem {
namespace {

/// [1, theta], the weights of a point's force on phi and the directors (28).
Eigen::RowVector4d weights(const RigidFrame& frame, const Eigen::Vector3d& position) {
  Eigen::RowVector4d weights;
  weights << 1, frame.convective(position).transpose();
  return weights;
}

}  // namespace

RigidForces& RigidForces::add(const RigidForces& load, double factor) {
  fixed += factor * load.fixed;
  turning += factor * load.turning;
  torque += factor * load.torque;
  return *this;
}

RigidForces rigid_point_forces(const RigidFrame& frame, std::span<const double> positions,
                               std::span<const double> forces, RigidDirection direction) {
  assert(positions.size() == forces.size() && forces.size() % 3 == 0);
  const Eigen::Matrix3d components = frame.directors.inverse();
  RigidForces load;
  for (std::size_t k = 0; k < forces.size(); k += 3) {
    const Eigen::Vector3d force(forces.data() + k);
    const Eigen::RowVector4d weight = weights(frame, Eigen::Vector3d(positions.data() + k));
    if (direction == RigidDirection::fixed)
      load.fixed += force * weight;
    else
      load.turning += components * force * weight;
  }
  return load;
}

RigidForces rigid_pressure(const RigidFrame& frame, std::span<const double> positions,
                           std::span<const double> area_vectors, std::span<const double> pressures) {
  assert(positions.size() == 3 * pressures.size() && area_vectors.size() == 3 * pressures.size());
  const Eigen::Matrix3d components = frame.directors.inverse();
  RigidForces load;
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    const Eigen::Vector3d force = -pressures[k] * Eigen::Vector3d(area_vectors.data() + 3 * k);
    load.turning += components * force * weights(frame, Eigen::Vector3d(positions.data() + 3 * k));
  }
  return load;
}

RigidForces rigid_gravity(const RigidInertia& inertia, const Eigen::Vector3d& g) {
  RigidForces load;
  load.fixed = g * inertia.moments.row(0);
  return load;
}

RigidForces rigid_torque(const Eigen::Vector3d& m) {
  RigidForces load;
  load.torque = m;
  return load;
}

RigidColumns rigid_generalized_forces(const RigidForces& load, const RigidColumns& q) {
  const Eigen::Matrix3d directors = q.rightCols<3>();
  RigidColumns F = load.fixed + directors * load.turning;
  const Eigen::Matrix3d reciprocal = directors.inverse().transpose();                      // d^i in column i
  for (int i = 0; i < 3; ++i) F.col(i + 1) += 0.5 * load.torque.cross(reciprocal.col(i));  // (30) with d^i
  return F;
}

}  // namespace tether::fem
