// SPDX-License-Identifier: GPL-3.0-or-later
// The clock that the state of every path has: where steps end, what is the shortest of them, and halved steps.
#include "physics/step_clock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tether {
namespace {

struct RunState : StepClock {
  long long halvings = 0;
};

TEST(StepClock, EqualStepsEndWhereTheirProductSays) {
  StepClock run;
  for (int i = 0; i < 1'000'000; ++i) run.count_step(0.1, 1e9);
  EXPECT_EQ(run.time, 1e5);
  EXPECT_EQ(run.steps, 1'000'000);
}

TEST(StepClock, TheLastStepEndsAtTmaxToTheLastBitAndOwesNothing) {
  StepClock run;
  const double tmax = 0.7;
  while (run.time < tmax) run.count_step(step_before_end(0.1, run.time, tmax), tmax);
  EXPECT_EQ(run.time, tmax);
  EXPECT_EQ(run.time_lost, 0);
  EXPECT_EQ(run.steps, 7);
}

TEST(StepClock, AStepCutShortByTheEndIsNotTheShortestUnlessItIsTheOnlyOne) {
  StepClock run;
  for (const double dt : {0.3, 0.2, 0.4}) run.count_step(dt, 1);
  run.count_step(0.1, 1);
  EXPECT_EQ(run.dt_min, 0.2);
  EXPECT_EQ(run.dt_last, 0.1);
  StepClock alone;
  alone.count_step(0.1, 0.1);
  EXPECT_EQ(alone.dt_min, 0.1);
}

TEST(StepClock, AStepThatDoesNotConvergeIsTakenInHalves) {
  RunState run;
  std::vector<double> taken;
  std::vector<std::string> messages;
  struct Report {
    bool converged;
  };
  const auto advance = [&](double dt) {
    if (dt <= 0.25) taken.push_back(dt);
    return Report{dt <= 0.25};
  };
  fem::clock_step(
      run, 1.0, 1.0, advance, [](double, const Report&) { FAIL(); }, messages);
  EXPECT_EQ(taken, std::vector<double>(4, 0.25));
  EXPECT_EQ(run.steps, 4);
  EXPECT_EQ(run.halvings, 3);
  EXPECT_EQ(run.time, 1);
  EXPECT_EQ(run.dt_last, 1);  // of the clock, not of its parts
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages.front(), "t = 0: a step of 1 does not converge and is halved");
}

TEST(StepClock, AStepIsHalvedSixTimesAtMost) {
  RunState run;
  std::vector<std::string> messages;
  struct Report {
    bool converged;
  };
  double stopped_at = 0;
  const auto stop = [&](double dt, const Report&) {
    stopped_at = dt;
    throw stopped_at;
  };
  EXPECT_THROW(fem::clock_step(
                   run, 1.0, 1.0, [](double) { return Report{false}; }, stop, messages),
               double);
  EXPECT_EQ(stopped_at, 1.0 / 64);
  EXPECT_EQ(run.steps, 0);
}

}  // namespace
}  // namespace tether
