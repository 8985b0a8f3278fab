// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/choices.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace tether::automatic {
namespace {

Trial trial(std::optional<double> value, double seconds) {
  return {.at = {}, .wanted = {}, .value = value, .seconds = seconds, .why = NoValue::run, .run = 0};
}

Decision without(std::optional<double> value, double seconds, double tolerance) {
  return decided({"viscosity", {{"fluid.mu=0"}}}, trial(2, 10), trial(value, seconds), tolerance);
}

TEST(AutomaticChoices, LeaveOutWhatChangesLessThanAThirdOfTheTolerance) {
  EXPECT_TRUE(without(2.006, 9, 0.01).left_out);
  EXPECT_NEAR(without(2.006, 9, 0.01).change, 0.003, 1e-12);
  EXPECT_FALSE(without(2.008, 9, 0.01).left_out);
  EXPECT_FALSE(without(1.992, 9, 0.01).left_out);
  EXPECT_EQ(without(1.992, 9, 0.01).why, "it counts");
}

TEST(AutomaticChoices, KeepWhatFailsWithoutOrCostsMore) {
  EXPECT_FALSE(without(std::nullopt, 0, 0.01).left_out);
  EXPECT_FALSE(without(2, 13, 0.01).left_out);
  EXPECT_EQ(without(2, 13, 0.01).why, "the run costs more without it");
}

TEST(AutomaticChoices, DoNotDependOnHundredthsOfASecond) {
  const auto decision = decided({"viscosity", {{"fluid.mu=0"}}}, trial(2, .010), trial(2, .025), 0.01);
  EXPECT_TRUE(decision.left_out) << decision.why;
}

TEST(AutomaticChoices, AreReportedWithTheirNumbers) {
  const std::string text = decisions_text({without(2.006, 9, 0.01), without(2.1, 9, 0.01)});
  EXPECT_NE(text.find("left out: viscosity, which changes the number by 0.3 %, with fluid.mu=0"), text.npos) << text;
  EXPECT_NE(text.find("kept: viscosity, which changes the number by 5 %: it counts"), text.npos) << text;
}

}  // namespace
}  // namespace tether::automatic
