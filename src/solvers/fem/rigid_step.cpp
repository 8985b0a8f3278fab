// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fem/rigid_step.hpp"

#include "solvers/fem/rigid_constrained.hpp"
#include "solvers/fem/rigid_middle.hpp"
#include "solvers/fem/rigid_reduced.hpp"

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

}  // namespace tether::fem
