// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Forces in a closed box of fluid with a body clamped to its walls: all together they are weight and change of
// momentum, on any mesh and in any step. The body's density is 1.5 times the fluid's.

namespace tether::cases {
namespace {

constexpr double g = 9.81, fluid = 1000, solid = 1500;

const std::string box_group =
    "a body in a closed box\n$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=20.,tstep=1.,gravc=-9.81,iout(33)=1,"
    "tiout(33)=1. $\n";
const std::string square =
    "$reg nreg=2,nvi=2*4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,densir=1000.,1500.,matr(1,1)=1000.,"
    "matr(1,2)=1.e6,.3,";
const std::string laws = "$fem law='fluid','neo-hookean',";
const std::string flow = "$flow integrator='euler',tolerance=1e-11,force_on=";

DeckRun floor_run(int n, const std::string& forces, const std::string& more = "") {
  return run_text(
      "floor", box_group + square + "xvi(1,2)=.33,.52,.52,.33,yvi(1,2)=0.,0.,.41,.41 $\n" +
                   fmt::format("$mesh cells(1,1)={0},{0},cells(1,2)={1},{2},element='q2' $\n", n, n / 4, n / 2) + laws +
                   "fix_on='2.bottom',fix(1:2,1)=0.,0. $\n" + flow + forces + more + " $\n");
}

DeckRun round_run(int n) {
  std::string text = box_group + "$reg nreg=5,nvi=5*4,densir=4*1000.,1500.,matr(1,5)=1.e6,.3,";
  const std::string in = ".3585786437626905", out = ".6414213562373095";
  const std::vector<std::string> x{"0.,1.," + out + "," + in, "1.,1.," + out + "," + out, "1.,0.," + in + "," + out,
                                   "0.,0.," + in + "," + in};
  const std::vector<std::string> y{"0.,0.," + in + "," + in, "0.,1.," + out + "," + in, "1.,1.," + out + "," + out,
                                   "1.,0.," + in + "," + out};
  std::string mesh = "$mesh element='q2',edge(1,5)='arc',edge_xc(1,5)=.5,edge_yc(1,5)=.5,";
  for (std::size_t r = 0; r < 4; ++r) {
    text += fmt::format("matr(1,{0})=1000.,xvi(1,{0})={1},yvi(1,{0})={2},", r + 1, x[r], y[r]);
    mesh += fmt::format(
        "cells(1,{0})={1},{1},edge(3,{0})='arc',edge_xc(3,{0})=.5,edge_yc(3,{0})=.5,"
        "side(3,{0})='cylinder',",
        r + 1, n);
  }
  text += "xvi(1,5)=.42,.58,.58,.42,yvi(1,5)=2*.6833030277982336,.85,.85 $\n";
  mesh += fmt::format("cells(1,5)={0},{0} $\n", n / 2);
  return run_text("round", text + mesh + "$fem law=4*'fluid','neo-hookean',fix_on='5.bottom',fix(1:2,1)=0.,0. $\n" +
                               flow + "'cylinder','1.bottom+2.bottom + 3.bottom+4.bottom','5.right+5.top+5.left' $\n");
}

/// A beam from wall to wall, which bends; the fluid is parted by it.
DeckRun beam_run(int n) {
  return run_text("beam", box_group + square + "xvi(1,2)=0.,1.,1.,0.,yvi(1,2)=.31,.52,.74,.47 $\n" +
                              fmt::format("$mesh cells(1,1)={0},{0},cells(1,2)={0},{1},element='q2' $\n", n, n / 4) +
                              laws + "fix_on(1)='2.left',fix(1:2,1)=0.,0.,fix_on(2)='2.right',fix(1:2,2)=0.,0. $\n" +
                              flow + "'1.bottom','1.top','1.left','1.right' $\n");
}

/// In all records: what walls bear, those from 1 on, and what bodies get. While a body moves, the fluid that is taken
/// to fill its place changes its volume with it, whose momentum the convective term does not keep: 2.3e-8 of the
/// weight.
void expect_balance(const DeckRun& run, int walls) {
  const auto column = [&](const std::string& name) { return run.history.column(name); };
  const double volume = column("body_mass_1")[0] / solid, weight = (solid - fluid) * volume * g;
  for (const std::string axis : {"x", "y"}) {
    const auto momentum = column("momentum_" + axis), change = column("body_change_" + axis + "_1");
    const auto force = column("body_force_" + axis + "_1"), hold = column("body_hold_" + axis + "_1");
    const auto dt = column("dt");
    const double pull = axis == "x" ? 0 : g;
    for (std::size_t k = 1; k < momentum.size(); ++k) {
      double of_walls = 0;
      for (int w = 1; w <= walls; ++w) of_walls -= column(fmt::format("side_force_{}_{}", axis, w))[k];
      const double moved = (momentum[k] - momentum[k - 1]) / dt[k] + (1 - fluid / solid) * change[k];
      const double near = (k + 1 == momentum.size() ? 1e-8 : 5e-8) * weight;
      EXPECT_NEAR(of_walls - pull * (column("mass")[k] + (solid - fluid) * volume), moved, near) << k << axis;
      EXPECT_NEAR(force[k] + hold[k] - pull * solid * volume, change[k], 1e-8 * weight) << k << axis;
    }
  }
}

/// Elements across the box: two numbers, of which the second is 16, or 32 at full length.
std::array<int, 2> across() { return at_full_length() ? std::array{16, 32} : std::array{8, 16}; }

/// Of the box at rest all torques about the origin, too.
TEST(ImmersedForces, FloorBearsABodyThatIsClampedToIt) {
  double before = 1;
  for (const int n : across()) {
    const DeckRun run = floor_run(n,
                                  "'1.bottom','1.top','1.left','1.right','body 1','2.left+2.right+2.top',"
                                  "'body 1 + 1.bottom'",
                                  ",probe(1,1)=0.,0.");
    expect_balance(run, 4);
    const double volume = run.first("body_mass_1") / solid, weight = (solid - fluid) * volume * g;
    // The pressure at the foot of the left wall, which is that at which the body keeps its volume, presses on its top.
    const double foot = run.last("probe_p_1"), on_top = .19 * foot, lift = fluid * volume * g - on_top;
    double torque = fluid * g / 2 + weight * run.last("body_x_1");
    for (int w = 1; w <= 4; ++w) torque += run.last(fmt::format("side_torque_z_{}", w));
    EXPECT_NEAR(torque, 0, 1e-8 * weight) << n;
    EXPECT_NEAR(run.last("side_force_y_1"), -weight - foot, 1e-4 * weight) << n;
    EXPECT_NEAR(run.last("side_clamp_y_1"), -weight - on_top, .03 * weight) << n;
    EXPECT_NEAR(run.last("side_clamp_y_1"), -run.last("body_hold_y_1"), 1e-8 * weight) << n;
    EXPECT_EQ(run.last("side_clamp_y_2"), 0);
    EXPECT_NEAR(run.last("body_hold_y_1"), weight + on_top, .03 * weight) << n;
    EXPECT_NEAR(run.last("body_force_y_1"), lift, .015 * std::abs(lift)) << n;
    EXPECT_EQ(run.last("side_force_y_5"), run.last("body_force_y_1"));
    // As one the body and the floor get the fluid's forces alone.
    const double both = run.last("side_force_y_1") - run.last("side_clamp_y_1") + run.last("body_force_y_1");
    EXPECT_NEAR(run.last("side_force_y_7"), both, 1e-8 * weight) << n;
    EXPECT_EQ(run.last("side_clamp_y_7"), 0);
    const double error = std::abs(run.last("side_force_y_6") / lift - 1);
    EXPECT_LT(error, 2e-4) << n;
    EXPECT_LT(error, std::max(.6 * before, 2e-5)) << n;
    before = error;
  }
}

/// A flap as heavy as the fluid that a load pushes and the floor holds: whatever its elements, the floor bears the
/// load.
TEST(ImmersedForces, HoldLoadsOnBodiesOfAllElements) {
  for (const char* element : {"q1", "q2", "p1", "p2"}) {
    const DeckRun run = run_text(
        "flap",
        fmt::format("a flap\n$in nx=2,ny=2,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.5,tstep={},iout(33)=1,"
                    "tiout(33)=.25 $\n$reg nreg=2,nvi=4,4,densir=1.,1.,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,"
                    "matr(1,1)=1.,xvi(1,2)=.95,1.05,1.05,.95,yvi(1,2)=0.,0.,.6,.6,matr(1,2)=1000.,.4 $\n"
                    "$mesh element='{}',cells(1,1)=20,10,cells(1,2)=1,6 $\n$fem law='fluid','neo-hookean',"
                    "fix_on='2.bottom',fix(1:2,1)=0.,0.,load_on='2.left',load(1,1)=1. $\n"
                    "$flow boundary_on='1.right',boundary='open',steady=.true. $\n",
                    at_full_length() ? ".05" : ".25", element));
    EXPECT_NEAR(run.last("body_hold_x_1"), -0.6, 1e-6) << element;
    EXPECT_NEAR(run.last("body_hold_y_1"), 0, 1e-6) << element;
    EXPECT_NEAR(run.last("body_force_x_1"), 0, 1e-6) << element;
  }
}

/// A body that a support leads, ever faster, along a channel: the same along x as along y.
TEST(ImmersedForces, AreAlikeAlongXAndY) {
  const auto forces_along = [](const std::string& axis) {
    const bool x = axis == "x";
    const std::string across = x ? "y" : "x";
    const std::string ends = x ? "'1.left','1.right'" : "'1.bottom','1.top'";
    const DeckRun run = run_text(
        "way-" + axis,
        fmt::format(
            "a body on its way\n$in nx=2,ny=2,xleft=0.,xright={0},ybot=0.,ytop={1},tmax=.4,tstep=.1,iout(33)=1,"
            "tiout(33)=.1 $\n$reg nreg=2,nvi=4,4,densir=1.,1.,xvi(1,1)=0.,{0},{0},0.,yvi(1,1)=0.,0.,{1},{1},"
            "matr(1,1)=.1,matr(1,2)=1.e4,.3,{2}vi(1,2)={4},{3}vi(1,2)={5} $\n"
            "$mesh cells(1,1)={6},cells(1,2)=4,4 $\n$fem law='fluid','neo-hookean',fix_on='2.{7}',"
            "fix(1:2,1)={8},fix_expression='.5*t^2' $\n$flow integrator='euler',tolerance=1e-10,boundary_on={9},"
            "boundary=2*'open',force_on='body 1' $\n",
            x ? 2 : 1, x ? 1 : 2, axis, across, x ? ".5,.7,.7,.5" : ".5,.5,.7,.7",
            x ? ".41,.41,.61,.61" : ".41,.61,.61,.41", x ? "20,10" : "10,20", x ? "left" : "bottom",
            x ? "1.,0." : "0.,1.", ends));
    return run.history.column("body_force_" + axis + "_1");
  };
  const auto along_x = forces_along("x"), along_y = forces_along("y");
  ASSERT_EQ(along_x.size(), along_y.size());
  for (std::size_t k = 0; k < along_x.size(); ++k) EXPECT_NEAR(along_y[k], along_x[k], 1e-8) << k;
  EXPECT_LT(along_x.back(), -0.5);
}

TEST(ImmersedForces, RoundWallBearsABodyThatIsClampedToIt) {
  double coarse = 0;
  for (const int n : {8, 16}) {
    const DeckRun run = round_run(n);
    expect_balance(run, 2);
    const double weight = (solid - fluid) * g * run.first("body_mass_1") / solid, hold = run.last("body_hold_y_1");
    EXPECT_NEAR(run.last("side_clamp_y_1"), -hold, 1e-8 * weight) << n;
    EXPECT_NEAR(run.last("body_force_y_1") / run.last("side_force_y_3"), 1, 1e-3) << n;  // of water around it
    EXPECT_NEAR(coarse == 0 ? 1 : hold / coarse, 1, 1e-3);
    coarse = hold;
  }
}

TEST(ImmersedForces, TwoWallsBearABeam) {
  for (const int n : across()) {
    const DeckRun run = beam_run(n);
    expect_balance(run, 4);
    for (const std::string axis : {"x", "y"}) {
      const double clamps = run.last("side_clamp_" + axis + "_3") + run.last("side_clamp_" + axis + "_4");
      EXPECT_NEAR(clamps, -run.last("body_hold_" + axis + "_1"), 1e-6) << n;
    }
  }
}

/// Its support is no wall's.
TEST(ImmersedForces, BodyHeldInMidFluidLoadsNoWall) {
  const DeckRun run = run_text("mid", box_group + square + "xvi(1,2)=.33,.52,.52,.33,yvi(1,2)=.3,.3,.61,.61 $\n" +
                                          "$mesh cells(1,1)=16,16,cells(1,2)=4,6,element='q2' $\n" + laws +
                                          "fix_on='2.bottom',fix(1:2,1)=0.,0. $\n" + flow +
                                          "'1.bottom','1.top','1.left','1.right' $\n");
  const double weight = (solid - fluid) * g * run.first("body_mass_1") / solid;
  double walls = 0;
  for (int w = 1; w <= 4; ++w) {
    walls += run.last(fmt::format("side_force_y_{}", w));
    EXPECT_EQ(run.last(fmt::format("side_clamp_y_{}", w)), 0);
  }
  EXPECT_NEAR(walls, -fluid * g, 1e-8 * weight);
  EXPECT_NEAR(run.last("body_hold_y_1"), weight, 1e-8 * weight);
  EXPECT_NEAR(run.last("body_force_y_1"), 2 * weight, 1e-8 * weight);
  EXPECT_NEAR(run.last("body_torque_z_1"), 0, 1e-3 * weight);
}

/// A stiff flap on the floor of a channel of 2 n x n elements: forces on it, on floor and ceiling, and on its sides.
std::array<double, 4> forces_of_stream(int n) {
  const DeckRun run = run_text(
      "stream",
      "a flap in a stream\n$in nx=2,ny=2,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=1.,tstep=.2,iout(33)=1,tiout(33)=1. "
      "$\n"
      "$reg nreg=2,nvi=2*4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,densir=1.,1.,matr(1,1)=.1,matr(1,2)=2.e3,.3,"
      "xvi(1,2)=.73,.92,.92,.73,yvi(1,2)=0.,0.,.41,.41 $\n" +
          fmt::format("$mesh cells(1,1)={},{},cells(1,2)={},{},element='q2' $\n", 2 * n, n, n / 8, n * 3 / 8) + laws +
          "fix_on='2.bottom',fix(1:2,1)=0.,0. $\n$flow integrator='euler',tolerance=1e-9,boundary_on='1.left',"
          "'1.right',boundary='inflow','open',boundary_u='4*y*(1-y)',force_on='1.bottom','1.top',"
          "'2.left+2.top+2.right' $\n");
  return {run.last("body_force_x_1"), run.last("side_force_x_1"), run.last("side_force_x_2"),
          run.last("side_force_x_3")};
}

/// They settle by orders of 0.9 to 1.2, and those on its sides come to be that on all of it. What 64 x 32 elements give
/// is known by default, and found at full length.
TEST(ImmersedForces, OfAFlapInAStreamSettle) {
  const std::array<double, 4> known{2.25368109, 2.63003019, 1.34379451, 2.20827213};
  const auto coarse = forces_of_stream(8), middle = forces_of_stream(16);
  const auto fine = at_full_length() ? forces_of_stream(32) : known;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(std::abs(fine[k] - middle[k]), 0.55 * std::abs(middle[k] - coarse[k])) << k;
    EXPECT_LT(std::abs(middle[k] - coarse[k]), 0.55 * std::abs(coarse[k])) << k;
  }
  const auto apart = [](const std::array<double, 4>& forces) { return std::abs(forces[3] / forces[0] - 1); };
  EXPECT_LT(apart(fine), 0.7 * apart(middle));
  EXPECT_LT(apart(middle), 0.7 * apart(coarse));
  if (!at_full_length()) return;
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fine[k] / known[k], 1, 1e-7) << k;
  EXPECT_LT(apart(fine), 0.025);
}

/// Two plates whose ends are one: the nodes there count once.
TEST(ImmersedForces, WallsThatEndAtPeriodicSides) {
  const DeckRun run =
      floor_run(16, "'1.bottom','1.top'", ",boundary_on='1.left',boundary='periodic',boundary_with='1.right'");
  expect_balance(run, 2);
}

}  // namespace
}  // namespace tether::cases
