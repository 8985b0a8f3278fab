// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/state.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cassert>

namespace tether::fem {

RigidState rigid_start(const RigidBody& body, const Eigen::Vector3d& velocity, const Eigen::Vector3d& omega) {
  assert(!body.pin);
  RigidState state;
  state.q = body.frame.columns();
  state.v.col(0) = velocity;
  for (int i = 1; i < 4; ++i) state.v.col(i) = omega.cross(state.q.col(i));
  return state;
}

RigidState rigid_start(const RigidBody& body, const Eigen::Vector3d& omega) {
  assert(body.pin);
  RigidBody free = body;
  free.pin.reset();
  const Eigen::Vector3d arm = body.frame.directors * *body.pin;  // from the reference point to the fixed one
  return rigid_start(free, -omega.cross(arm), omega);
}

double rigid_kinetic_energy(const RigidInertia& inertia, const RigidState& state) {
  return 0.5 * (state.v * inertia.moments).cwiseProduct(state.v).sum();  // (21)
}

double rigid_potential_energy(const RigidInertia& inertia, const RigidState& state, const Eigen::Vector3d& g) {
  return 0 - g.dot(state.q * inertia.moments.col(0));
}

Eigen::Vector3d rigid_linear_momentum(const RigidInertia& inertia, const RigidState& state) {
  return state.v * inertia.moments.col(0);
}

Eigen::Vector3d rigid_angular_momentum(const RigidInertia& inertia, const RigidState& state) {
  const RigidColumns momenta = state.v * inertia.moments;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int a = 0; a < 4; ++a) sum += state.q.col(a).cross(momenta.col(a));
  return sum;
}

Eigen::Vector3d rigid_angular_velocity(const RigidBody& body, const RigidState& state) {
  // About the centre of mass, or the fixed point, which does not move, the velocity of phi drops out.
  const Eigen::Vector3d theta = body.pin ? *body.pin : Eigen::Vector3d(body.inertia.first() / body.inertia.mass());
  const Eigen::Matrix3d second = body.inertia.about(theta).second();
  const Eigen::Matrix3d directors = state.q.rightCols<3>(), momenta = state.v.rightCols<3>() * second;
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) spin += directors.col(i).cross(momenta.col(i));
  // In the body's unit of inertia, so that no mass, however small or large, takes the determinant out of all numbers.
  const double unit = 1 / body.unit_of_inertia;
  return (unit * rigid_inertia_tensor(second, directors)).inverse() * (unit * spin);
}

RigidColumns rigid_velocities(const RigidBody& body, const RigidState& state) {
  const Eigen::Vector3d omega = rigid_angular_velocity(body, state);
  RigidColumns v;
  for (int i = 1; i < 4; ++i) v.col(i) = omega.cross(state.q.col(i));
  const Eigen::Vector3d theta = body.pin ? *body.pin : Eigen::Vector3d(body.inertia.first() / body.inertia.mass());
  v.col(0) = -v.rightCols<3>() * theta;
  if (!body.pin) v.col(0) += rigid_linear_momentum(body.inertia, state) / body.inertia.mass();
  return v;
}

Eigen::Vector3d rigid_spin(const Eigen::Matrix3d& directors, const Eigen::Matrix3d& velocities) {
  const Eigen::Matrix3d reciprocal = directors.inverse().transpose();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += reciprocal.col(i).cross(velocities.col(i));
  return 0.5 * sum;
}

double rigid_torque_power(const Eigen::Vector3d& m, const RigidState& state) {
  return m.dot(rigid_spin(state.q.rightCols<3>(), state.v.rightCols<3>()));  // (29)
}

Eigen::Matrix<double, 6, 1> rigid_constraint_rate(const Eigen::Matrix3d& d, const Eigen::Matrix3d& w) {
  const Eigen::Matrix3d P = d.transpose() * w;
  Eigen::Matrix<double, 6, 1> rate;
  rate << P(0, 0), P(1, 1), P(2, 2), P(0, 1) + P(1, 0), P(0, 2) + P(2, 0), P(1, 2) + P(2, 1);
  return rate;
}

Eigen::Matrix<double, 6, 1> rigid_constraints(const RigidFrame& frame, const RigidColumns& q) {
  const Eigen::Matrix3d d = q.rightCols<3>();
  return 0.5 * (rigid_constraint_rate(d, d) - rigid_constraint_rate(frame.directors, frame.directors));
}

namespace {

/// sum += part; what the addition rounds off is kept in `lost` and added the next time (Knuth's two-sum).
void add_compensated(const RigidColumns& part, RigidColumns& sum, RigidColumns& lost) {
  const RigidColumns y = part + lost, total = sum + y, taken = total - sum;
  lost = (sum - (total - taken)) + (y - taken);
  sum = total;
}

}  // namespace

RigidMiddle::RigidMiddle(const RigidBody& body, const RigidForces& loads, const RigidState& state, double dt) {
  const double half = dt / 2, per_inertia = 1 / body.unit_of_inertia, scale = half * half * per_inertia;
  const Eigen::Vector4d &unit = body.unit, per_unit = unit.cwiseInverse();
  moments = per_inertia * (unit.asDiagonal() * body.inertia.moments * unit.asDiagonal());
  q = state.q * per_unit.asDiagonal();
  drift = half * state.v * per_unit.asDiagonal();
  forces.fixed = scale * loads.fixed * unit.asDiagonal();
  forces.turning = scale * (unit.tail<3>().asDiagonal() * loads.turning * unit.asDiagonal());
  forces.torque = scale * loads.torque;
  pin << 1, (body.pin ? Eigen::Vector3d(body.pin->cwiseProduct(unit.tail<3>()) / unit[0]) : Eigen::Vector3d::Zero());
}

RigidMiddle RigidMiddle::about_pin() const {
  // [phi d] = [y d] Z with the fixed point y at rest; moments and forces go with Z = [1 0; -theta I].
  Eigen::Matrix4d Z = Eigen::Matrix4d::Identity();
  Z.block<3, 1>(1, 0) = -pin.tail<3>();
  RigidMiddle other = *this;
  other.moments = Z * moments * Z.transpose();
  other.q.col(0) = q * pin;
  other.drift.col(0).setZero();
  other.forces.fixed = forces.fixed * Z.transpose();
  other.forces.turning = forces.turning * Z.transpose();
  return other;
}

void rigid_advance(const RigidBody& body, const RigidIncrements& increments, double dt, RigidState& state) {
  // Both are sums of many small parts. Not v from the difference of two q: their rounding would be divided by dt.
  add_compensated(2 * increments.half_step * body.unit.asDiagonal(), state.q, state.lost_q);
  add_compensated(4 / dt * increments.gain * body.unit.asDiagonal(), state.v, state.lost_v);
}

}  // namespace tether::fem
