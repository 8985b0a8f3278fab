// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "results/saved_state.hpp"
#include "solvers/fem/overlap_count.hpp"
#include "solvers/fem/told_doubts.hpp"

namespace tether::fem {

/// Of elastic bodies; dim numbers a node.
struct SolidState {
  double time = 0, time_lost = 0;  ///< time_lost: what compensated summation owes [time]
  std::vector<double> q, v;        ///< places [length] and velocities of the nodes
  std::vector<double> a;           ///< accelerations, of central differences only [length/time2]
  double of_loads = 0;             ///< work that loads have done so far [energy]
  double of_supports = 0;          ///< work of supports and walls that lead nodes [energy]
  double damped = 0;               ///< taken by damping so far [energy]
  double residual = 0;             ///< that Newton's method ended the last step with, over the largest force
  double dt_last = 0, dt_min = 0;  ///< [time]
  long long steps = 0, newton_steps = 0, halvings = 0;
  OverlapCount overlap;
  ToldDoubts told;
};

/// Lists what a step depends on over saver and restorer alike.
template <class Exchange>
void exchange(Exchange& with, SolidState& state) {
  with("time", state.time), with("time_lost", state.time_lost);
  with("q", state.q), with("v", state.v), with("a", state.a);
  with("of_loads", state.of_loads), with("of_supports", state.of_supports), with("damped", state.damped);
  with("residual", state.residual);
  with("dt_last", state.dt_last), with("dt_min", state.dt_min);
  with("steps", state.steps), with("newton_steps", state.newton_steps), with("halvings", state.halvings);
  exchange(with, state.overlap), exchange(with, state.told);
}

}  // namespace tether::fem
