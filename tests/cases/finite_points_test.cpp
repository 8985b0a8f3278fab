// SPDX-License-Identifier: GPL-3.0-or-later
// Decks whose regions of points carry F, by law(r) of $reg: exact periods, the same words on a mesh, and what is
// refused, warned of, or stops the run.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics.hpp"
#include "cases/run_deck.hpp"

namespace tether::cases {
namespace {

bool says(const std::vector<std::string>& messages, const std::string& part) {
  return std::ranges::any_of(messages, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// A column of length 1 between slip walls that a little gravity finds unstrained, on N cells.
DeckRun fallen(int N, const std::string& law, int ipath) {
  const double h = 1.0 / N;
  return run_text(
      "column",
      fmt::format("a column that gravity finds unstrained\n$in nx=2,ny={},xleft=0.,xright={:.17g},ybot=0.,ytop=1.25,"
                  "wl=6,wr=6,wb=4,wt=1,tmax=2.5,tstep={:.17g},dtmax={:.17g},igen=1,gravc=-.0005,iout(33)=1,"
                  "tiout(33)=.01 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,{:.17g},{:.17g},0.,yvi(1,1)=0.,0.,1.,1.,nprg=4,"
                  "densir(1)=1.,matr(1,1)=1.,.3,ipath(4,1)={},law(1)='{}' $\n$mpm method='robust' $\n",
                  5 * N / 4 + 1, h, 0.4 * h, 0.4 * h, h, h, ipath, law));
}

/// The first return of a column's velocity to zero, which is at half its period.
double half_period(const DeckRun& run) {
  const auto t = run.history.column("time"), v = run.history.column("body_vy_1");
  std::size_t k = 1;
  while (k + 2 < v.size() && v[k] * v[k + 1] > 0) ++k;
  return t[k] + (t[k + 1] - t[k]) * v[k] / (v[k] - v[k + 1]);
}

// 2 L / c, c = sqrt(M / rho): M = lambda + 2 mu in plane strain, E / (1 - nu^2) in plane stress.
TEST(FinitePoints, ABarVibratesAtItsExactFrequency) {
  for (const auto& [law, ipath] : {std::pair("neo-hookean", 0), {"svk", 0}, {"neo-hookean", 2}, {"svk", 2}}) {
    const double nu = 0.3, modulus = ipath == 0 ? (1 - nu) / ((1 + nu) * (1 - 2 * nu)) : 1 / (1 - nu * nu);
    const double exact = 2 / std::sqrt(modulus);
    double errors[2];
    for (int k = 0; k < 2; ++k) {
      const DeckRun run = fallen(20 << k, law, ipath);
      errors[k] = std::abs(half_period(run) / exact - 1);
      EXPECT_LT(run.summary.at("energy_drift"), 1e-10);
    }
    EXPECT_LT(errors[1], 0.002) << law << ipath;
    EXPECT_GT(errors[0] / errors[1], 1.8) << law << ipath;
  }
}

/// A block that falls on a floor.
DeckRun dropped(const std::vector<std::string>& overrides) {
  return run_text("dropped",
                  "a block that falls on a floor\n$in nx=41,ny=41,xleft=0.,xright=2.,ybot=0.,ytop=2.,wl=6,wr=6,wb=6,"
                  "wt=1,tmax=2.5,tstep=.01,dtmax=.01,igen=1,gravc=-1.,iout(33)=1,tiout(33)=.02 $\n"
                  "$reg nreg=1,nvi=4,xvi(1,1)=.5,1.5,1.5,.5,yvi(1,1)=.5,.5,1.5,1.5,nprg=9,densir(1)=1.,"
                  "matr(1,1)=2.,.3,ipath(4,1)=0,law(1)='neo-hookean' $\n$mpm method='robust' $\n",
                  overrides);
}

// It is squeezed to half its volume; the step follows the waves in it, so that one ten times too long changes nothing
// but the error of the steps.
TEST(FinitePoints, ABlockThatIsSqueezedBouncesByAnyDecksStep) {
  const DeckRun run = dropped({}), longer = dropped({"in.tstep=.1", "in.dtmax=.1"});
  for (const DeckRun* of : {&run, &longer}) {
    EXPECT_LT(of->summary.at("energy_drift"), 1e-11);
    EXPECT_EQ(of->summary.at("energy_growth"), 1);
    EXPECT_LT(of->summary.at("volume_worst"), 0.6);
  }
  const double at_rest = 0.65 * 0.05 / std::sqrt(2 * 0.7 / (1.3 * 0.4));  // the limit of the robust method's steps
  EXPECT_LT(longer.summary.at("dt_min"), 0.6 * at_rest);
  EXPECT_NEAR(longer.last("body_y_1"), run.last("body_y_1"), 0.02 * run.last("body_y_1"));
  EXPECT_TRUE(says(longer.messages, "in strained solids waves run at") || says(longer.warnings, "steps are limited"));
}

// Of St Venant-Kirchhoff nothing holds what is squeezed by more than .58: the same block gives way.
TEST(FinitePoints, WhatGivesWayStopsTheRun) {
  EXPECT_THROW(dropped({"reg.law(1)='svk'"}), RunError);
  try {
    dropped({"mpm.method='thesis'", "reg.matr(2,1)=.499", "reg.ipath(4,1)=2"});
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("is turned inside out (J = "), std::string::npos) << error.what();
  }
}

TEST(FinitePoints, WhatIsStretchedFarApartIsToldOnce) {
  const auto hanging = [](const char* nprg) {
    return run_text("hanging",
                    "a soft column that hangs\n$in nx=2,ny=61,xleft=0.,xright=.05,ybot=-2.,ytop=1.,wl=6,wr=6,wb=1,wt=0,"
                    "tmax=1.5,tstep=.005,dtmax=.005,igen=1,gravc=-.3,iout(33)=1,tiout(33)=.1 $\n"
                    "$reg nreg=1,nvi=4,xvi(1,1)=0.,.05,.05,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=1.,matr(1,1)=1.,.3,"
                    "ipath(4,1)=0,law(1)='neo-hookean' $\n$mpm method='robust' $\n",
                    {std::string("reg.nprg(1)=") + nprg});
  };
  const DeckRun few = hanging("4"), many = hanging("16");
  EXPECT_EQ(std::ranges::count_if(few.messages,
                                  [](const std::string& text) { return text.find("cells apart") != text.npos; }),
            1);
  EXPECT_FALSE(says(many.messages, "cells apart"));
  EXPECT_NEAR(many.summary.at("points_apart"), 0.5 * few.summary.at("points_apart"), 0.02);
}

// law of $reg and law of $fem name the same law of a mesh; two of them that differ are refused.
TEST(FinitePoints, TheSameWordsHoldOnAMesh) {
  const auto on_mesh = [](const std::string& reg, const std::string& fem) {
    return run_text("mesh",
                    "a block on a mesh\n$in nx=2,ny=2,xleft=-1.,xright=2.,ybot=-1.,ytop=2.,wl=1,wr=1,wb=1,wt=1,"
                    "tmax=.2,tstep=.05,gravc=-1.,iout(33)=1,tiout(33)=.05 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,"
                    "yvi(1,1)=0.,0.,1.,1.,densir(1)=1.,matr(1,1)=5.,.3" +
                        reg + " $\n$mesh cells(1,1)=2,2 $\n$fem fix_on(1)='1.left',fix(1:2,1)=0.,0." + fem + " $\n");
  };
  const DeckRun reg = on_mesh(",law(1)='neo-hookean',volumetric(1)='mixed'", ""),
                fem = on_mesh("", ",law(1)='neo-hookean',volumetric(1)='mixed'"), other = on_mesh("", ",law(1)='svk'");
  EXPECT_EQ(reg.history.column("energy_strain"), fem.history.column("energy_strain"));
  EXPECT_NE(reg.history.column("energy_strain"), other.history.column("energy_strain"));
  EXPECT_THROW(on_mesh(",law(1)='svk'", ",law(1)='neo-hookean'"), InputError);
}

TEST(FinitePoints, LawsOutOfRangeAreRefused) {
  EXPECT_THROW(dropped({"reg.matr(2,1)=.5"}), InputError);
  EXPECT_THROW(dropped({"reg.matr(1,1)=0."}), InputError);
  EXPECT_THROW(dropped({"in.cyl=1.", "in.wl=5", "reg.ipath(4,1)=2"}), InputError);
}

}  // namespace
}  // namespace tether::cases
