// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/make.hpp"

#include "solvers/coupled/coupled_solver.hpp"
#include "solvers/fem/bar_solver.hpp"
#include "solvers/fem/flow_solver.hpp"
#include "solvers/fem/rigid_solver.hpp"
#include "solvers/fem/solid_solver.hpp"
#include "solvers/mpm/solver.hpp"

namespace tether {
namespace {

/// The solver of each physics.
struct MakeSolver {
  const Plan& plan;
  std::unique_ptr<Solver> operator()(const MaterialPoints&) const { return std::make_unique<mpm::MpmSolver>(plan); }
  std::unique_ptr<Solver> operator()(const Bars&) const { return std::make_unique<fem::BarSolver>(plan); }
  std::unique_ptr<Solver> operator()(const ElasticBodies&) const { return std::make_unique<fem::SolidSolver>(plan); }
  std::unique_ptr<Solver> operator()(const RigidBody&) const { return std::make_unique<fem::RigidSolver>(plan); }
  std::unique_ptr<Solver> operator()(const MeshFlow&) const { return std::make_unique<fem::FlowSolver>(plan); }
  std::unique_ptr<Solver> operator()(const BoxFlow&) const { return std::make_unique<coupled::CoupledSolver>(plan); }
};

}  // namespace

std::unique_ptr<Solver> make_solver(const Plan& plan) { return std::visit(MakeSolver{plan}, plan.scene.physics); }

}  // namespace tether
