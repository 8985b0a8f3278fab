// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a deck of a flow: velocities that do not fit, words without effect. The decks of tests/bad_decks
// have one mistake each; here is where a mistake begins.
#include "read/flow/checks.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "deck/document.hpp"
#include "read/path.hpp"
#include "unit/read/flow/flow_support.hpp"

namespace tether::test {
namespace {

const std::string in = "boundary_on(1)='1.left',boundary(1)='inflow',boundary_u(1)='";
const std::string out = ",boundary_on(2)='1.right',boundary(2)='inflow',boundary_u(2)='";

TEST(FlowBalance, TakesWhatGoesInAndOutAlike) {
  EXPECT_EQ(channel(in + "1'" + out + "1'").errors(), Texts{});
  EXPECT_EQ(channel(in + "y*(1-y)*sin(t)'" + out + "y*(1-y)*sin(t)'").errors(), Texts{});
  EXPECT_EQ(channel(in + "1',boundary_on(2)='1.right',boundary(2)='open'").errors(), Texts{});
  EXPECT_EQ(channel("boundary_on(1)='1.top',boundary(1)='moving',boundary_u(1)='1'").errors(), Texts{});
}

/// Walls at rest take the corners: of 1 on both nodes of a side without neighbours half is left by each end.
TEST(FlowBalance, IsThatOfTheNodes) {
  const Texts wide = channel("element='q1q1'," + in + "1'").errors();
  ASSERT_EQ(wide.size(), 1u);
  EXPECT_EQ(wide[0].find("8:31: at t = 0 the prescribed velocities bring 0.5 into the fluid and 0 out of it"), 0u)
      << wide[0];
  const Texts biquadratic = channel(in + "1'").errors();  // 1 less two ends of 1/6 of a cell
  ASSERT_EQ(biquadratic.size(), 1u);
  EXPECT_NE(biquadratic[0].find("bring 0.833333 into"), std::string::npos) << biquadratic[0];
}

TEST(FlowBalance, SlipWallsLeaveTheCornersToTheInflow) {
  const std::string slip = ",boundary_on(3)='1.bottom',boundary(3)='slip',boundary_on(4)='1.top',boundary(4)='slip'";
  const Texts open = channel(in + "1'" + slip).errors();
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NE(open[0].find("bring 1 into"), std::string::npos) << open[0];
  EXPECT_EQ(channel(in + "1'" + slip + out + "1'").errors(), Texts{});
  // upwards at the corner of the inflow, through the slip wall
  const Texts slant = channel(in + "1',boundary_v(1)='y'" + slip + out + "1'").errors();
  ASSERT_EQ(slant.size(), 1u);
}

TEST(FlowBalance, IsLookedAtUntilTheEnd) {
  EXPECT_EQ(channel(in + "1'" + out + "1+1e-7*t'").errors(), Texts{});
  const Texts later = channel(in + "1'" + out + "1+(t > 1.85)'").errors();
  ASSERT_EQ(later.size(), 1u);
  EXPECT_NE(later[0].find("at t = 1.9 "), std::string::npos) << later[0];
  const Texts table =
      channel(in + "1'" + out + "1',boundary_time(1,2)=0.,1.,2.,boundary_factor(1,2)=1.,1.,1.0001").errors();
  ASSERT_EQ(table.size(), 1u);
  EXPECT_NE(table[0].find("at t = 1.1 "), std::string::npos) << table[0];
}

TEST(FlowBalance, OfASteadyFlowIsThatOfTheEnd) {
  EXPECT_EQ(channel("steady=.true.," + in + "1'" + out + "t/2'").errors(), Texts{});
  EXPECT_EQ(channel("steady=.true.," + in + "1'" + out + "1-t'").errors().size(), 1u);
}

TEST(FlowBalance, PeriodicSidesAreNotOpen) {
  const std::string periodic = ",boundary_on(2)='1.bottom',boundary(2)='periodic',boundary_with(2)='1.top'";
  const Texts told = channel(in + "1'" + periodic).errors();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("bring 1 into"), std::string::npos) << told[0];  // no wall at its corners
}

TEST(FlowBalance, ATimeWithoutAVelocityIsLeftToTheRun) {
  EXPECT_EQ(channel(in + "1/(t-1)'" + out + "1/(t-1)'").errors(), Texts{});
  EXPECT_EQ(channel(in + "1/t'" + out + "1/t'").errors().size(), 2u);
  EXPECT_EQ(channel("steady=.true.," + in + "1/t'" + out + "1/t'").errors(), Texts{});
}

TEST(FlowHolders, WallsAtRestBeforeMovingWallsBeforeInflows) {
  const Built built =
      channel("element='q1q1'," + in + "1'" + out + "1',boundary_on(3)='1.top',boundary(3)='moving',boundary_u(3)='1'");
  EXPECT_EQ(built.errors(), Texts{});
  const auto holders = holders_of(*built.scene.flow());  // 5 x 3 nodes; sides: left, right, top, other walls
  std::vector<int> sides;
  for (std::size_t n = 0; n < holders.size(); ++n) {
    sides.push_back(holders[n].side);
    EXPECT_EQ(holders[n].node, holders[n].side < 0 ? -1 : static_cast<int>(n));
  }
  EXPECT_EQ(sides, (std::vector<int>{3, 3, 3, 3, 3, 0, -1, -1, -1, 1, 2, 2, 2, 2, 2}));
}

TEST(FlowHolders, TwinsHaveOne) {
  const Built built = channel(
      "element='q1q1',boundary_on(1)='1.left',boundary(1)='periodic',boundary_with(1)='1.right',"
      "boundary_on(2)='1.top',boundary(2)='moving',boundary_u(2)='1'");
  EXPECT_EQ(built.errors(), Texts{});
  const auto holders = holders_of(*built.scene.flow());
  EXPECT_EQ(holders[4].side, 3);
  EXPECT_EQ(holders[14].side, 2);
  EXPECT_EQ(holders[14].node, holders[10].node);
  EXPECT_EQ(holders[9].side, -1);
}

TEST(FlowWalls, MayMoveAlongACurve) {
  const std::string turning = "boundary_on(1)='axle',boundary(1)='moving',boundary_u(1)='-y',boundary_v(1)='x'";
  for (const char* element : {"q1q1", "q2q1"}) {
    for (const int cells : {2, 4, 16}) EXPECT_EQ(ring(element, cells, turning).errors(), Texts{}) << element << cells;
    EXPECT_EQ(ring(element, 16, "boundary_on(1)='axle',boundary(1)='moving',boundary_u(1)='x',boundary_v(1)='y'")
                  .errors()
                  .size(),
              1u);
    EXPECT_EQ(ring(element, 16, "boundary_on(1)='axle',boundary(1)='moving',boundary_u(1)='1'").errors().size(), 1u);
  }
}

TEST(FlowWalls, MoveAlongAStraightSideExactly) {
  const auto told = [](const std::string& v) {
    return channel("boundary_on(1)='1.top',boundary(1)='moving',boundary_u(1)='1',boundary_v(1)='" + v + "'").errors();
  };
  EXPECT_EQ(told("1e-13"), Texts{});
  EXPECT_EQ(told("0.001"),
            Texts{"8:36: at t = 0 the velocity (1, 0.001) of '1.top' at (0.5, 1) goes through the wall by 0.001"});
  // at the corners the walls at rest count
  EXPECT_EQ(told("(x == 0) + (x == 2)"), Texts{});
  // Where expressions should be zero they are rounding, which has no direction.
  EXPECT_EQ(channel("boundary_on(1)='1.top',boundary(1)='moving',boundary_u(1)='sin(pi*x)',"
                    "boundary_v(1)='1e-16*cos(pi*x)'")
                .errors(),
            Texts{});
}

/// A table that begins at zero, and an expression: what goes through the wall later is told, too.
TEST(FlowWalls, MayNotMoveThroughThemselvesLater) {
  const std::string open = ",boundary_on(2)='1.right',boundary(2)='open',boundary_on(1)='1.left',boundary(1)='moving',";
  const auto told = [&](const std::string& v) { return channel("element='q2q1'" + open + v).errors(); };
  EXPECT_EQ(told("boundary_v(1)='t'"), Texts{});
  const Texts by_table = told("boundary_u(1)='1',boundary_time(1,1)=0.,1.,boundary_factor(1,1)=0.,1.");
  ASSERT_EQ(by_table.size(), 1u);
  EXPECT_NE(by_table[0].find("goes through the wall"), std::string::npos) << by_table[0];
  EXPECT_EQ(told("boundary_u(1)='t',boundary_v(1)='1'").size(), 1u);
}

/// A quarter of a ring, open at its cuts: an end of its axle has one element beside it.
TEST(FlowWalls, MayMoveAlongACurveToItsEnd) {
  EXPECT_EQ(
      build_flow("$reg nreg=1,nvi=4,xvi(1,1)=1.,2.,0.,0.,yvi(1,1)=0.,0.,2.,1.,densir=1.,matr(1,1)=1. $\n"
                 "$mesh cells(1,1)=1,4,edge(2,1)='arc',edge(4,1)='arc' $\n$fem law='fluid' $\n$flow element='q1q1',"
                 "boundary_on(1)='1.left',boundary(1)='moving',boundary_u(1)='-y',boundary_v(1)='x',"
                 "boundary_on(2)='1.bottom',boundary(2)='open',boundary_on(3)='1.top',boundary(3)='open' $\n")
          .errors(),
      Texts{});
}

/// A wall round a corner that moves as a whole: along the bottom, and through another side, which its middle tells.
TEST(FlowWalls, MayNotMoveAcrossACorner) {
  for (const auto& [edge, place] : {std::pair{"2", "(2, 0.5)"}, {"4", "(0, 0.5)"}}) {
    const Built built = channel("element='q1q1',boundary_on(1)='box',boundary_u(1)='1',boundary(1)='moving'", "",
                                {"mesh.side(1,1)='box'", fmt::format("mesh.side({},1)='box'", edge)});
    EXPECT_EQ(
        built.errors(),
        Texts{fmt::format("8:67: at t = 0 the velocity (1, 0) of 'box' at {} goes through the wall by 1", place)});
  }
}

TEST(FlowDecks, AllMistakesAreToldAtOnce) {
  const Built built = channel_with_body(
      "speed=1.,boundary_on(1)='2.left',boundary(1)='inflow',\nboundary_u(1)='2*',boundary_on(2)='2.rigth',boundary(2)="
      "'open',probe(1,1)=1.,\nforce_x(3)=1.,tracers=4,tracer_box=0.,1.",
      ",integrator='central',settle=.true.");
  EXPECT_EQ(built.errors().size(), 9u);
  for (const char* expected :
       {"unexpected end", "no side is called '2.rigth'", "force 3 acts on nothing", "length is not",
        "probe(2,1) is not given", "one of its two numbers", "no steps by 'central'", "no equilibrium of their own"}) {
    bool found = false;
    for (const std::string& text : built.errors()) found |= text.find(expected) != std::string::npos;
    EXPECT_TRUE(found) << expected;
  }
}

TEST(FlowDecks, WhatHasNoEffectIsAWarning) {
  EXPECT_EQ(warnings_of(channel_with_body("", ",alpha=0.,beta=0.,cfl=.9,tolerance=1e-11,integrator='midpoint'")),
            Texts{});
  const Built built =
      channel_with_body("penalty(2)=1.", ",alpha=1.,beta=2.,cfl=.5,tolerance=1e-9,spin(3,2)=1.", {"reg.ipath(4,2)=2"});
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built),
            (Texts{"alpha of $fem has no effect beside a fluid", "beta of $fem has no effect beside a fluid",
                   "cfl of $fem has no effect beside a fluid", "tolerance of $fem has no effect beside a fluid",
                   "spin(3,2) has no effect: region 2 is a fluid", "penalty(2) has no effect: region 2 is a fluid",
                   "ipath(4,2) has no effect: region 2 is a fluid"}));
  const std::string open = "boundary_on(1)='1.right',boundary(1)='open',";
  EXPECT_EQ(warnings_of(channel(open + "outside='void',level=2.", "", {"in.gravc=-1."})),
            Texts{"level of $flow has no effect"});
  EXPECT_EQ(warnings_of(channel(open + "outside='void'")), Texts{"outside of $flow has no effect"});
  EXPECT_EQ(warnings_of(channel("penalty(3)=1.")), Texts{"penalty has no effect: there is no region 3"});
  EXPECT_EQ(built.scene.solids()->alpha, 0);
  EXPECT_EQ(built.scene.solids()->beta, 0);
  EXPECT_EQ(
      warnings_of(channel("u0='1',steady=.true.,integrator='euler'", "", {"reg.vrx=1.", "mesh.element='q2'"})),
      (Texts{"integrator has no effect: the flow is steady", "element of $mesh has no effect: all regions are a fluid",
             "vrx(1) has no effect: u0 of $flow is there"}));
}

