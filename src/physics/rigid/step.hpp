// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/solids.hpp"
#include "physics/rigid/body.hpp"
#include "physics/rigid/state.hpp"
#include "physics/step_clock.hpp"
#include "results/results.hpp"

namespace tether::fem {

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

/// The step with 12 coordinates and six multipliers, nine where a point is fixed. dt > 0 [time].
RigidReport rigid_constrained_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                                   const RigidNewtonRule& rule = {});

/// Finds the same motion from six unknowns in the null space of the constraints, three where a point is fixed.
RigidReport rigid_reduced_step(const RigidBody& body, const RigidForces& loads, double dt, RigidState& state,
                               const RigidNewtonRule& rule = {});

/// The mesh's bodies as one rigid body, and its loads: what no step changes.
class RigidSystem {
 public:
  /// `gravity` acts along y [length/time2]. Solids and rigid must outlive the system. Throws InputError where the mesh
  /// has no breadth to turn about.
  RigidSystem(const Solids& solids, const Rigid& rigid, double gravity);

  /// All loads of a time, without the weight.
  RigidForces loads(double time) const;
  RigidState start() const;

  const Solids& solids;
  const Rigid& rigid;
  Eigen::Vector3d gravity;
  RigidBody body;
  RigidForces weight;
  Eigen::Matrix<double, 4, Eigen::Dynamic> nodes;  ///< [1, theta] of each node: its place is q times that (18)

 private:
  struct Load {
    RigidForces forces;
    const Amplitude* amplitude;
  };
  std::vector<Load> loads_;
};

/// Of a rigid body and its run.
struct RigidRunState : StepClock {
  RigidState body;
  double work = 0;  ///< done by the loads so far, without the weight's [energy]
  long long newton_steps = 0, halvings = 0;
};

template <class Exchange>
void exchange(Exchange& with, const char* name, RigidColumns& columns) {
  std::vector<double> numbers(columns.data(), columns.data() + columns.size());
  with(name, numbers);
  std::copy(numbers.begin(), numbers.end(), columns.data());
}

/// Lists what a step depends on over saver and restorer alike.
template <class Exchange>
void exchange(Exchange& with, RigidRunState& state) {
  exchange(with, "q", state.body.q), exchange(with, "v", state.body.v);
  exchange(with, "lost_q", state.body.lost_q), exchange(with, "lost_v", state.body.lost_v);
  exchange_clock(with, state);
  with("work", state.work), with("newton_steps", state.newton_steps), with("halvings", state.halvings);
}

}  // namespace tether::fem
