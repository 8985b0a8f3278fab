// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/rigid_fields.hpp"

#include <fmt/format.h>

#include "solvers/fem/mesh_fields.hpp"

namespace tether::fem {
namespace {

/// Of columns q or v at all nodes, three numbers a node (18).
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

void append(const Eigen::Ref<const Eigen::VectorXd>& numbers, Record& record) {
  record.insert(record.end(), numbers.begin(), numbers.end());
}

}  // namespace

HistoryLayout history_layout(const Solids& solids, const Rigid& rigid) {
  HistoryLayout layout;
  add_energies(layout);
  layout.quantities.push_back(
      {"energy_loads", Dimension::energy, "work that loads have done on the body", Per::scene, Book::gained});
  add_momenta(layout, 3);
  add_vector(layout, "omega_", Dimension::rate, "angular velocity, ", 3);
  for (int i = 1; i <= 3; ++i)
    add_vector(layout, fmt::format("director_{}_", i), Dimension::length, fmt::format("director {}, ", i), 3);
  layout.quantities.push_back(
      {"constraint_error", Dimension::number, "largest change of a length or an angle of the directors"});
  if (rigid.pin) layout.quantities.push_back({"pin_slip", Dimension::length, "way of the pinned place"});
  add_bodies_and_nodes(layout, solids, {"rigid body"});
  return layout;
}

Record record(const RigidRunState& state, const RigidSystem& system) {
  const RigidInertia& inertia = system.body.inertia;
  const RigidColumns& q = state.body.q;
  RigidState motion;
  motion.q = q, motion.v = rigid_velocities(system.body, state.body);
  const double kinetic = rigid_kinetic_energy(inertia, state.body), mass = inertia.mass();
  const double potential = rigid_potential_energy(inertia, state.body, system.gravity);
  Record values{state.time, state.dt_last, kinetic, 0, 0, potential, kinetic + potential, state.work, mass};
  append(rigid_linear_momentum(inertia, motion), values);
  append(rigid_angular_momentum(inertia, motion), values);
  append(rigid_angular_velocity(system.body, state.body), values);
  for (int i = 1; i <= 3; ++i) append(q.col(i), values);
  values.push_back(constraint_error(system.body.frame, q));
  if (system.body.pin) values.push_back(pin_slip(system.body, q));
  append(inertia.centre(q), values);
  append(rigid_linear_momentum(inertia, motion) / mass, values);
  values.push_back(mass);
  append_tracked(system.solids, at_nodes(q, system), at_nodes(motion.v, system), values);
  return values;
}

Snapshot node_fields(const RigidRunState& state, const RigidSystem& system) {
  return motion_fields(state.time, system.solids.mesh, at_nodes(state.body.q, system),
                       at_nodes(rigid_velocities(system.body, state.body), system));
}

}  // namespace tether::fem
