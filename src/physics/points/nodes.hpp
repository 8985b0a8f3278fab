// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "physics/points/steps.hpp"

namespace tether::mpm {

// What a step does at the nodes; nothing here knows kernels.

/// Whether sums over points are asked once more after the solve.
enum class Sums { kept, cleared };

/// (mv)^L = (mv) + dt f, with the body force m b (3.17), (3.19), (3.20), walls, and the sums of the balance of energy.
void solve_momentum(StepWork& work, double dt, Sums after);
/// The first of it for bodies that share nodes.
void solve_common_field(StepWork& work, double dt);
/// And the last, with each body's own fields at such nodes.
void total_with_contact(StepWork& work, double dt);

/// v_i = sum m_p v_p N_i / m_i from the momenta that points gave to `convected` (3.24), walls; the sums are 0 then.
void divide_convected(State& state);
/// Finds the same quotient from the momenta mapped at the start of the step.
void mapped_velocity(State& state);

void clear_convected(State& state);
void clear_sums(State& state);
void clear_forces(State& state);

/// The list of nodes, and all sums, from where the points are now: for points that came, went or were moved
/// outside a step. Heat under way at nodes that no point reaches any more has gone with the gas that was there.
void map_anew(State& state, const Scene& scene, const StepSet& set);
/// Clears what has to go before: sums at the nodes of the step, and at those that its points have reached by now.
void forget_sums(State& state, const StepSet& set);

/// Density of the gas at the nodes from its mass there.
void gas_at_nodes(State& state);
/// Books energy that was lost away from the gas as heat of all gas alike.
void give_to_all_gas(State& state, double energy);
/// The heat has been taken.
void clear_heat(State& state);
/// |v|^2 before and after the solve, for the ledger.
void note_squares(State& state);

}  // namespace tether::mpm
