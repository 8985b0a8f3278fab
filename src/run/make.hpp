// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "fields/column_text.hpp"
#include "physics/solver.hpp"
#include "plan/plan.hpp"

namespace tether {

/// The solver of the plan's path on so many threads: the only place where run-time choices become templates. The plan
/// must outlive it.
std::unique_ptr<Solver> make_solver(const Plan& plan, int threads = 1);
/// Does the same with a solver that takes material points out of the plan's scene, so that they are not in memory
/// twice.
std::unique_ptr<Solver> make_solver_with_points_of(Plan& plan, int threads = 1);

/// Returns whether the plan's path can share its work among threads.
bool shares_work(const Plan& plan);
/// The threads that a run takes: as many as were asked for; where none were (0), one for each core if the work is worth
/// it, else one. One where the path does not share its work.
int threads_for(const Plan& plan, int asked);

/// The columns that histories may have, physics by physics.
std::vector<PhysicsColumns> columns_of_all_physics();

}  // namespace tether
