// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

// A fluid in a box and elastic solids, solved together, against exact solutions.

namespace tether::cases {
namespace {

using Overrides = std::vector<std::string>;

/// A stiff block across a channel .25 high, 1 long and closed, on a spring, with v = .05 at the start: its frequency is
/// sqrt(k/m) = 1 Hz with the water's mass, 1000 (1 - .1) .25 = 225, added to its own of 12.5.
std::string piston(int nx) {
  return "$in nx=" + std::to_string(nx) + ",ny=" + std::to_string((nx - 1) / 4 + 1) +
         ",xleft=0.,xright=1.,ybot=0.,ytop=.25,tmax=4.,tstep=.008333333333333333,iout(33)=1,tiout(33)=.00833333333 $\n"
         "$reg nreg=1,nvi=4,densir(1)=500.,xvi(1,1)=.45,.55,.55,.45,yvi(1,1)=0.,0.,.25,.25,matr(1,1)=1e8,.3,\n"
         "vrx(1)=.05 $\n$mesh element='p1',cells(1,1)=4,10 $\n"
         "$coupled density=1000.,side(1)='open','open',spring_on(1)='region 1',spring(1,1)=9376.03,\n"
         "integrator='trapezoid' $\n";
}

/// Frequency by the passages of zero of the block's way, and the logarithmic decrement of its turning points.
struct DampedSwing {
  double frequency = 0, damping = 0;
};
DampedSwing damped_swing_of(const DeckRun& run) {
  const auto& t = run.history.column("time");
  const auto& x = run.history.column("body_x_1");
  std::vector<double> passages, peaks;
  const double middle = 0.5;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double a = x[k - 1] - middle, b = x[k] - middle;
    if ((a < 0) != (b < 0)) passages.push_back(t[k - 1] + (t[k] - t[k - 1]) * a / (a - b));
    if (k + 1 == x.size()) continue;
    const double c = x[k + 1] - middle;
    if (std::abs(b) < std::abs(a) || std::abs(b) < std::abs(c) || (b > 0) != (c > 0)) continue;
    const double slope = (c - a) / 2, curve = a - 2 * b + c;
    peaks.push_back(std::abs(b - slope * slope / (2 * curve)));
  }
  const double halves = static_cast<double>(passages.size() - 1);
  return {halves / 2 / (passages.back() - passages.front()),
          std::log(peaks.front() / peaks.back()) / (std::numbers::pi * static_cast<double>(peaks.size() - 1))};
}

TEST(Coupled, PistonSwingsWithTheMassOfTheWater) {
  EXPECT_NEAR(damped_swing_of(run_text("piston", piston(33))).frequency, 1, 0.0005);
  const Overrides whole_cells{"coupled.mode='symmetric'"};
  EXPECT_NEAR(damped_swing_of(run_text("piston", piston(33), whole_cells)).frequency, 1, 0.01);
  EXPECT_NEAR(damped_swing_of(run_text("piston", piston(65), whole_cells)).frequency, 1, 0.005);
}

/// Of order 2, and without damping but for what carrying the velocity along takes.
TEST(Coupled, PistonByTheTrapezoidalRule) {
  const Overrides small = {"coupled.mode='cut-cell'", "reg.vrx(1)=.005", "in.tmax=3."};
  const auto at = [&](const char* step) {
    return damped_swing_of(run_text("piston", piston(33), with(small, {step})));
  };
  const DampedSwing a = at("in.tstep=.0333333333333333"), b = at("in.tstep=.0166666666666667"),
                    c = at("in.tstep=.00833333333333333");
  EXPECT_NEAR((a.frequency - b.frequency) / (b.frequency - c.frequency), 4, 0.6);
  EXPECT_NEAR(c.frequency, 1, 5e-4);
  EXPECT_LT(std::abs(c.damping), 0.001);
}

/// The paper's step damps by h omega/4.
TEST(Coupled, PistonByThePapersStep) {
  for (const auto& [step, h] :
       {std::pair("in.tstep=.00833333333333333", 1. / 120), std::pair("in.tstep=.0166666666666667", 1. / 60)}) {
    const DampedSwing swing = damped_swing_of(run_text(
        "piston", piston(33), {"coupled.mode='cut-cell'", "coupled.integrator='paper'", "reg.vrx(1)=.005", step}));
    EXPECT_NEAR(swing.damping / (h * 2 * std::numbers::pi / 4), 1, 0.05) << step;
  }
}

/// Water in a ring of rubber that falls on a floor.
std::string balloon(const std::string& E, const std::string& step) {
  std::string deck = "$in nx=49,ny=49,xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=2.,tstep=" + step +
                     ",gravc=-9.81,iout(33)=1,tiout(33)=.0166666666667 $\n"
                     "$reg nreg=4,nvi=4,4,4,4,densir(1)=4*1000.,xvi(1,1)=1.32,1.4,1.,1.,yvi(1,1)=.9,.9,1.3,1.22,\n"
                     "xvi(1,2)=1.,1.,.6,.68,yvi(1,2)=1.22,1.3,.9,.9,xvi(1,3)=.68,.6,1.,1.,yvi(1,3)=.9,.9,.5,.58,\n"
                     "xvi(1,4)=1.,1.,1.4,1.32,yvi(1,4)=.58,.5,.9,.9";
  for (const char* r : {"1", "2", "3", "4"}) deck += ",matr(1," + std::string(r) + ")=" + E + ",.45";
  deck += " $\n$mesh element='p1'";
  for (const std::string r : {"1", "2", "3", "4"}) {
    deck += ",cells(1," + r + ")=2,16";
    for (const std::string s : {"2", "4"})
      deck += ",\nedge(" + s + "," + r + ")='arc',edge_xc(" + s + "," + r + ")=1.,edge_yc(" + s + "," + r + ")=.9";
  }
  return deck + " $\n$coupled density=1000.,fluid_in='cavities',obstacle(1,1)=0.,2.,0.,.1,friction=.3 $\n";
}

/// Errors of the water's area: at the end, and the worst.
std::array<double, 2> area_errors(const DeckRun& run) {
  const bool first = run.first("volume_sheet_1") < run.first("volume_sheet_2");
  const auto& cavity = run.history.column(first ? "volume_sheet_1" : "volume_sheet_2");
  double worst = 0;
  for (const double area : cavity) worst = std::max(worst, std::abs(area / cavity.front() - 1));
  return {std::abs(cavity.back() / cavity.front() - 1), worst};
}

TEST(Coupled, BalloonKeepsItsWater) {
  for (const char* E : {"2e5", "2e6"}) {
    const DeckRun run = run_text("balloon", balloon(E, ".0166666666666667"));
    const auto errors = area_errors(run);
    EXPECT_LE(errors[0], 5e-4) << E;
    EXPECT_LE(errors[1], 0.04) << E;
    EXPECT_LE(run.summary.at("interface_mismatch"), 1e-9) << E;
  }
  const DeckRun fine =
      run_text("balloon", balloon("2e5", at_full_length() ? ".00416666666666667" : ".00833333333333333"));
  EXPECT_LE(area_errors(fine)[0], 5e-4);
  EXPECT_LE(area_errors(fine)[1], 0.04);
  const DeckRun without = run_text("balloon", balloon("2e5", ".0166666666666667"), {"coupled.volume_term=.false."});
  EXPECT_GT(area_errors(without)[0], 0.005);
}

/// A block that falls on a floor through next to nothing, by steps that are long for its waves.
DeckRun landing(const char* corners, const Overrides& overrides) {
  const std::string deck =
      "$in nx=17,ny=17,xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=1.5,tstep=.005,gravc=-9.81,iout(33)=1,tiout(33)=.005 $\n"
      "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e6,.3," +
      std::string(corners) +
      " $\n$mesh element='p1',cells(1,1)=4,4 $\n"
      "$coupled density=1e-3,side(1)='open','open','wall','open' $\n";
  return run_text("landing", deck, overrides);
}
const char* const tilted = "xvi(1,1)=.89,1.18,1.11,.82,yvi(1,1)=.45,.56,.75,.64";
const char* const flat = "xvi(1,1)=.85,1.15,1.15,.85,yvi(1,1)=.45,.45,.65,.65";

/// The most that contact and the step's own error together give it in a step, over the energy at the start.
double given_in_a_step(const DeckRun& run) {
  const auto& taken = run.history.column("energy_contact");
  const auto& lost = run.history.column("energy_solid_step");
  double most = 0;
  for (std::size_t k = 1; k < taken.size(); ++k) most = std::max(most, taken[k - 1] - taken[k] + lost[k - 1] - lost[k]);
  return most / run.first("energy_total");
}

/// Contact gives it no energy, and it comes to rest with its weight on the floor: .18 of the energy is left to a block
/// that lies, and more where steps resolve its waves, which the trapezoidal rule does not damp.
TEST(Coupled, LandingsGiveNoEnergy) {
  for (const char* friction : {"coupled.friction=0.", "coupled.friction=.3"}) {
    const auto check = [&](const char* corners, const char* E, const char* integrator, double most) {
      const DeckRun run = landing(corners, {E, friction, integrator});
      const auto& energy = run.history.column("energy_total");
      EXPECT_LT(*std::max_element(energy.begin(), energy.end()), 1.001 * energy[0]) << E << friction << integrator;
      EXPECT_LT(energy.back(), most * energy[0]) << E << friction << integrator;
      EXPECT_EQ(run.summary.at("contact_unsettled"), 0) << E << friction << integrator;
      return run;
    };
    for (const char* E : {"reg.matr(1,1)=1e6", "reg.matr(1,1)=1e7", "reg.matr(1,1)=1e9"})
      check(tilted, E, "coupled.integrator='paper'", 0.17);
    check(flat, "reg.matr(1,1)=1e6", "coupled.integrator='trapezoid'", 0.26);
    for (const char* E : {"reg.matr(1,1)=1e7", "reg.matr(1,1)=1e8", "reg.matr(1,1)=1e9"})
      EXPECT_LT(given_in_a_step(check(flat, E, "coupled.integrator='trapezoid'", 0.2)), 0.003) << E << friction;
  }
}

/// What lies on the floor is not looked for anew each step.
TEST(Coupled, WhatLiesStaysInTouch) {
  const DeckRun run = landing(flat, {});
  EXPECT_LT(run.summary.at("contact_solutions"), 0.1 * run.summary.at("steps"));
}

/// A bar that stands in a stream.
const char* const bar =
    "$in nx=65,ny=33,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.5,tstep=.0333333333333333,iout(33)=1,tiout(33)=.0333 $\n"
    "$reg nreg=1,nvi=4,densir(1)=1000.,xvi(1,1)=.7,.8,.8,.7,yvi(1,1)=0.,0.,.5,.5,matr(1,1)=1e6,.3 $\n"
    "$mesh element='p1',cells(1,1)=3,12 $\n$fem fix_on(1)='1.bottom',fix(1:2,1)=0.,0.,beta=0. $\n"
    "$coupled density=1000.,jet_on(1)='left',jet_speed(1)=1.,side(2)='open' $\n";
const char* const bar_in_space =
    "$in nx=17,ny=9,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.2,tstep=.0333333333333333,iout(33)=1,tiout(33)=.0333 $\n"
    "$reg nreg=1,nvi=4,densir(1)=1000.,xvi(1,1)=.7,.8,.8,.7,yvi(1,1)=0.,0.,.5,.5,matr(1,1)=1e6,.3 $\n"
    "$mesh element='p1',cells(1,1)=2,6,4,z(1,1)=.3,.7 $\n$fem fix_on(1)='1.bottom',fix(1:3,1)=0.,0.,0.,beta=0. $\n"
    "$coupled density=1000.,jet_on(1)='left',jet_speed(1)=1.,side(2)='open',nz=9,zback=0.,zfront=1. $\n";

double mismatch(const char* deck, const Overrides& overrides) {
  return run_text("bar", deck, overrides).summary.at("interface_mismatch");
}

/// With one map and its transpose the fluid gives what the solids take; with the paper's two maps it does not.
TEST(Coupled, PowerThatTheFluidGivesIsThatWhichTheSolidsTake) {
  for (const char* deck : {bar, bar_in_space}) {
    EXPECT_LE(mismatch(deck, {}), 1e-9);
    EXPECT_LE(mismatch(deck, {"coupled.mode='symmetric'"}), 1e-9);
    EXPECT_LE(mismatch(deck, {"coupled.solver='krylov'"}), 1e-9);
  }
  EXPECT_GT(mismatch(bar, {"coupled.mode='paper'"}), 1e-3);
}

const Overrides light = {"in.tmax=.4"};

bool holds(const Overrides& overrides) {
  try {
    const DeckRun run = run_text("bar", bar, with(light, overrides));
    const auto& x = run.history.column("body_x_1");
    return std::all_of(x.begin(), x.end(), [](double at) { return at > 0.7 && at < 1.2; });
  } catch (const RunError&) {
    return false;
  }
}

/// Density over the fluid's, stiffness and damping.
Overrides bar_of(const char* density, const char* E, const char* beta) {
  return {std::string("reg.densir(1)=") + density, std::string("reg.matr(1,1)=") + E, std::string("fem.beta=") + beta};
}

TEST(Coupled, BarHoldsAtAnyStepWhereSplittingDoesNot) {
  for (const char* step : {"in.tstep=.0666666666666667", "in.tstep=.0333333333333333", "in.tstep=.00833333333333333"}) {
    EXPECT_TRUE(holds(with(bar_of("1000.", "1e6", "0."), {step}))) << step;
    EXPECT_TRUE(holds(with(bar_of("1000.", "1e7", "0."), {step, "coupled.mode='symmetric'"}))) << step;
  }
  EXPECT_TRUE(holds(with(bar_of("1000.", "1e6", "0."), {"in.tstep=.00416666666666667", "in.tmax=.1"})));
  for (const char* step : {"in.tstep=.0333333333333333", "in.tstep=.00833333333333333"})
    EXPECT_FALSE(holds(with(bar_of("1000.", "1e6", "0."), {step, "coupled.mode='splitting'"}))) << step;
  EXPECT_TRUE(holds(with(bar_of("1e6", "1e8", "0."), {"coupled.mode='splitting'"})));
}

/// A block on the floor of an empty box, with nothing but its weight and friction.
std::string block(const std::string& more, const std::string& coupled) {
  return "$in nx=17,ny=9,xleft=0.,xright=4.,ybot=0.,ytop=2.,tmax=1.,tstep=.01,gravc=-10.,iout(33)=1,tiout(33)=.01 $\n"
         "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e7,.3," +
         more +
         " $\n$mesh element='p1',cells(1,1)=4,2 $\n"
         "$fem beta=.002 $\n$coupled density=1.,void(1,1)=0.,4.,0.,1.75," +
         coupled + " $\n";
}
const char* const on_the_floor = "xvi(1,1)=.5,1.5,1.5,.5,yvi(1,1)=0.,0.,.5,.5,vrx(1)=2.";

/// It comes to rest on the floor, which then bears its weight; in all, what gravity and floor give is its momentum.
TEST(Coupled, BlockFallsOnTheFloor) {
  const DeckRun run = run_text("block", block("xvi(1,1)=.5,1.5,1.5,.5,yvi(1,1)=.3,.3,.8,.8", ""));
  const auto& t = run.history.column("time");
  const auto& v = run.history.column("body_vy_1");
  const auto& push = run.history.column("body_hold_y_1");
  double given = 0;
  for (std::size_t k = 1; k < t.size(); ++k) {
    given += (push[k] - 5000) * (t[k] - t[k - 1]);
    EXPECT_GE(push[k], -1e-6) << t[k];
    EXPECT_NEAR(500 * v[k], given, 1e-6 * 500) << t[k];
  }
  EXPECT_NEAR(run.last("body_vy_1"), 0, 1e-3);
  EXPECT_NEAR(push.back() / 5000, 1, 0.01);
  EXPECT_NEAR(run.last("body_y_1"), 0.25, 1e-3);
}

/// A block of .3 x .2 in water, open at the top, its lower side less than half a cell above the floor or on it.
std::string block_in_water(const std::string& density, double gap) {
  return "$in nx=33,ny=33,xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=.5,tstep=.005,gravc=-9.81,iout(33)=1,tiout(33)=.005 "
         "$\n"
         "$reg nreg=1,nvi=4,densir(1)=" +
         density + ",matr(1,1)=1e6,.3,xvi(1,1)=.85,1.15,1.15,.85,yvi(1,1)=2*" + std::to_string(gap) + ",2*" +
         std::to_string(gap + 0.2) +
         " $\n$mesh element='p1',cells(1,1)=4,4 $\n$coupled density=1000.,side(4)='open' $\n";
}

/// What is lighter than water leaves the floor, what is heavier presses on it with its weight less the water's.
TEST(Coupled, WaterGetsUnderABlockOnTheFloor) {
  for (const std::string mode : {"coupled.mode='symmetric'", "coupled.mode='cut-cell'", "coupled.mode='paper'"}) {
    for (const double gap : {0.0, 0.001, 0.03}) {
      const DeckRun light = run_text("light", block_in_water("500.", gap), {mode});
      EXPECT_GT(light.last("body_y_1"), 0.25) << mode << gap;
      if (mode == "coupled.mode='paper'") continue;  // it has two maps
      EXPECT_LE(light.summary.at("interface_mismatch"), 1e-9) << mode << gap;
    }
    const double weight = 9.81 * 0.06 * (2000 - 1000);
    EXPECT_NEAR(run_text("heavy", block_in_water("2000.", 0), {mode}).last("body_hold_y_1") / weight, 1, 0.05) << mode;
  }
}

TEST(Coupled, BlockSlidesAsCoulombSays) {
  const DeckRun run = run_text("block", block(on_the_floor, "friction=.3"));
  const auto& t = run.history.column("time");
  const auto& v = run.history.column("body_vx_1");
  for (std::size_t k = 0; k < t.size(); ++k) EXPECT_NEAR(v[k], std::max(2 - 3 * t[k], 0.), 0.06) << t[k];
  EXPECT_NEAR(run.last("body_x_1"), 1 + 2. * 2 / (2 * 3), 0.01);
  EXPECT_NEAR(run.last("body_vx_1"), 0, 1e-6);
  const DeckRun smooth = run_text("block", block(on_the_floor, ""));
  EXPECT_NEAR(smooth.last("body_vx_1"), 2, 1e-9);
}

}  // namespace
}  // namespace tether::cases
