// SPDX-License-Identifier: GPL-3.0-or-later
// Two bars that stick (A.1.2), the noise of a point that changes cells (A.2), and a standing wave in a bar.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/run_deck.hpp"
#include "plan/make_plan.hpp"
#include "plan/plan.hpp"
#include "run/make.hpp"

namespace tether::cases {
namespace {

// In the last record, t = .501: the bars rebound and meet again, and when they do depends on the step to the last bit.
// What depends less: without release they never part for good, so their mean velocities since the impact are close
// (measured .93 and 1.07; bars that part go at .05 and 1.95).
TEST(TwoBar, TheyStickWithoutRelease) {
  const DeckRun run = run_deck("two-bar-stick");
  const double left = run.last("body_vx_1"), right = run.last("body_vx_2");
  EXPECT_NEAR(left, 1, 0.01);
  EXPECT_NEAR(right, 1, 0.01);
  const auto time = run.history.column("time"), x = run.history.column("body_x_1");
  const auto met = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), 0.15) - time.begin());
  EXPECT_NEAR((x.back() - x[met]) / (time.back() - time[met]), 1, 0.1);
}

TEST(TwoBar, MomentumIsKept) {
  const DeckRun run = run_deck("two-bar-stick");
  const auto px = run.history.column("momentum_x"), py = run.history.column("momentum_y");
  for (std::size_t k = 0; k < px.size(); ++k) {
    EXPECT_NEAR(px[k], px[0], 1e-12 * px[0]);
    EXPECT_NEAR(py[k], 0, 1e-12 * px[0]);
  }
  EXPECT_EQ(run.summary.at("mass_drift"), 0);
}

/// Force of the row of two nodes at height y, by record.
std::vector<double> row_forces(const DeckRun& run, double y) {
  const std::string file = run.folder + "/mesh.nc";
  const auto heights = read_variable(file, "node_y"), columns = read_variable(file, "node_x");
  const auto force = read_variable(file, "force_y");
  const std::size_t row = static_cast<std::size_t>(std::lround(y / (heights[1] - heights[0])));
  std::vector<double> sums;
  for (std::size_t at = 0; at < force.size(); at += heights.size() * columns.size()) {
    sums.push_back(force[at + row * columns.size()] + force[at + row * columns.size() + 1]);
  }
  return sums;
}

// Figs. 103 and 104: 111 before; -3940 and 5123 once point 6 is in the cell below.
TEST(Noise, ForcesBeforeAndAfterAPointChangesCell) {
  const DeckRun run = run_deck("noise", {"in.tmax=1.8e-5"});
  const auto middle = row_forces(run, 1.8), below = row_forces(run, 1.7);
  EXPECT_GT(run.history.column("point_y_1")[0], 1.8);
  EXPECT_LT(run.history.column("point_y_1")[1], 1.8);
  EXPECT_NEAR(middle[0], 111, 0.02 * 111);
  EXPECT_NEAR(middle[1], -3940, 0.02 * 3940);
  EXPECT_NEAR(below[1], 5123, 0.02 * 5123);
}

/// Bar of length 1 between fixed walls, one cell high, in its first mode; returns the largest error of the points'
/// velocities after `periods` periods over the amplitude.
double standing_wave_error(int cells, StressOrder order) {
  constexpr double v0 = 1e-4;
  Scene scene;
  const double h = 1.0 / cells;
  scene.grid = BackgroundGrid(cells + 1, 2, 0, 1, 0, h);
  scene.walls = {Wall::fixed, Wall::fixed, Wall::free_slip, Wall::free_slip};
  PointSet& P = scene.points;
  for (int k = 0; k < 4 * cells; ++k) {
    const double x = h * (k / 4 + 0.25 + 0.5 * (k % 2)), y = h * (0.25 + 0.5 * (k / 2 % 2));
    P.x.push_back(x), P.y.push_back(y);
    P.vx.push_back(v0 * std::sin(std::numbers::pi * x)), P.vy.push_back(0);
    for (auto* zero : {&P.sxx, &P.syy, &P.sxy}) zero->push_back(0);
    P.volume.push_back(h * h / 4), P.mass.push_back(h * h / 4);
  }
  scene.bodies.push_back({"bar", plane_strain(1, 0), 1, 0, 0, P.size()});
  constexpr double tmax = 2.125;  // c = 1 and the period is 2: a sixteenth into the second, with some strain in it
  scene.clock = {tmax, 0.02 * h, 1};
  scene.method.order = order;
  const Plan plan = make_plan(std::move(scene));
  const auto solver = make_solver(plan);
  solver->advance(tmax);
  const Snapshot end = solver->points();
  const auto vx =
      std::find_if(end.fields.begin(), end.fields.end(), [](const Field& f) { return f.quantity.name == "vx"; });
  double error = 0;
  for (std::size_t p = 0; p < plan.scene.points.size(); ++p) {
    const double exact = v0 * std::sin(std::numbers::pi * plan.scene.points.x[p]) * std::cos(std::numbers::pi * tmax);
    error = std::max(error, std::abs(vx->values[p] - exact) / v0);
  }
  return error;
}

TEST(StandingWave, SecondOrderInTheCell) {
  for (const StressOrder order : {StressOrder::musl, StressOrder::usf}) {
    const double coarse = standing_wave_error(8, order), middle = standing_wave_error(16, order),
                 fine = standing_wave_error(32, order);
    RecordProperty("errors", std::to_string(coarse) + " " + std::to_string(middle) + " " + std::to_string(fine));
    EXPECT_LT(fine, 4e-3);
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.3);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.3);
  }
}

}  // namespace
}  // namespace tether::cases
