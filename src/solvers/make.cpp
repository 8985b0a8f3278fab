// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/make.hpp"

#include "solvers/mpm/solver.hpp"

namespace tether {

std::unique_ptr<Solver> make_solver(const Plan& plan) { return std::make_unique<mpm::MpmSolver>(plan); }

}  // namespace tether
