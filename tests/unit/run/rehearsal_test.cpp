// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/rehearsal.hpp"

#include <gtest/gtest.h>

#include "plan/make_plan.hpp"
#include "run/make.hpp"
#include "unit/physics/scenes.hpp"

namespace tether {
namespace {

Scene block_until(double tmax) {
  Scene scene = scenes::open_scene(11, 11);
  scenes::add_block(scene, plane_strain(1, 0.3), 3, 7, 3, 6, 2);
  scenes::stir(scene, 0.02);
  scene.clock.tmax = tmax;
  scene.outputs.history = tmax / 4;
  return scene;
}

/// A run that is over within the trial is counted, not extrapolated.
TEST(Rehearsal, CountsTheStepsOfAShortRun) {
  const Plan plan = rehearsed(make_plan(block_until(1.01)));  // 20 steps of .05 and a short one
  EXPECT_EQ(plan.cost.rehearsed, 21);
  EXPECT_EQ(plan.cost.steps, 21);
  EXPECT_EQ(plan.cost.point_steps, 21.0 * 48);
  EXPECT_GT(plan.cost.megabytes, 1);
  EXPECT_GT(plan.cost.seconds, 0);
}

/// A longer one is carried on to its end.
TEST(Rehearsal, CarriesALongRunOn) {
  Scene scene = block_until(1e5);
  scene.points.vx.assign(scene.points.size(), 0),
      scene.points.vy = scene.points.vx;  // or the block would leave the grid
  const Plan plan = rehearsed(make_plan(std::move(scene)));
  EXPECT_GE(plan.cost.rehearsed, 6);
  EXPECT_LT(plan.cost.rehearsed, 2'000'000);
  EXPECT_NEAR(plan.cost.steps, 2e6, 2);
  EXPECT_NEAR(plan.cost.point_steps, 2e6 * 48, 100);
}

/// What follows does not depend on it.
TEST(Rehearsal, LeavesTheSceneAsItIs) {
  const Plan before = make_plan(block_until(1.01)), after = rehearsed(before);
  const auto one = make_solver(before), other = make_solver(after);
  one->advance(1), other->advance(1);
  EXPECT_EQ(one->record(), other->record());
}

TEST(Rehearsal, SaysWhereTheFirstStepsFail) {
  Scene scene = block_until(100);
  for (double& vx : scene.points.vx) vx = 50;  // out of the grid at once
  const Plan plan = rehearsed(make_plan(std::move(scene)));
  ASSERT_FALSE(plan.warnings.empty());
  EXPECT_NE(plan.warnings.back().find("the first steps, made on trial, fail: "), std::string::npos);
  EXPECT_EQ(plan.cost.rehearsed, 0);
}

}  // namespace
}  // namespace tether
