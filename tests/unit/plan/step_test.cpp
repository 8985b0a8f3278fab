// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include <limits>

#include "base/diagnostics.hpp"
#include "plan/make_plan.hpp"
#include "unit/plan/plan_support.hpp"

namespace tether::test {
namespace {

TEST(StepRuleTest, OfASolidIsTheSmallerSideOverSqrtEOverRho) {
  const StepRule step = make_plan(elastic_scene()).step;
  EXPECT_EQ(step.h, 0.25);
  EXPECT_EQ(step.solid_speed, 4);
  EXPECT_EQ(step.first_limit, 0.0625);
  EXPECT_EQ(step.first_step(), 0.0625);
  EXPECT_EQ(step.step(0), 0.0625);
}

TEST(StepRuleTest, OfAStringAndOfALinearFluid) {
  Scene string = empty_scene(), fluid = empty_scene();
  add_body(string, Membrane{16, 0.3, true}, 1, 0, {{0, 0}, {7, 7}});  // a solid's own speed does not count
  add_body(fluid, LinearFluid{64}, 1, 0, {{0, 0}});
  EXPECT_EQ(make_plan(string).step.first_limit, 0.0625);
  EXPECT_EQ(make_plan(fluid).step.first_limit, 0.03125);
}

TEST(StepRuleTest, OfAGasIsTheSoundSpeedAndTheLargestSpeed) {
  Scene scene = empty_scene();
  add_body(scene, simple_gas(), 1, 8, {{0, 0}, {3, -4}, {-1, 0}});
  const StepRule step = make_plan(scene).step;
  EXPECT_NEAR(step.first_limit, 0.25 / 9, 1e-16);  // c + |v| = 4 + 5
  EXPECT_EQ(step.solid_speed, 0);
}

TEST(StepRuleTest, TheFastestBodyDecides) {
  Scene scene = elastic_scene();
  add_body(scene, simple_gas(), 1, 8, {{3, 4}});
  const StepRule step = make_plan(scene).step;
  EXPECT_NEAR(step.first_limit, 0.25 / 9, 1e-16);
  EXPECT_EQ(step.solid_speed, 4);
  EXPECT_EQ(step.step(0.5), 0.0625);   // the gas came to rest: the solid decides
  EXPECT_EQ(step.step(16), 0.015625);  // and the gas again
}

TEST(StepRuleTest, NeverAboveTheDecksStep) {
  Scene scene = elastic_scene();
  scene.clock.tstep = 0.01;
  const StepRule step = make_plan(scene).step;
  EXPECT_EQ(step.first_step(), 0.01);
  EXPECT_EQ(step.step(1), 0.01);
  EXPECT_EQ(step.step(250), 0.001);
}

TEST(StepRuleTest, TheFactorScalesTheLimit) {
  Scene scene = elastic_scene();
  scene.clock.cfl = 0.5;
  EXPECT_EQ(make_plan(scene).step.first_step(), 0.03125);
  EXPECT_EQ(make_plan(scene).step.step(8), 0.015625);
}

TEST(StepRuleTest, AFactorOfZeroTakesTheDecksStep) {
  Scene scene = elastic_scene();
  scene.clock.cfl = 0;
  const StepRule step = make_plan(scene).step;
  EXPECT_EQ(step.first_step(), 0.125);
  EXPECT_EQ(step.step(1000), 0.125);
}

TEST(StepRuleTest, WhereNothingHasASpeedTheDeckDecides) {
  Scene scene = empty_scene();
  add_body(scene, simple_gas(), 1, 0, {{0, 0}});
  const StepRule step = make_plan(scene).step;
  EXPECT_EQ(step.first_limit, std::numeric_limits<double>::infinity());
  EXPECT_EQ(step.first_step(), 0.125);
  EXPECT_EQ(step.step(0), 0.125);
}

/// 1 + 2^-53 rounds to 1: such steps never reach the end.
TEST(StepRuleTest, RefusesStepsThatAreLostInTheRoundingOfTheTime) {
  Scene scene = elastic_scene();
  scene.clock.tstep = 1.0 / (1LL << 53);
  EXPECT_THROW(make_plan(scene), InputError);
  scene.clock.tstep = 1.0 / (1LL << 52);
  EXPECT_NO_THROW(make_plan(scene));
}

using Texts = std::vector<std::string>;

/// The piston's fluid and cells (Box 12): c = sqrt(1.58e6 / 1e-4) = 125698, dx/c = 7.956e-6, and 5e-5 is 6.28 of these.
Scene piston_scene() {
  Scene scene = empty_scene();
  scene.grid = BackgroundGrid(2, 41, 0, 1, 0, 40);
  scene.clock = {0.035, 5e-5, 1};
  add_body(scene, LinearFluid{1.58e6}, 1e-4, 0, {{0, 0}});
  return scene;
}

TEST(StepWarning, SaysByHowMuchThePistonsStepIsAboveTheLimit) {
  EXPECT_EQ(make_plan(piston_scene()).warnings,
            (Texts{"the deck's step 5e-05 is 6.28 times the limit dx/c = 7.956e-06: steps are limited to 7.956e-06"}));
}

TEST(StepWarning, WithAFactor) {
  Scene scene = piston_scene();
  scene.clock.cfl = 2;
  EXPECT_EQ(make_plan(scene).warnings,
            (Texts{"the deck's step 5e-05 is 6.28 times the limit dx/c = 7.956e-06: steps are limited to 1.591e-05, "
                   "which is cfl = 2 times that"}));
  scene.clock.cfl = 7;  // the deck's step is below 7 dx/c
  EXPECT_EQ(make_plan(scene).warnings, Texts{});
}

TEST(StepWarning, ThatTheStepIsTakenAsItIs) {
  Scene scene = piston_scene();
  scene.clock.cfl = 0;
  EXPECT_EQ(make_plan(scene).warnings,
            (Texts{"the deck's step 5e-05 is 6.28 times the limit dx/c = 7.956e-06 and taken as it is (cfl = 0)"}));
}

TEST(StepWarning, IsNotThereAtOrBelowTheLimit) {
  Scene scene = elastic_scene();
  scene.bodies[0].material = plane_strain(4, 0);  // so that pressure waves are no faster than sqrt(E / rho)
  scene.clock.tstep = 0.0625;
  EXPECT_EQ(make_plan(scene).warnings, Texts{});
  scene.clock.tstep = 0.01;
  EXPECT_EQ(make_plan(scene).warnings, Texts{});
  scene.clock.tstep = 0.0626;
  EXPECT_EQ(make_plan(scene).warnings.size(), 1u);
}

// nu = 1/4 in plane strain: lambda + 2 G = 1.2 E, so pressure waves are sqrt(1.2) times as fast.
TEST(StepWarning, ThatPressureWavesAreFaster) {
  Scene scene = elastic_scene();
  scene.clock.tstep = 0.0625;
  const auto warnings = make_plan(scene).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1.10 times what pressure waves"), std::string::npos) << warnings[0];
  EXPECT_NEAR(make_plan(scene).step.sharp_limit, 0.0625 / std::sqrt(1.2), 1e-15);
}

TEST(StepWarning, OfTheUnstableOrder) {
  Scene scene = elastic_scene();
  scene.clock.tstep = 0.01;
  scene.method.order = StressOrder::usl;
  const auto warnings = make_plan(scene).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("'usl' is unstable"), std::string::npos);
}

}  // namespace
}  // namespace tether::test
