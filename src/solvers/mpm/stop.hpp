// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan/plan.hpp"
#include "solvers/mpm/state.hpp"
#include "solvers/mpm/trouble.hpp"

namespace tether::mpm {

/// Ends the run with a RunError that names point, body, cell, time and likely cause. `dt` is the step that failed.
[[noreturn]] void stop_on_trouble(const State& state, const Plan& plan, const Trouble& trouble, double dt);

/// Ends the run because waves have become so fast that no step is left; `waves` says which, up to their speed.
[[noreturn]] void stop_on_vanishing_step(const State& state, const char* waves, double dt);

}  // namespace tether::mpm
