// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/run_deck.hpp"

// Fluids of much viscosity that fill the box, with free bodies and without, in steps in which friction crosses the box.
// Density, size and speeds are 1.

namespace tether::cases {
namespace {

/// A body of .2 by .2; its density, stiffness and velocity are given.
std::string body(double x, double density, double stiffness, double speed) {
  return fmt::format(
      "$reg nreg=1, nvi=4, densir(1)={}, xvi(1,1)={},{},{},{}, yvi(1,1)=.4,.4,.6,.6, matr(1,1)={},.3, vrx(1)={} $\n"
      "$mesh cells(1,1)=2,2 $\n",
      density, x - 0.1, x + 0.1, x + 0.1, x - 0.1, stiffness, speed);
}

/// The fluid's cells are the grid's, or triangles.
constexpr std::array flows{"grid", "mesh"};
/// These in linear steps, and triangles in steps that keep the solids' energy.
constexpr std::array flows_and_steps{std::pair("grid", "linear"), std::pair("mesh", "linear"),
                                     std::pair("mesh", "energy")};

/// A body that a channel's flow carries is as fast as in short steps (1.547 where the fluid slips along it), and it
/// does not run away: with the pressures of the step before it left at 7.5. By default until t = .5, and steps that
/// keep the energy, of which each takes as long as five linear ones, where the fluid slips.
TEST(ViscousBox, CarriesABodyAsFastAsItFlows) {
  for (const auto& [flow, step] : flows_and_steps) {
    for (const auto& [slips, speed] : {std::pair(".true.", 1.547), std::pair(".false.", 1.47)}) {
      const bool takes_long = step == std::string("energy") && slips == std::string(".false.");
      if (takes_long && !at_full_length()) continue;
      const double time = at_full_length() ? 1 : 0.5;
      const DeckRun run = run_text(
          "carried",
          fmt::format("$in nx=65, ny=17, xleft=0., xright=4., ybot=0., ytop=1., tmax={}, tstep=.05, "
                      "iout(33)=1, tiout(33)=.05 $\n{}$coupled density=1., viscosity=10., flow='{}', step='{}', "
                      "bodies_slip={}, side(2)='open', jet_on(1)='left', jet_speed(1)=1. $\n",
                      time, body(0.6, 1, 1e5, 0), flow, step, slips));
      const auto v = run.history.column("body_vx_1");
      EXPECT_NEAR(v.back(), speed, 0.03) << flow << step << slips;
      EXPECT_LT(*std::max_element(v.begin(), v.end()), 1.04 * speed) << flow << step << slips;
      EXPECT_EQ(run.summary.at("friction_unsettled"), 0);
    }
  }
}

/// A stiff body that is let go in a fluid at rest comes to rest. It neither swings back nor gains energy, however long
/// the steps.
TEST(ViscousBox, StopsABodyForGood) {
  for (const auto& [flow, step] : flows_and_steps) {
    for (const auto& [viscosity, slips] :
         {std::pair(10., ".false."), std::pair(1e4, ".false."), std::pair(1e4, ".true.")}) {
      const DeckRun run = run_text(
          "stopped",
          fmt::format("$in nx=17, ny=17, xleft=0., xright=1., ybot=0., ytop=1., tmax=.08, tstep=.01, "
                      "iout(33)=1, tiout(33)=.01 $\n{}$coupled density=1., viscosity={}, flow='{}', step='{}', "
                      "bodies_slip={} $\n",
                      body(0.5, 3, 1e9, 1), viscosity, flow, step, slips));
      const auto v = run.history.column("body_vx_1"), energy = run.history.column("energy_total");
      EXPECT_GT(*std::min_element(v.begin(), v.end()), -0.01) << viscosity << flow << step << slips;
      for (std::size_t k = 1; k < energy.size(); ++k)
        EXPECT_LT(energy[k] - energy[k - 1], 1e-4 * energy[0]) << viscosity << flow << step << slips << k;
    }
  }
}

/// The heat of Poiseuille's flow is 12 mu U^2 L / H a time, and its columns of energy are not those of errors.
TEST(ViscousBox, HeatsAtTheRateOfItsStrain) {
  for (const char* flow : flows) {
    for (const double viscosity : {1.0, 1e4}) {
      const DeckRun run =
          run_text("heated", fmt::format("$in nx=33, ny=17, xleft=0., xright=4., ybot=0., ytop=1., tmax=2., tstep=.1, "
                                         "iout(33)=1, tiout(33)=.1 $\n$coupled density=1., viscosity={}, flow='{}', "
                                         "side(2)='open', jet_on(1)='left', jet_speed(1)=1. $\n",
                                         viscosity, flow));
      const auto heat = run.history.column("energy_viscous"), t = run.history.column("time");
      const std::size_t half = t.size() / 2;
      EXPECT_NEAR((heat.back() - heat[half]) / (t.back() - t[half]) / (12 * viscosity * 4), 1, 0.17)
          << viscosity << flow;
      EXPECT_LT(run.summary.at("friction_passes"), 60);
    }
  }
}

/// A plate that is held between walls has the drag of Poiseuille's flow in both gaps, 2 mu U (6 / g^2) a length, here
/// on triangles: within what its ends add.
TEST(ViscousBox, APlateHasTheDragOfItsGaps) {
  const DeckRun run = run_text(
      "plate",
      "$in nx=65, ny=21, xleft=0., xright=4., ybot=0., ytop=1., tmax=.5, tstep=.05, iout(33)=1, tiout(33)=.05 $\n"
      "$reg nreg=1, nvi=4, densir(1)=1, xvi(1,1)=1.,3.,3.,1., yvi(1,1)=.45,.45,.55,.55, matr(1,1)=1e5,.3 $\n"
      "$mesh cells(1,1)=40,2 $\n$fem fix_on(1)='1.left','1.right','1.bottom','1.top', fix(1:2,1)=0.,0., "
      "fix(1:2,2)=0.,0., fix(1:2,3)=0.,0., fix(1:2,4)=0.,0. $\n"
      "$coupled density=1., viscosity=1., flow='mesh', bodies_slip=.false., side(2)='open', jet_on(1)='left', "
      "jet_speed(1)=1. $\n");
  const double gap = 0.45, fall = 12 * 0.5 / std::pow(gap, 3);  // of the pressure, by length
  const double drag = 2 * fall * (0.1 + gap);                   // of a length of 2: on both ends and along both gaps
  EXPECT_NEAR(run.last("body_force_x_1") / drag, 1, 0.17);
  EXPECT_GT(run.last("body_force_x_1"), drag);
}

/// A stream at an angle through a box that is open all round has no friction, in the plane and in space, and goes on as
/// it comes: what comes in along a side's own direction counts, too.
TEST(ViscousBox, AStreamThroughOpenSidesGoesOn) {
  for (const char* flow : flows) {
    for (const bool space : {false, true}) {
      const DeckRun run = run_text(
          "stream",
          fmt::format("$in nx={0}, ny={0}, xleft=0., xright=1., ybot=0., ytop=1., tmax={3}, tstep=.01, iout(33)=1, "
                      "tiout(33)={3} $\n$coupled density=1., viscosity=.01, u0=1., v0=-.5, side(1:4)='open','open',"
                      "'open','open', flow='{1}'{2} $\n",
                      space ? 9 : 41, flow, space ? ", nz=9, zback=0., zfront=1., side(5:6)='open','open', w0=.25" : "",
                      at_full_length() ? ".2" : ".05"));
      const double energy = 0.5 * (1.25 + (space ? 0.0625 : 0));
      EXPECT_NEAR(run.last("energy_fluid") / energy, 1, 1e-11) << flow << space;
      EXPECT_NEAR(run.last("energy_open"), 0, 1e-11) << flow << space;
      EXPECT_NEAR(run.last("energy_advected"), 0, 1e-11) << flow << space;
      EXPECT_NEAR(run.last("energy_viscous"), 0, 1e-12) << flow << space;
    }
  }
}

}  // namespace
}  // namespace tether::cases
