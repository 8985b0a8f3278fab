// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "plan/plan.hpp"
#include "solvers/solver.hpp"

namespace tether {

/// The solver of the plan's path: the only place where run-time choices become templates. The plan must outlive it.
std::unique_ptr<Solver> make_solver(const Plan& plan);

}  // namespace tether
