// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

// Steady solutions of flows with bodies are what marches of the same decks come to, whatever steps lead there.

namespace tether::cases {
namespace {

/// How a deck is to be solved: steps to tmax of a length [time], and what $flow says.
struct Way {
  std::string flow = "steady=.true.";
  int steps = 1;
  double dt = 1;
};

/// A flap that leans on the floor of a closed box sinks under its excess weight.
/// Records are made every `every`, or at the end [time].
DeckRun leaning_flap(const Way& way, double every = 0, int cells = 10) {
  return run_text("leaning-flap",
                  fmt::format("a flap\n$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax={0},tstep={1},gravc=-.01,"
                              "iout(33)=1,tiout(33)={3} $\n"
                              "$reg nreg=2,nvi=4,4,densir=1.,2.,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,matr(1,1)=1.,"
                              "xvi(1,2)=.3,.4,.6,.5,yvi(1,2)=0.,0.,.5,.5,matr(1,2)=54.,.35 $\n"
                              "$mesh element='q2',cells(1,1)={4},{4},cells(1,2)={5},{6} $\n"
                              "$fem law='fluid','neo-hookean',fix_on='2.bottom',fix(1,1)=0.,0. $\n"
                              "$flow {2},tolerance=1e-9,force_on='1.left' $\n$points tracked_at(1,1)=.55,.5 $\n",
                              way.steps * way.dt, way.dt, way.flow, every > 0 ? every : way.steps * way.dt, 2 * cells,
                              cells / 5, cells));
}

/// A flap of shear modulus G stands on the floor of a channel, whose inflow is there from t = 40 on.
DeckRun standing_flap(const Way& way, double G, int cells = 10) {
  return run_text(
      "standing-flap",
      fmt::format(
          "a flap\n$in nx=2,ny=2,xleft=0.,xright=3.,ybot=0.,ytop=1.,tmax={0},tstep={1},iout(33)=1,"
          "tiout(33)={0} $\n"
          "$reg nreg=2,nvi=4,4,densir=2*1.,xvi(1,1)=0.,3.,3.,0.,yvi(1,1)=0.,0.,1.,1.,matr(1,1)=1.,"
          "xvi(1,2)=.97,1.17,1.17,.97,yvi(1,2)=0.,0.,.5,.5,matr(1,2)={2},.35 $\n"
          "$mesh element='q2',cells(1,1)={4},{5},cells(1,2)={6},{7} $\n"
          "$fem law='fluid','neo-hookean',fix_on='2.bottom',fix(1,1)=0.,0. $\n"
          "$flow {3},tolerance=1e-9,boundary_on(1)='1.left',boundary(1)='inflow',"
          "boundary_u(1)='4*y*(1-y)*min(t/40,1)',boundary_on(2)='1.right',boundary(2)='open',force_on='1.bottom' $\n"
          "$points tracked_at(1,1)=1.07,.5 $\n",
          way.steps * way.dt, way.dt, 2.7 * G, way.flow, 3 * cells, cells, cells / 5, cells / 2));
}

double off(const DeckRun& run, const DeckRun& from, const std::string& column, double start = 0) {
  return std::abs(run.last(column) - from.last(column)) / std::abs(from.last(column) - start);
}

/// Backward Euler keeps the flap's volume, which the level of the pressure is for, but for an error that falls with the
/// step, on whatever cells.
TEST(SteadyBodies, LeaningFlapIsWhatMarchesComeTo) {
  const int cells = at_full_length() ? 10 : 5;
  const DeckRun steady = leaning_flap({}, 0, cells);
  const DeckRun coarse = leaning_flap({"integrator='euler'", 160, 25}, 0, cells),
                fine = leaning_flap({"integrator='euler'", 320, 12.5}, 0, cells);
  for (const auto& [column, start] :
       {std::pair{"point_x_1", .55}, std::pair{"point_y_1", .5}, std::pair{"side_force_x_1", 0.}}) {
    const double error = off(fine, steady, column, start), ratio = off(coarse, steady, column, start) / error;
    EXPECT_LT(error, 0.002) << column;
    EXPECT_GT(ratio, 1.6) << column;
  }
  EXPECT_LT(steady.summary.at("steady_residual"), 1e-9);
}

TEST(SteadyBodies, LeaningFlapDoesNotDependOnTheStepsThatLeadThere) {
  const DeckRun one = leaning_flap({}), four = leaning_flap({"steady=.true.", 4, 1});
  EXPECT_LT(off(four, one, "point_x_1", .55), 1e-7);
  EXPECT_LT(off(four, one, "point_y_1", .5), 1e-7);
  EXPECT_LT(off(four, one, "side_force_x_1"), 1e-7);
}

/// The fluid and the clamp bear the part of the flap's weight that acts at each record: 2 x 0.01 x 0.05, in two halves.
TEST(SteadyBodies, ForcesBearThePartOfTheWeightThatActs) {
  const DeckRun run = leaning_flap({"steady=.true.", 2, 1}, 1);
  const auto records = run.history.column("time");
  ASSERT_EQ(records.size(), 3U);
  for (std::size_t k = 1; k < records.size(); ++k) {
    const double borne = run.history.column("body_force_y_1")[k] + run.history.column("body_hold_y_1")[k];
    EXPECT_NEAR(borne, 2 * 0.01 * 0.05 * records[k] / 2, 1e-8 * 0.001);
  }
}

TEST(SteadyBodies, StandingFlapIsWhatAMarchComesTo) {
  const DeckRun steady = standing_flap({"steady=.true.", 1, 60}, 60000),
                steps = standing_flap({"steady=.true.", 3, 20}, 60000);
  const DeckRun march = standing_flap({"integrator='euler'", 30, 4}, 60000);
  for (const auto& [column, start] : {std::pair{"point_x_1", 1.07}, std::pair{"side_force_x_1", 0.}}) {
    EXPECT_LT(off(march, steady, column, start), 1e-6) << column;
    EXPECT_LT(off(steps, steady, column, start), 1e-6) << column;
  }
}

TEST(SteadyBodies, TellsTheLastLoadsThatConverged) {
  try {
    standing_flap({"steady=.true.", 2, 20}, 30, at_full_length() ? 10 : 5);
    FAIL() << "a flap too soft to stand";
  } catch (const RunError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("no steady solution is found at"), std::string::npos) << text;
    EXPECT_NE(text.find("the last one that converged has"), std::string::npos) << text;
    EXPECT_NE(text.find("bodies too soft"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace tether::cases
