// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/make.hpp"

#include "solvers/coupled/coupled_solver.hpp"
#include "solvers/fem/bar_solver.hpp"
#include "solvers/fem/flow_solver.hpp"
#include "solvers/fem/rigid_solver.hpp"
#include "solvers/fem/solid_solver.hpp"
#include "solvers/mpm/solver.hpp"

namespace tether {

std::unique_ptr<Solver> make_solver(const Plan& plan) {
  if (plan.scene.coupled) return std::make_unique<coupled::CoupledSolver>(plan);
  if (plan.scene.flow) return std::make_unique<fem::FlowSolver>(plan);
  if (plan.scene.rigid) return std::make_unique<fem::RigidSolver>(plan);
  if (plan.scene.solids) return std::make_unique<fem::SolidSolver>(plan);
  if (runs_as_bars(plan.scene)) return std::make_unique<fem::BarSolver>(plan);
  return std::make_unique<mpm::MpmSolver>(plan);
}

}  // namespace tether
