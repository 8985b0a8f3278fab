// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "physics/solids/body_doubts.hpp"
#include "physics/solids/system.hpp"
#include "physics/step_clock.hpp"
#include "results/results.hpp"

namespace tether::fem {

/// Where the equations were linearised last, whose factors steps keep while they lead on: a run that goes on from a
/// checkpoint finds the same ones again.
struct LinearisedAt {
  double time = 0, dt = 0;  // dt 0: nowhere yet [time]
  std::vector<double> v0, v1, p;
  std::vector<double> q0, w0, drift;  // of immersed solids, at the start
};

/// What a flow and its bodies have got from outside, have given to heat and the method has lost [energy].
struct FlowExchange {
  double walls = 0;        ///< work of moving walls
  double inflows = 0;      ///< work of inflows, and the kinetic energy that they brought
  double open = 0;         ///< work at open sides, less the kinetic energy that left there
  double body_forces = 0;  ///< work of gravity and body forces on the fluid
  double loads = 0;        ///< work of loads on bodies
  double supports = 0;     ///< work of bodies' supports
  double viscosity = 0;    ///< given to heat
  double stabilised = 0;   ///< lost to what stabilises equal orders
  double advected = 0;     ///< lost by the convective term where velocities are not quite free of divergence
  double immersed = 0;     ///< lost in bodies, by their steps and as they take the fluid's velocity anew
  double stepped = 0;      ///< kinetic energy of the fluid lost by steps of backward Euler
};

/// Of a flow: 2 numbers a node of velocities, 1 of pressures; of immersed solids 2 a node of places.
struct FlowState : StepClock {
  std::vector<double> v;                    ///< velocities at `time`
  std::vector<double> v_before;             ///< velocities at the start of the step that ended there
  std::vector<double> p;                    ///< pressures of the step that ended there
  std::vector<double> force;                ///< of walls on the fluid in that step, at prescribed nodes [force]
  std::vector<double> body_forces, clamps;  ///< of immersed solids in that step: ImmersedForces lists them
  std::vector<double> q, w;                 ///< places and velocities of immersed solids' nodes
  std::vector<double> drift;                ///< their mean velocities over that step
  std::vector<double> tracers;              ///< their places, 2 numbers each
  std::vector<int> tracer_left;             ///< 1 of those that left the mesh
  FlowExchange exchanged;                   ///< so far
  double residual = 0;                      ///< that the last step ended with, over the largest force or flux
  long long newton_steps = 0, factorisations = 0, halvings = 0;
  long long krylov_iterations = 0, krylov_failures = 0;
  long long rounds = 0;     ///< of steady solutions with bodies
  ContactState contact;     ///< of immersed solids
  OverlapCount overlap;     ///< of them
  BodyDoubtNumbers doubts;  ///< of them
  LinearisedAt linearised;
};

/// Lists what a step depends on over saver and restorer alike.
template <class Exchange>
void exchange(Exchange& with, FlowState& state) {
  exchange_clock(with, state);
  with("v", state.v), with("v_before", state.v_before), with("p", state.p), with("force", state.force),
      with("forces_on_bodies", state.body_forces), with("clamps", state.clamps), with("q", state.q), with("w", state.w),
      with("drift", state.drift);
  with("tracers", state.tracers), with("tracer_left", state.tracer_left);
  FlowExchange& all = state.exchanged;
  with("walls", all.walls), with("inflows", all.inflows), with("open", all.open);
  with("body_forces", all.body_forces), with("loads", all.loads), with("supports", all.supports);
  with("viscosity", all.viscosity), with("stabilised", all.stabilised);
  with("advected", all.advected), with("immersed", all.immersed), with("stepped", all.stepped);
  with("residual", state.residual);
  with("newton_steps", state.newton_steps), with("factorisations", state.factorisations),
      with("halvings", state.halvings);
  with("krylov_iterations", state.krylov_iterations), with("krylov_failures", state.krylov_failures),
      with("rounds", state.rounds);
  exchange(with, state.contact), exchange(with, state.overlap), exchange(with, state.doubts);
  LinearisedAt& at = state.linearised;
  with("linearised_time", at.time), with("linearised_dt", at.dt);
  with.list("linearised_v0", at.v0), with.list("linearised_v1", at.v1), with.list("linearised_p", at.p);
  with.list("linearised_q0", at.q0), with.list("linearised_w0", at.w0), with.list("linearised_drift", at.drift);
}

}  // namespace tether::fem
