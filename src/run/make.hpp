// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "fields/column_text.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether {

/// The solver of the plan's path: the only place where run-time choices become templates. The plan must outlive it.
std::unique_ptr<Solver> make_solver(const Plan& plan);
/// The same by a solver that takes material points out of the plan's scene, so that they are not in memory twice.
std::unique_ptr<Solver> make_solver_with_points_of(Plan& plan);

/// The columns that histories may have, physics by physics.
std::vector<PhysicsColumns> columns_of_all_physics();

}  // namespace tether
