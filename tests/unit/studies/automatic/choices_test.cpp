// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/choices.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tether::automatic {
namespace {

Decision decided(double without, double seconds_without, double tolerance) {
  Decision decision{.choice = {"viscosity", {"fluid.mu=0"}}, .left_out = false, .change = 0, .saved = 0, .why = ""};
  decide(decision, 2, without, 10, seconds_without, tolerance);
  return decision;
}

TEST(AutomaticChoices, LeaveOutWhatChangesLessThanAThirdOfTheTolerance) {
  EXPECT_TRUE(decided(2.006, 9, 0.01).left_out);
  EXPECT_NEAR(decided(2.006, 9, 0.01).change, 0.003, 1e-12);
  EXPECT_FALSE(decided(2.008, 9, 0.01).left_out);
  EXPECT_FALSE(decided(1.992, 9, 0.01).left_out);
  EXPECT_EQ(decided(1.992, 9, 0.01).why, "it counts");
}

TEST(AutomaticChoices, KeepWhatFailsWithoutOrCostsMore) {
  EXPECT_FALSE(decided(std::numeric_limits<double>::quiet_NaN(), 0, 0.01).left_out);
  EXPECT_FALSE(decided(2, 13, 0.01).left_out);
  EXPECT_EQ(decided(2, 13, 0.01).why, "the run costs more without it");
}

TEST(AutomaticChoices, AreReportedWithTheirNumbers) {
  const std::string text = decisions_text({decided(2.006, 9, 0.01), decided(2.1, 9, 0.01)});
  EXPECT_NE(text.find("left out: viscosity, which changes the number by 0.3 %, with fluid.mu=0"), text.npos) << text;
  EXPECT_NE(text.find("kept: viscosity, which changes the number by 5 %: it counts"), text.npos) << text;
}

}  // namespace
}  // namespace tether::automatic