TEST(FlowChecks, TellThatPressuresSwingWithoutStabilisation) {
  EXPECT_EQ(warnings_of(channel("element='q1q1',stabilisation=.2")), Texts{});
  EXPECT_EQ(warnings_of(channel("element='q1q1',stabilisation=.05")),
            Texts{"stabilisation = 0.05 lets the pressure swing from node to node"});
  EXPECT_EQ(warnings_of(channel("stabilisation=.5")), Texts{"stabilisation has no effect: q2q1 needs none"});
}

TEST(FlowDecks, BodiesStartWithTheFluid) {
  const Built built =
      channel_with_body("integrator='euler'", ",integrator='midpoint',spin(3,1)=1.,vrz=2.", {"reg.vrx=1.,0."});
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), (Texts{"integrator of $fem has no effect: the fluid uses backward Euler",
                                       "vrx(1) has no effect: region 1 starts with the fluid's velocity",
                                       "vrz(1) has no effect: region 1 starts with the fluid's velocity",
                                       "spin(3,1) has no effect: region 1 starts with the fluid's velocity"}));
}

TEST(FlowDecks, TracersOfASteadyFlowAreAWarning) {
  EXPECT_EQ(warnings_of(channel("steady=.true.,tracers=2,2")),
            Texts{"tracers of a steady flow go through the steps that lead up to it, which take no time"});
  EXPECT_EQ(warnings_of(channel("tracers=2,2")), Texts{});
}

