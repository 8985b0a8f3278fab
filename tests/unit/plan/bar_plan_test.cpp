// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "base/diagnostics.hpp"
#include "plan/make_plan.hpp"
#include "plan/plan.hpp"
#include "plan/plan_text.hpp"
#include "unit/read/points/bars_support.hpp"

namespace tether {
namespace {

/// k = 200 and masses .5: omega = 2 sqrt(k / m) = 40 between two moving points, so that the limit is .05.
Scene string_scene() {
  Scene scene = scenes::fem_scene(10);
  scenes::add_string(scene, {100, 0, true}, scenes::row(2, 2, 0.5, 0, 4), 0.5, 0.5);
  scene.clock = {1, 0.1, 0.5};
  return scene;
}

TEST(BarPlan, TheStepIsLimitedByTheHighestFrequency) {
  const Plan plan = make_plan(string_scene());
  EXPECT_DOUBLE_EQ(plan.step.first_limit, 0.05);
  EXPECT_DOUBLE_EQ(plan.step.first_step(), 0.025);
  EXPECT_EQ(plan.warnings, std::vector<std::string>{"the deck's step 0.1 is 2.00 times the limit 2/omega = 0.05: steps "
                                                    "are limited to 0.025, which is cfl = 0.5 times that"});
  EXPECT_EQ(plan.cost.steps, 40);
  EXPECT_EQ(plan.cost.point_steps, 160);
}

TEST(BarPlan, AFactorOfZeroTakesTheDecksStep) {
  Scene scene = string_scene();
  scene.clock.cfl = 0;
  const Plan plan = make_plan(scene);
  EXPECT_EQ(plan.step.first_step(), 0.1);
  EXPECT_EQ(plan.warnings,
            std::vector<std::string>{
                "the deck's step 0.1 is 2.00 times the limit 2/omega = 0.05 and taken as it is (cfl = 0)"});
}

TEST(BarPlan, StepsBelowTheLimitAreNotTold) {
  Scene scene = string_scene();
  scene.clock.tstep = 0.02;
  EXPECT_EQ(make_plan(scene).warnings, std::vector<std::string>{});
}

TEST(BarPlan, BarsWithoutALimitOrAStepAreRefused) {
  Scene scene = string_scene();
  scene.bodies[0].material = Membrane{1e300, 0, true};
  EXPECT_THROW(make_plan(scene), InputError);
  scene = string_scene();
  scene.points.sxx = {1e300, 1e300, 1e300, 1e300};
  EXPECT_THROW(make_plan(scene), InputError);
}

TEST(BarPlan, SaysWhatIsModelledAndWhatIsLeftOut) {
  Scene scene = string_scene();
  scene.gravity = -9.8;
  scene.walls.right = Wall::fixed, scene.walls.left = Wall::symmetry;
  scene.points.x = {0.3, 0.8, 1.3, 1.8};
  const std::string text = to_text(make_plan(scene));
  const std::string expected =
      "path: fem (bars)\n"
      "body 1: string, 4 points, string, E 100, one-way\n"
      "modelled:\n"
      "  bars: 4 with two nodes, sections 1 to 1 by the points' volumes\n"
      "  strain: change of length over the length at the start, with that of the points' stress at the start\n"
      "  mass: the points', lumped at the nodes\n"
      "  time: central differences\n"
      "  gravity: gravc = -9.8 in y\n"
      "  ends at walls: a bar of 0.3 joins point 1 to the left wall, and slides along\n"
      "left out:\n"
      "  pins: no point is pinned\n"
      "  walls elsewhere: bars feel them at their ends only\n"
      "  contact: bars do not feel each other\n"
      "  bending: bars turn freely at their nodes\n"
      "  grid: bars need none: its edges are the walls\n"
      "  third dimension: the scene is plane, one unit deep\n"
      "step: ";
  EXPECT_EQ(text.substr(0, expected.size()), expected);
  EXPECT_NE(text.find("(deck 0.1, limit 2/omega "), std::string::npos) << text;
}

}  // namespace
}  // namespace tether
