// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/rigid_middle.hpp"

namespace tether::fem {
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
