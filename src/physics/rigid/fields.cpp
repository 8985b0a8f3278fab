// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/fields.hpp"

#include "physics/solids/fields.hpp"

namespace tether::fem {
namespace {

/// Returns the columns q or v at all nodes, three numbers a node (18).
std::vector<double> at_nodes(const RigidColumns& columns, const RigidSystem& system) {
  std::vector<double> numbers(system.solids.mesh.x.size());
  Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>>(numbers.data(), 3, system.nodes.cols()) = columns * system.nodes;
  return numbers;
}

/// Largest change of an angle or a length between directors (31): |d_i . d_j - its first value| / (|d_i| |d_j|).
double constraint_error(const RigidFrame& frame, const RigidColumns& q) {
  const Eigen::Matrix3d d = q.rightCols<3>(), D = frame.directors;
  const Eigen::DiagonalMatrix<double, 3> unit(D.colwise().norm().cwiseInverse().transpose());
  return (unit * (d.transpose() * d - D.transpose() * D) * unit).cwiseAbs().maxCoeff();
}

double pin_slip(const RigidBody& body, const RigidColumns& q) {
  Eigen::Vector4d pin;
  pin << 1, *body.pin;
  return ((q - body.frame.columns()) * pin).norm();
}

Components components(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

using Group = ColumnGroup<RigidSetting, RigidSums>;
using Row = Column<RigidSetting, RigidSums>;
using D = Dimension;

Group work_column() {
  return {{Row("energy_loads", D::energy, "work that loads have done on the bodies", &RigidSums::work)
               .booked(Book::gained)}};
}

Group turning_columns() {
  const auto omega = [](const RigidSums& s, std::size_t axis, std::size_t) { return s.omega[axis]; };
  const auto director = [](std::size_t i) {
    return [i](const RigidSums& s, std::size_t axis, std::size_t) { return s.directors[i][axis]; };
  };
  return {{Row("omega_", D::rate, "angular velocity about the fixed axes", omega).vector(),
           Row("director_1_", D::length, "director 1", director(0)).vector(),
           Row("director_2_", D::length, "director 2", director(1)).vector(),
           Row("director_3_", D::length, "director 3", director(2)).vector(),
           {"constraint_error", D::number, "largest change of a length or an angle of the directors",
            &RigidSums::constraint_error},
           Row("pin_slip", D::length, "way of the pinned place", &RigidSums::pin_slip)
               .when("with a pin", [](const RigidSetting& s) { return s.pinned; })}};
}

}  // namespace

const ColumnTable<RigidSetting, RigidSums>& rigid_table() {
  static const ColumnTable<RigidSetting, RigidSums> table({energy_columns(), work_column(), momentum_columns(),
                                                           spin_columns(), turning_columns(), body_columns(),
                                                           tracked_columns()});
  return table;
}

Columns<RigidSums> rigid_columns(const Solids& solids, const Rigid& rigid) {
  return {rigid_table(), RigidSetting{mesh_setting(solids, {"rigid body"}), rigid.pin.has_value()}};
}

RigidSums sums_of(const RigidRunState& state, const RigidSystem& system) {
  const RigidInertia& inertia = system.body.inertia;
  const RigidColumns& q = state.body.q;
  RigidState motion;
  motion.q = q, motion.v = rigid_velocities(system.body, state.body);
  const Eigen::Vector3d momentum = rigid_linear_momentum(inertia, motion);
  RigidSums s;
  s.time = state.time, s.dt = state.dt_last, s.work = state.work, s.mass = inertia.mass();
  s.kinetic = rigid_kinetic_energy(inertia, state.body);
  s.potential = rigid_potential_energy(inertia, state.body, system.gravity);
  s.total = s.kinetic + s.potential;
  s.momentum = components(momentum), s.angular = components(rigid_angular_momentum(inertia, motion));
  s.omega = components(rigid_angular_velocity(system.body, state.body));
  for (int i = 0; i < 3; ++i) s.directors[static_cast<std::size_t>(i)] = components(q.col(i + 1));
  s.constraint_error = constraint_error(system.body.frame, q);
  if (system.body.pin) s.pin_slip = pin_slip(system.body, q);
  s.bodies = {{s.mass, components(inertia.centre(q)), components(momentum / s.mass)}};
  s.tracked = tracked_of(system.solids, at_nodes(q, system), at_nodes(motion.v, system));
  return s;
}

Snapshot node_fields(const RigidRunState& state, const RigidSystem& system) {
  return motion_fields(state.time, system.solids.mesh, at_nodes(state.body.q, system),
                       at_nodes(rigid_velocities(system.body, state.body), system));
}

}  // namespace tether::fem
