// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/body.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/diagnostics.hpp"
#include "model/solids.hpp"

namespace tether::fem {
namespace {

/// Below this ratio of the principal moments of inertia about the centre the mass counts as lying on a line.
constexpr double least_breadth = 1e-12;

void check_directors(const Eigen::Matrix3d& directors) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double length = directors.col(i).norm();
    if (std::isfinite(length) && length > 0) continue;
    throw InputError(fmt::format("rigid body: director d{} has length {}", i + 1, length),
                     "give three independent directions");
  }
  const double volume = spanned_volume(directors);
  if (volume >= least_spanned_volume) return;
  throw InputError(
      fmt::format("rigid body: the directors d1, d2, d3 lie in one plane (their unit vectors span {:.3g})", volume),
      "give three independent directions; they need not be orthogonal");
}

void check_mass(const RigidFrame& frame, const RigidInertia& inertia) {
  if (!inertia.moments.allFinite() || !frame.point.allFinite()) {
    throw InputError("rigid body: a position or a mass is not a finite number");
  }
  if (!(inertia.mass() > 0)) {
    throw InputError(fmt::format("rigid body: the total mass is {}, not positive", inertia.mass()),
                     "give its elements a density");
  }
  const Eigen::Matrix3d central = inertia.about(inertia.first() / inertia.mass()).second();
  const Eigen::Vector3d principal =
      rigid_inertia_tensor(central, frame.directors).selfadjointView<Eigen::Lower>().eigenvalues();
  if (principal[2] > 0 && principal[0] > least_breadth * principal[2]) return;
  throw InputError("rigid body: all of its mass lies on one line or in one point, about which it has no inertia",
                   "give it breadth, or model it as a bar or as a point mass");
}

void check(const RigidFrame& frame, const RigidInertia& inertia) {
  check_directors(frame.directors);
  check_mass(frame, inertia);
}

/// [1, theta] of one of the positions.
Eigen::Vector4d with_one(const RigidFrame& frame, std::span<const double> positions, std::size_t k) {
  Eigen::Vector4d one;
  one << 1, frame.convective(Eigen::Vector3d(positions.data() + 3 * k));
  return one;
}

double power_of_two_near(double x) { return std::exp2(std::round(std::log2(x))); }

}  // namespace

Eigen::Vector3d RigidFrame::convective(const Eigen::Vector3d& position) const {
  return directors.inverse() * (position - point);
}

RigidColumns RigidFrame::columns() const {
  RigidColumns q;
  q << point, directors;
  return q;
}

Eigen::Matrix<double, 12, 12> RigidInertia::matrix() const {
  Eigen::Matrix<double, 12, 12> m;
  for (Eigen::Index a = 0; a < 4; ++a) {
    for (Eigen::Index b = 0; b < 4; ++b)
      m.block<3, 3>(3 * a, 3 * b) = moments(a, b) * Eigen::Matrix3d::Identity();  // (24)
  }
  return m;
}

RigidInertia RigidInertia::about(const Eigen::Vector3d& theta) const {
  // With the point y = phi + theta^i d_i the columns are [phi d] = [y d] Z, and the energy is tr(V m V^T) / 2.
  Eigen::Matrix4d Z = Eigen::Matrix4d::Identity();
  Z.block<3, 1>(1, 0) = -theta;
  return {Z * moments * Z.transpose()};
}

Eigen::Matrix3d rigid_inertia_tensor(const Eigen::Matrix3d& second, const Eigen::Matrix3d& directors) {
  const Eigen::Matrix3d S = directors * second * directors.transpose();
  return S.trace() * Eigen::Matrix3d::Identity() - S;
}

RigidInertia rigid_inertia(const RigidFrame& frame, std::span<const double> positions, std::span<const double> masses) {
  assert(positions.size() == 3 * masses.size());
  check_directors(frame.directors);
  RigidInertia inertia;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    const Eigen::Vector4d theta = with_one(frame, positions, k);
    inertia.moments += masses[k] * theta * theta.transpose();  // (25)
  }
  check_mass(frame, inertia);
  return inertia;
}

RigidInertia rigid_inertia(const RigidFrame& frame, std::span<const double> nodes, const RigidNodalMass& mass) {
  assert(mass.row.size() == mass.value.size() && mass.column.size() == mass.value.size());
  check_directors(frame.directors);
  RigidInertia inertia;
  for (std::size_t k = 0; k < mass.value.size(); ++k) {
    assert(3 * mass.row[k] + 2 < nodes.size() && 3 * mass.column[k] + 2 < nodes.size());
    inertia.moments +=
        mass.value[k] * with_one(frame, nodes, mass.row[k]) * with_one(frame, nodes, mass.column[k]).transpose();
  }
  check_mass(frame, inertia);
  return inertia;
}

RigidBody rigid_body(const RigidFrame& frame, const RigidInertia& inertia) {
  check(frame, inertia);
  RigidBody body{frame, inertia, std::nullopt};
  const double inertia_trace = rigid_inertia_tensor(inertia.second(), frame.directors).trace();
  body.unit[0] = power_of_two_near(std::sqrt(inertia_trace / inertia.mass()));
  for (int i = 0; i < 3; ++i) body.unit[i + 1] = power_of_two_near(frame.directors.col(i).norm());
  body.unit_of_inertia = power_of_two_near(inertia_trace);
  return body;
}

RigidBody rigid_body(const RigidFrame& frame, const RigidInertia& inertia, const Eigen::Vector3d& pin) {
  RigidBody body = rigid_body(frame, inertia);
  if (!pin.allFinite()) throw InputError("rigid body: the place of its fixed point is not a finite number");
  body.pin = frame.convective(pin);
  return body;
}

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
