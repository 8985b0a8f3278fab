// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/make.hpp"

#include <algorithm>
#include <thread>
#include <utility>
#include <variant>

#include "model/find_strip.hpp"
#include "physics/bars/fields.hpp"
#include "physics/bars/solver.hpp"
#include "physics/box/columns.hpp"
#include "physics/box/solver.hpp"
#include "physics/flow/columns.hpp"
#include "physics/flow/solver.hpp"
#include "physics/points/fields.hpp"
#include "physics/points/solver.hpp"
#include "physics/rigid/fields.hpp"
#include "physics/rigid/solver.hpp"
#include "physics/solids/fields.hpp"
#include "physics/solids/solver.hpp"

namespace tether {
namespace {

/// A step of less takes little more time than threads need to come together.
constexpr std::size_t points_worth_threads = 10000, elements_worth_threads = 1000, cells_worth_threads = 4000;

struct WorthThreads {
  const Plan& plan;
  bool operator()(const MaterialPoints&) const { return points_that_run(plan.scene) >= points_worth_threads; }
  bool operator()(const Bars&) const { return false; }
  bool operator()(const ElasticBodies& bodies) const {
    return bodies.solids->mesh.element_count() >= elements_worth_threads;
  }
  bool operator()(const RigidBody&) const { return false; }
  bool operator()(const MeshFlow& flow) const { return flow.flow->mesh.element_count() >= elements_worth_threads; }
  bool operator()(const BoxFlow& box) const { return box.box->grid.cell_count() >= cells_worth_threads; }
};

/// The solver of each physics.
struct MakeSolver {
  const Plan& plan;
  int threads;
  std::unique_ptr<Solver> operator()(const MaterialPoints&) const {
    return std::make_unique<mpm::MpmSolver>(plan, threads);
  }
  std::unique_ptr<Solver> operator()(const Bars&) const { return std::make_unique<fem::BarSolver>(plan); }
  std::unique_ptr<Solver> operator()(const ElasticBodies&) const {
    return std::make_unique<fem::SolidSolver>(plan, threads);
  }
  std::unique_ptr<Solver> operator()(const RigidBody&) const { return std::make_unique<fem::RigidSolver>(plan); }
  std::unique_ptr<Solver> operator()(const MeshFlow&) const { return std::make_unique<fem::FlowSolver>(plan, threads); }
  std::unique_ptr<Solver> operator()(const BoxFlow&) const {
    return std::make_unique<coupled::CoupledSolver>(plan, threads);
  }
};

}  // namespace

std::unique_ptr<Solver> make_solver(const Plan& plan, int threads) {
  return std::visit(MakeSolver{plan, threads}, plan.scene.physics);
}

std::unique_ptr<Solver> make_solver_with_points_of(Plan& plan, int threads) {
  if (!std::holds_alternative<MaterialPoints>(plan.scene.physics)) return make_solver(plan, threads);
  return std::make_unique<mpm::MpmSolver>(plan, std::move(plan.scene.points), threads);
}

bool shares_work(const Plan& plan) {
  return !std::holds_alternative<Bars>(plan.scene.physics) && !std::holds_alternative<RigidBody>(plan.scene.physics);
}

int threads_for(const Plan& plan, int asked) {
  if (!shares_work(plan)) return 1;
  if (asked > 0) return asked;
  if (!std::visit(WorthThreads{plan}, plan.scene.physics)) return 1;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::vector<PhysicsColumns> columns_of_all_physics() {
  return {{"points", mpm::history_table().described()}, {"bars", fem::bar_table().described()},
          {"bodies", fem::solid_table().described()},   {"rigid body", fem::rigid_table().described()},
          {"flows", fem::flow_table().described()},     {"boxes", coupled::coupled_table().described()}};
}

}  // namespace tether
