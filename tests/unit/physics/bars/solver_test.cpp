// SPDX-License-Identifier: GPL-3.0-or-later
// What bars do at walls, what their solver writes and saves, and how it stops.
#include "physics/bars/solver.hpp"

#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "physics/points/fields.hpp"
#include "plan/make_plan.hpp"
#include "unit/physics/bars/support.hpp"

namespace tether::fem {
namespace {

using namespace scenes;

/// A string that hangs from the top of the square: its end .5 below, a mass at its lower point.
Scene hanging(Wall wall) {
  Scene scene = fem_scene(20);
  scene.walls.top = wall;
  scene.clock.cfl = 0.2;
  add_string(scene, {E, 0, true}, row(5, 19.5, 0, -1, 2), section, 1e-6);
  scene.points.mass[1] = 2;
  scene.tracked = {0, 1};
  return scene;
}

TEST(BarsToWalls, CarryTheRestOfTheLength) {
  Scene scene = hanging(Wall::fixed);
  scene.gravity = -1;
  RunningBars run(scene);
  const double k = E * section / 1.5, period = 2 * pi * std::sqrt(2 / k);
  run.until(0.5 * period);
  EXPECT_NEAR(run.now("point_y_2"), 18.5 - 2 * 2 / k, 1e-5);
  EXPECT_EQ(run.now("mass"), 2.000001);
}

TEST(BarsToWalls, SlideWhereTheWallHoldsOneComponent) {
  Scene scene = hanging(Wall::free_slip);
  scene.points.vx = {0.5, 0.5};
  RunningBars run(scene);
  run.until(4);
  EXPECT_NEAR(run.now("point_x_2"), 5 + 0.5 * run.now("time"), 1e-10);
  EXPECT_NEAR(run.now("point_y_1"), 19.5, 1e-12);
}

TEST(BarsToWalls, AnEndAtAWallIsHeld) {
  Scene scene = hanging(Wall::fixed);
  scene.points.y = {19.8, 18.8};
  scene.points.vx = {1, 0};
  scene.gravity = -1;
  RunningBars run(scene);
  run.until(1);
  EXPECT_EQ(largest_change(run.column("point_x_1")), 0);
  EXPECT_EQ(largest_change(run.column("point_y_1")), 0);
  EXPECT_EQ(run.column("point_vx_1").front(), 0);
}

TEST(BarSolver, GoesOnFromASavedStateToTheLastBit) {
  Scene scene = free_string(16, 0.9, true);
  scene.gravity = -1, scene.walls.left = Wall::symmetry, scene.points.x[0] = 0.001, scene.clock.tmax = 4.0001;
  for (std::size_t p = 0; p < 16; ++p) scene.points.vx[p] = std::sin(static_cast<double>(p));
  RunningBars whole(scene), first(scene), second(scene);
  whole.until(9), first.until(1.7);
  second.solver().restore(first.solver().save());
  second.until(9);
  EXPECT_EQ(whole.solver().save(), second.solver().save());
  EXPECT_EQ(whole.solver().record(), second.solver().record());
  EXPECT_EQ(whole.solver().counts().steps, second.solver().counts().steps);
}

TEST(BarSolver, RefusesTheStateOfAnotherPathOrScene) {
  RunningBars bars(free_string(16, 0.9, true)), others(free_string(15, 0.9, true));
  Scene scene = free_string(16, 0.9, true);
  scene.physics = MaterialPoints{};
  const Plan plan = make_plan(scene);
  const auto points = make_solver(plan);
  EXPECT_THROW(bars.solver().restore(points->save()), FileError);
  EXPECT_THROW(points->restore(bars.solver().save()), FileError);
  EXPECT_THROW(bars.solver().restore(others.solver().save()), FileError);
}

TEST(BarSolver, HasTheColumnsOfMaterialPoints) {
  Scene scene = free_string(4, 0.9, true);
  scene.tracked = {0, 3}, scene.outputs.tracked_angle = true;
  auto names = RunningBars(scene).solver().history_layout().column_names();
  EXPECT_EQ(std::erase(names, "energy_step"), 1U);
  auto of_points = mpm::history_columns(scene).layout().column_names();
  for (const char* loss : {"energy_transfer", "energy_walls", "energy_integration"})  // which elements do not have
    EXPECT_EQ(std::erase(of_points, loss), 1U);
  EXPECT_EQ(names, of_points);
}

TEST(BarSolver, WritesItsPoints) {
  Scene scene = hanging(Wall::fixed);
  scene.points.syy = {4, 4};
  RunningBars run(scene);
  std::vector<std::string> names;
  for (const Field& field : run.solver().points().fields) {
    names.push_back(field.quantity.name);
    EXPECT_EQ(field.values.size(), 2U) << field.quantity.name;  // the anchor is no point
  }
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "id", "body", "vx", "vy", "mass", "strain", "stress"}));
  EXPECT_NEAR(run.field("strain", 0), 0.01, 1e-15);
  EXPECT_NEAR(run.field("stress", 1), 4, 1e-12);
  EXPECT_EQ(run.field("id", 1), 2);
}

TEST(BarSolver, CountsItsSteps) {
  RunningBars run(level_bar(7.013));
  run.until(8);
  const RunCounts counts = run.solver().counts();
  const double dt = run.plan().step.first_step();
  EXPECT_EQ(counts.steps, static_cast<long long>(std::ceil(7.013 / dt)));
  EXPECT_EQ(counts.point_steps, 10 * counts.steps);
  EXPECT_EQ(counts.dt_min, dt);
  EXPECT_LT(counts.dt_last, dt);
  EXPECT_EQ(run.solver().cells_active(), 0U);
}

TEST(BarSolver, SaysWhereAndWhyItStops) {
  Scene scene = vibrating_bar(12, 0);
  scene.clock.tstep = 0.5;
  try {
    RunningBars(scene).solver().advance(1e6);
    FAIL() << "a step of several times the limit went through";
  } catch (const RunError& error) {
    const std::string text = error.what();
    for (const char* words : {"t = ", "step ", "point ", "(body 1, string)", "of the limit 2/omega", "a step too long"})
      EXPECT_NE(text.find(words), std::string::npos) << words << " in: " << text;
  }
}

TEST(BarSolver, TellsOnceOfAPointBehindAWall) {
  Scene scene = free_string(4, 0.9, true);
  scene.walls.bottom = Wall::free_slip;
  scene.points.vy.assign(4, -2);
  RunningBars run(scene);
  run.until(20);
  const auto messages = run.solver().take_messages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("point 1 (body 1, string) is behind the bottom wall"), std::string::npos) << messages[0];
}

}  // namespace
}  // namespace tether::fem