TEST(FlowDecks, ReadBackAsTheyTookEffect) {
  Diagnostics diagnostics;
  const std::string text =
      "$in\nnx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,tmax=2.,tstep=.01,wl=1,wr=1,wb=1,wt=1\n$\n"
      "$reg nreg=2,nvi=4,4,xvi(1,1)=.5,1.,1.,.5,yvi(1,1)=.25,.25,.75,.75,xvi(1,2)=0.,2.,2.,0.,yvi(1,2)=0.,0.,1.,1.,\n"
      "densir=5.,3.,matr(1,1)=100.,.3,matr(1,2)=.5 $\n$mesh cells(1,2)=4,2 $\n$fem law(2)='fluid' $\n"
      "$flow " +
      in.substr(0, 16) + "2" + in.substr(17) +
      "y*(1-y)'\nboundary_on(2)='2.right',boundary(2)='open',"
      "boundary_time(1,1)=0.,1.,boundary_factor(1,1)=0.,1. $\n";
  const std::string effective = effective_deck(read_deck(text, "a.in", {}, diagnostics));
  const Deck again = read_deck(effective, "b.in", {}, diagnostics);
  const Scene scene = build_scene(again, std::nullopt, path_of(again, diagnostics), diagnostics);
  for (const auto& d : diagnostics.all()) ADD_FAILURE() << to_text(d);
  EXPECT_EQ(effective_deck(again), effective);
  ASSERT_TRUE(scene.flow() && scene.solids());
  EXPECT_EQ(side_of(*scene.flow(), "2.left").velocity.at(0, .5, .5), (std::array<double, 2>{.125, 0}));
}

}  // namespace
}  // namespace tether::test
