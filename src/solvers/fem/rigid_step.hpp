// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/fem/rigid_loads.hpp"
#include "solvers/fem/rigid_newton.hpp"
#include "solvers/fem/rigid_state.hpp"

// The mid-point step of a rigid body (35), (dt, M: step and mass matrix; G: gradient of the constraints):
//   q1 - q0 = dt vm,  M (v1 - v0) = dt [F(qm) - G(qm)^T lambda],  Phi(q1) = 0,  qm = (q0 + q1)/2, vm = (v0 + v1)/2.
//
// Kept exactly: Phi is quadratic, Phi(q1) - Phi(q0) = dt G(qm) vm, so that the constraint forces do no work; they have
// no moment either, as Lambda is symmetric. Energy changes by the loads' work dt vm . F, angular momentum by the
// impulse of their torque. A weight's potential is linear and therefore exact.
//
// The velocity does not stay tangent to the constraints. With h_n = G(q_n) v_n and w_n = G(v_n) v_n, from Phi(q1) =
// Phi(q0) and dt vm = q1 - q0,
//   h1 = -h0 + (dt/4) (w1 - w0),
// which a smooth motion follows with h = (dt^2/8) w' beside a part that changes its sign from step to step: a body that
// starts with h0 = 0 has h = 0 and (dt^2/4) w' in turn. Velocities then hold a part (-1)^n U with U = M^-1 G^T mu (the
// multipliers carry it as 2 mu/dt), and the constraint on vm asks for G U' = 0 to leading order: hence U . M U' =
// mu . G U' = 0, U keeps its energy, neither grows nor decays over any number of steps, and as U . M V = mu . G V = 0
// it acts on the mean motion V by its square only, O(dt^4). Multipliers of one step alternate by O(dt); the mean of two
// steps is of second order. P(q_n)^T M U = 0: it has no momenta, and rigid_angular_velocity() does not see it. To
// project v1 on the tangent would take U out, and with it the exact energy balance; so it is left.
//
// What does need care is rounding, which enters U and the momenta undamped. v1 = 2 (q1 - q0)/dt - v0 would feed in the
// rounding of q times 2/dt in each step, and unknowns of the size of dt vm leave a balance that is open by their
// rounding: 1e5 steps lose 1e-11 of the energy, and a hundred times that of the angular momentum with the reference
// point off the centre. Hence the unknowns are the gains vm - v0, of second order in dt, Newton's method goes on until
// rounding stops it, and q and v are summed with compensation, so that Phi does not drift either.
//
// Forces must be those at the middle of the step; their time factors are the caller's. No step allocates or throws.

namespace tether::fem {

/// The step with 12 coordinates and six multipliers, nine where a point is fixed. dt > 0 [time].
RigidReport rigid_constrained_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                                   const RigidNewtonRule& rule = {});

/// The same motion from six unknowns in the null space of the constraints, three where a point is fixed.
RigidReport rigid_reduced_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                               const RigidNewtonRule& rule = {});

}  // namespace tether::fem
