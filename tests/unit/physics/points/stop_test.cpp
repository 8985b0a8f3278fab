// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/diagnostics.hpp"
#include "plan/make_plan.hpp"
#include "run/make.hpp"
#include "unit/physics/scenes.hpp"

namespace tether {
namespace {

using scenes::add_block;
using scenes::open_scene;

/// What a run of the scene stops with, "" if it does not; at most two steps may pass.
std::string stop_of(Scene scene) {
  const Plan plan = make_plan(std::move(scene));
  const auto solver = make_solver(plan);
  try {
    solver->advance(1.5 * plan.step.deck_step);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

void expect_says(const std::string& text, std::initializer_list<const char*> words) {
  for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

Scene one_point(double x, double vx) {
  Scene scene = open_scene(6, 6);
  add_block(scene, plane_strain(1, 0.3), 2, 3, 2, 3, 1);
  scene.points.x[0] = x, scene.points.vx[0] = vx;
  scene.clock = {10, 0.5, 0};
  return scene;
}

TEST(Stop, APointThatLeavesTheGrid) {
  expect_says(stop_of(one_point(4.9, 0.5)), {"point 1", "body 1, block", "cell (6, 3)",
                                             "left the grid by the right edge (wall 1)", "t = 0.5", "likely cause"});
}

TEST(Stop, APointThatJumpsOverACell) {
  expect_says(stop_of(one_point(0.5, 4.2)),
              {"point 1", "cell (3, 3)", "jumped over a cell", "2.1 cells", "likely cause"});
}

TEST(Stop, ANumberThatIsNoNumberWithinOneStep) {
  Scene scene = one_point(2.5, 0);
  scene.points.vx[0] = std::numeric_limits<double>::quiet_NaN();
  expect_says(stop_of(std::move(scene)), {"point 1", "no finite place", "step 1:"});
}

TEST(Stop, AnInfiniteStressWithinOneStep) {
  Scene scene = one_point(2.5, 0);
  scene.points.sxx[0] = std::numeric_limits<double>::infinity();
  EXPECT_NE(stop_of(std::move(scene)), "");
}

// dt div v below -1 turns the density of (4.7) negative.
TEST(Stop, ANegativeDensity) {
  Scene scene = open_scene(6, 6);
  add_block(scene, IdealGas{.rule = DensityRule::continuity}, 2, 3, 2, 3, 2, 1.0, 1e-12);
  for (std::size_t p = 0; p < 4; ++p) scene.points.vx[p] = -16 * (scene.points.x[p] - 2.5);  // div v = -4
  scene.clock = {10, 0.3, 0};
  expect_says(stop_of(std::move(scene)), {"negative density", "dt div v"});
}

TEST(Stop, AStepTooLongIsNamedAsTheCause) {
  Scene scene = one_point(4.9, 0.5);
  scene.clock.tstep = 3;
  expect_says(stop_of(std::move(scene)), {"3.00 times the limit dx/c", "a step too long"});
}

TEST(Stop, ASoundRunDoesNotStop) { EXPECT_EQ(stop_of(one_point(2.5, 0.1)), ""); }

TEST(Clock, TheLastStepLandsOnTheEnd) {
  Scene scene = one_point(2.5, 0);
  scene.clock = {1.75, 0.5, 0};
  const Plan plan = make_plan(std::move(scene));
  const auto solver = make_solver(plan);
  solver->advance(1e9);
  EXPECT_EQ(solver->time(), 1.75);
  EXPECT_EQ(solver->counts().steps, 4);
  EXPECT_EQ(solver->counts().dt_min, 0.5);  // the cut last step does not count
}

TEST(Clock, RoundingLeavesNoSliverBeforeTheEnd) {
  Scene scene = one_point(2.5, 0);
  scene.clock = {0.3, 0.1, 0};  // .1 + .1 + .1 > .3 in floating point
  const Plan plan = make_plan(std::move(scene));
  const auto solver = make_solver(plan);
  solver->advance(1e9);
  EXPECT_EQ(solver->time(), 0.3);
  EXPECT_EQ(solver->counts().steps, 3);
}

// 87,500 steps of 2e-5 are 1.75: a plain sum of them is short of it by more than a thousandth of a millionth of a step.
TEST(Clock, ManyStepsEndWhereTheirProductSays) {
  Scene scene = one_point(2.5, 0);
  scene.clock = {1.75, 2e-5, 0};
  const Plan plan = make_plan(std::move(scene));
  const auto solver = make_solver(plan);
  solver->advance(1e9);
  EXPECT_EQ(solver->counts().steps, 87500);
  EXPECT_EQ(solver->counts().dt_min, 2e-5);
}

TEST(Clock, AGasThatGrowsFastLimitsTheStepAndSaysSo) {
  Scene scene = open_scene(8, 8);
  add_block(scene, IdealGas{.rule = DensityRule::continuity}, 3, 4, 3, 4, 3, 1.0, 1.0);
  scene.clock = {2, 0.9 / std::sqrt(1.4 * 0.4), 1};
  const Plan plan = make_plan(std::move(scene));
  EXPECT_TRUE(plan.warnings.empty());
  const auto solver = make_solver(plan);
  solver->advance(2);
  const auto messages = solver->take_messages();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("steps are limited"), std::string::npos);
  EXPECT_LT(solver->counts().dt_min, plan.step.deck_step);
  EXPECT_TRUE(solver->take_messages().empty());
}

TEST(Clock, AnotherWarningOfThePlanDoesNotSilenceTheLimit) {
  Scene scene = open_scene(8, 8);
  add_block(scene, IdealGas{.rule = DensityRule::continuity}, 3, 4, 3, 4, 3, 1.0, 1.0);
  scene.clock = {2, 0.9 / std::sqrt(1.4 * 0.4), 1};
  scene.method.order = StressOrder::usl;  // of which the plan warns
  const Plan plan = make_plan(std::move(scene));
  EXPECT_EQ(plan.warnings.size(), 1U);
  const auto solver = make_solver(plan);
  solver->advance(2);
  EXPECT_EQ(solver->take_messages().size(), 1U);
}

}  // namespace
}  // namespace tether
