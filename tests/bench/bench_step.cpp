// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of a point-step: a drifting, vibrating elastic block (or gas) of 4 points a cell on a square grid.
#include <benchmark/benchmark.h>

#include <cmath>

#include "plan/make_plan.hpp"
#include "plan/plan.hpp"
#include "read/method.hpp"
#include "run/make.hpp"

namespace {

using namespace tether;

/// The block starts again before it reaches the edge [time].
constexpr double longest_drift = 400;

Method of_order(StressOrder order) {
  Method method;
  method.order = order;
  return method;
}

Scene block(int cells, Material material, const Method& method) {
  Scene scene;
  scene.grid = BackgroundGrid(2 * cells + 1, cells + 3, 0, 2.0 * cells, 0, cells + 2.0);
  scene.walls = {Wall::open, Wall::open, Wall::open, Wall::open};
  PointSet& P = scene.points;
  for (int j = 2; j < 2 * cells; ++j) {
    for (int i = 2; i < 2 * cells; ++i) {
      const double x = 0.5 * i + 0.25, y = 0.5 * j + 0.25;
      P.x.push_back(x), P.y.push_back(y);
      P.vx.push_back(0.02 + 0.001 * std::sin(0.1 * x)), P.vy.push_back(0.001 * std::cos(0.1 * y));
      for (auto* zero : {&P.sxx, &P.syy, &P.sxy}) zero->push_back(0);
      P.volume.push_back(0.25), P.mass.push_back(0.25);
    }
  }
  scene.bodies.push_back({"block", material, 1.0, 1e-6, 0, P.size()});  // a gas so cold that it keeps its place
  scene.clock = {1e9, 0.1, 1};
  scene.method = method;
  return scene;
}

void run(benchmark::State& bench, Material material, const Method& method) {
  const Plan plan = make_plan(block(static_cast<int>(bench.range(0)), material, method));
  auto solver = make_solver(plan);
  long long point_steps = 0;
  for (auto _ : bench) {
    if (solver->time() > longest_drift) {
      bench.PauseTiming();
      solver = make_solver(plan);
      bench.ResumeTiming();
    }
    solver->advance(solver->time() + plan.step.deck_step * 0.5);
    point_steps += static_cast<long long>(plan.scene.points.size());
  }
  bench.counters["point_steps"] = benchmark::Counter(static_cast<double>(point_steps), benchmark::Counter::kIsRate);
}

void elastic_musl(benchmark::State& bench) { run(bench, plane_strain(1.0, 0.3), of_order(StressOrder::musl)); }
void elastic_usf(benchmark::State& bench) { run(bench, plane_strain(1.0, 0.3), of_order(StressOrder::usf)); }
void elastic_usl(benchmark::State& bench) { run(bench, plane_strain(1.0, 0.3), of_order(StressOrder::usl)); }
void gas_continuity(benchmark::State& bench) {
  run(bench, IdealGas{.rule = DensityRule::continuity}, of_order(StressOrder::musl));
}
void gas_quadratic(benchmark::State& bench) {
  run(bench, IdealGas{.rule = DensityRule::quadratic}, of_order(StressOrder::musl));
}
void elastic_robust(benchmark::State& bench) { run(bench, plane_strain(1.0, 0.3), robust_set()); }
void gas_robust(benchmark::State& bench) {
  run(bench, IdealGas{.lambda = 1, .coef1 = 1, .coef2 = 1, .rule = DensityRule::grid, .local_speed = true},
      robust_set());
}

BENCHMARK(elastic_musl)->Arg(16)->Arg(160)->Arg(500);
BENCHMARK(elastic_usf)->Arg(160);
BENCHMARK(elastic_usl)->Arg(160);
BENCHMARK(gas_continuity)->Arg(160);
BENCHMARK(gas_quadratic)->Arg(160);
BENCHMARK(elastic_robust)->Arg(160);
BENCHMARK(gas_robust)->Arg(160);

}  // namespace

BENCHMARK_MAIN();
