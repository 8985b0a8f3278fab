// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/rigid/step.hpp"

#include <Eigen/Geometry>

#include "base/vec.hpp"
#include "physics/rigid/constrained.hpp"
#include "physics/rigid/reduced.hpp"
#include "physics/rigid/state.hpp"
#include "physics/solids/make_elements.hpp"
#include "physics/solids/side_pressure.hpp"

namespace tether::fem {
namespace {

template <class System>
RigidReport step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                 const RigidNewtonRule& rule) {
  const RigidMiddle middle(body, loads, state, dt);
  const System system(middle);
  typename System::Vector x = system.start();
  RigidReport report;
  rigid_newton(system, x, rule, report);
  if (!report.converged) return report;
  const RigidIncrements both = system.increments(x);
  const RigidColumns F = rigid_generalized_forces(middle.forces, middle.q + both.half_step);
  report.omega = 2 / dt * system.half_turn(x);
  // The step is 2 s, and F holds (dt/2)^2.
  report.work = 8 / (dt * dt) * body.unit_of_inertia * F.cwiseProduct(both.half_step).sum();
  rigid_advance(body, both, dt, state);
  return report;
}

}  // namespace

RigidReport rigid_constrained_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                                   const RigidNewtonRule& rule) {
  return body.pin ? step<RigidConstrained<3>>(body, loads, dt, state, rule)
                  : step<RigidConstrained<0>>(body, loads, dt, state, rule);
}

RigidReport rigid_reduced_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                               const RigidNewtonRule& rule) {
  return body.pin ? step<RigidReduced<true>>(body, loads, dt, state, rule)
                  : step<RigidReduced<false>>(body, loads, dt, state, rule);
}

namespace {

/// The centre of the mass that nodes have by the row sums of their consistent mass matrix.
Eigen::Vector3d centre_of(const Mesh& mesh, const SparseMatrix& mass) {
  std::vector<double> weights(mesh.node_count());
  mass.multiply(std::vector<double>(weights.size(), 1.0), weights);
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    first += weights[n] * Eigen::Vector3d(&mesh.x[3 * n]);
    total += weights[n];
  }
  return first / total;
}

RigidInertia inertia_of(const RigidFrame& frame, const Mesh& mesh, const SparseMatrix& mass) {
  std::vector<std::size_t> row(mass.row.begin(), mass.row.end()), column(mass.row.size());
  for (std::size_t b = 0; b < mesh.node_count(); ++b) {
    for (auto k = static_cast<std::size_t>(mass.start[b]); k < static_cast<std::size_t>(mass.start[b + 1]); ++k)
      column[k] = b;
  }
  return rigid_inertia(frame, mesh.x, RigidNodalMass{row, column, mass.value});  // (25)
}

RigidBody body_of(const Rigid& rigid, const Mesh& mesh, const SparseMatrix& mass) {
  const RigidFrame frame{rigid.point ? *rigid.point : centre_of(mesh, mass), rigid.directors};
  const RigidInertia inertia = inertia_of(frame, mesh, mass);
  return rigid.pin ? rigid_body(frame, inertia, *rigid.pin) : rigid_body(frame, inertia);
}

/// A dead load on the sides or in the volume of a mesh, by its parts at the nodes [area] or [volume] (26)-(28).
RigidForces spread_load(const RigidFrame& frame, const Mesh& mesh, const std::vector<double>& parts,
                        const Vec<3>& force) {
  std::vector<double> forces(mesh.x.size());
  for (std::size_t k = 0; k < forces.size(); ++k) forces[k] = parts[k / 3] * force[k % 3];
  return rigid_point_forces(frame, mesh.x, forces, RigidDirection::fixed);
}

RigidForces force_at_point(const RigidFrame& frame, const RigidForce& force) {
  return rigid_point_forces(frame, {force.at.data(), 3}, {force.force.data(), 3},
                            force.turning ? RigidDirection::turning : RigidDirection::fixed);
}

/// A pressure's forces turn with the body.
RigidForces pressure_load(const RigidFrame& frame, const Mesh& mesh, const Load& load) {
  std::vector<double> f(mesh.x.size(), 0.0);
  SidePressure(mesh, load.sides).add_forces(StressAt::end, mesh.x, mesh.x, load.pressure, f);
  RigidForces sum;
  for (std::size_t n = 0; n < mesh.node_count(); ++n)
    sum.add(rigid_point_forces(frame, std::span(mesh.x).subspan(3 * n, 3), std::span(f).subspan(3 * n, 3),
                               RigidDirection::turning),
            1);
  return sum;
}

}  // namespace

RigidSystem::RigidSystem(const Solids& of, const Rigid& as, double gravity_y)
    : solids(of), rigid(as), gravity(0, gravity_y, 0), nodes(4, of.mesh.node_count()) {
  Team alone;
  const auto elements = make_elements(solids, alone);
  body = body_of(rigid, solids.mesh, elements->mass());
  weight = rigid_gravity(body.inertia, gravity);
  for (std::size_t n = 0; n < solids.mesh.node_count(); ++n)
    nodes.col(static_cast<Eigen::Index>(n)) << 1, body.frame.convective(Eigen::Vector3d(&solids.mesh.x[3 * n]));
  for (const tether::Load& load : solids.loads) {
    const auto parts = load_parts(load, solids.mesh, *elements);
    if (load.is_dead()) loads_.push_back({spread_load(body.frame, solids.mesh, parts, load.force), &load.amplitude});
    if (load.pressure != 0) loads_.push_back({pressure_load(body.frame, solids.mesh, load), &load.amplitude});
  }
  for (const RigidTorque& torque : rigid.torques) loads_.push_back({rigid_torque(torque.torque), &torque.amplitude});
  for (const RigidForce& force : rigid.forces) {
    loads_.push_back({force_at_point(body.frame, force), &force.amplitude});
  }
}

RigidForces RigidSystem::loads(double time) const {
  RigidForces sum;
  for (const Load& load : loads_) sum.add(load.forces, load.amplitude->at(time));
  return sum;
}

RigidState RigidSystem::start() const {
  if (body.pin) return rigid_start(body, rigid.omega);
  const RigidColumns q = body.frame.columns();
  const Eigen::Vector3d arm = q.col(0) - body.inertia.centre(q);
  return rigid_start(body, rigid.velocity + rigid.omega.cross(arm), rigid.omega);
}

}  // namespace tether::fem
