// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cases/run_deck.hpp"

// Bodies of finite elements where the model ends: beyond the grid, or turned further than a linear law follows.

namespace tether::cases {
namespace {

long long messages_with(const DeckRun& run, const std::string& part) {
  return std::ranges::count_if(run.messages,
                               [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// A block that falls from .13 above the grid's floor, which it reaches at sqrt(2 .13/9.81) = .163.
DeckRun falling(const std::string& more, const std::string& fem) {
  return run_text("falling",
                  "a block that falls\n$in nx=2,ny=2,xleft=-1.,xright=3.,ybot=0.,ytop=2.,tstep=4.e-3,"
                  "gravc=-9.81,iout(33)=1,tiout(33)=.05," +
                      more +
                      " $\n$reg nreg=1,nvi=4,xvi(1,1)=.3,.64,.64,.3,yvi(1,1)=.13,.13,.34,.34,densir=900.,"
                      "matr(1,1)=5.e5,.3 $\n$mesh cells(1,1)=3,2 $\n$fem law='neo-hookean'" +
                      fem + " $\n");
}

TEST(BodyDoubts, ABodyThatLeavesTheGridIsToldOnce) {
  const std::string left = "has left the grid beyond ybot = 0";
  EXPECT_EQ(messages_with(falling("tmax=.15", ""), left), 0);
  const DeckRun run = falling("tmax=.3", "");
  ASSERT_EQ(messages_with(run, left), 1);
  EXPECT_EQ(run.messages[0].rfind("t = 0.16", 0), 0u) << run.messages[0];
  EXPECT_EQ(messages_with(falling("tmax=.3", ",fix_on='1.left',fix(1:2,1)=0.,0."), left), 0);
}

/// A cantilever under its weight, with the modulus as a parameter; what a linear law says too much of its sag.
DeckRun cantilever(const std::string& law, double modulus) {
  return run_text("cantilever",
                  fmt::format("a cantilever\n$in nx=2,ny=2,xleft=-1.,xright=3.,ybot=-1.5,ytop=1.,tmax=1.,tstep=.25,"
                              "gravc=-9.81,iout(33)=1,tiout(33)=1. $\n"
                              "$reg nreg=1,nvi=4,xvi(1,1)=.2,1.5,1.5,.2,yvi(1,1)=-.145,-.145,-.055,-.055,"
                              "densir=2700.,matr(1,1)={},.33,ipath(4,1)=2 $\n$mesh element='q2',cells(1,1)=17,2 $\n"
                              "$fem static=.true.,law='{}',fix_on='1.left',fix(1,1)=0.,0. $\n"
                              "$points tracked_at(1,1)=1.5,-.1 $\n",
                              modulus, law));
}

TEST(BodyDoubts, ALinearLawThatIsTurnedTooFarIsTold) {
  const std::string turned = "law='linear' leaves out strains of";
  const auto sag = [](const DeckRun& run) { return -0.1 - run.last("point_y_1"); };
  const DeckRun far = cantilever("linear", 2e7), near = cantilever("linear", 6e7);
  EXPECT_GT(sag(far) / sag(cantilever("svk", 2e7)), 1.15);
  EXPECT_EQ(messages_with(far, turned), 1);
  EXPECT_LT(sag(near) / sag(cantilever("svk", 6e7)), 1.04);
  EXPECT_EQ(messages_with(near, turned), 0);
  EXPECT_EQ(messages_with(cantilever("svk", 2e7), turned), 0);
}

/// A cantilever of period .023 that falls into its vibration: steps of twice that are reported, of a tenth not.
TEST(BodyDoubts, StepsLongerThanAPeriodAreTold) {
  const auto swings = [](double step) {
    const DeckRun run = run_text(
        "swings", fmt::format("a vibration\n$in nx=2,ny=2,xleft=-1.,xright=3.,ybot=-1.5,ytop=1.,tmax={},tstep={},"
                              "gravc=-9.81,iout(33)=1,tiout(33)=1. $\n"
                              "$reg nreg=1,nvi=4,xvi(1,1)=.2,1.5,1.5,.2,yvi(1,1)=-.145,-.145,-.055,-.055,"
                              "densir=2700.,matr(1,1)=7.e10,.33,ipath(4,1)=2 $\n$mesh element='q2',cells(1,1)=9,1 $\n"
                              "$fem law='linear',fix_on='1.left',fix(1,1)=0.,0. $\n",
                              30 * step, step));
    return messages_with(run, "steps the bodies' velocity turned back");
  };
  EXPECT_EQ(swings(0.05), 1);
  EXPECT_EQ(swings(0.0023), 0);
  EXPECT_EQ(swings(2e-4), 0);
}

/// Explicit steps that their limit cuts.
TEST(BodyDoubts, StepsThatAreCutAreTold) {
  const DeckRun cut = falling("tmax=.01", ",integrator='central'");
  EXPECT_EQ(messages_with(cut, "times the limit 2/omega"), 1);
  EXPECT_EQ(messages_with(falling("tmax=.01,dtmax=1.", ",integrator='central',cfl=0."), "times the limit"), 0);
}

/// No fluid is blamed where there is none, and the law is.
TEST(BodyDoubts, AVolumeThatALinearLawMakesIsLaidToIt) {
  const DeckRun run = cantilever("linear", 5e6);
  EXPECT_EQ(messages_with(run, "(volume of $limits)"), 1);
  EXPECT_EQ(messages_with(run, "fluid"), 0);
  EXPECT_GT(messages_with(run, "large turns by law='linear'"), 0);
}

}  // namespace
}  // namespace tether::cases
