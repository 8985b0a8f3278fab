// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

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

/// A body that a channel's flow carries is as fast as in short steps (1.547 where the fluid slips along it), and it
/// does not run away: with the pressures of the step before it left at 7.5.
TEST(ViscousBox, CarriesABodyAsFastAsItFlows) {
  for (const auto& [slips, speed] : {std::pair(".true.", 1.547), std::pair(".false.", 1.47)}) {
    const DeckRun run = run_text(
        "carried", fmt::format("$in nx=65, ny=17, xleft=0., xright=4., ybot=0., ytop=1., tmax=1., tstep=.05, "
                               "iout(33)=1, tiout(33)=.05 $\n{}$coupled density=1., viscosity=10., bodies_slip={}, "
                               "side(2)='open', jet_on(1)='left', jet_speed(1)=1. $\n",
                               body(0.6, 1, 1e5, 0), slips));
    const auto v = run.history.column("body_vx_1");
    EXPECT_NEAR(v.back(), speed, 0.03) << slips;
    EXPECT_LT(*std::max_element(v.begin(), v.end()), 1.04 * speed) << slips;
    EXPECT_EQ(run.summary.at("friction_unsettled"), 0);
  }
}

/// A stiff body that is let go in a fluid at rest comes to rest. It neither swings back nor gains energy, however long
/// the steps.
TEST(ViscousBox, StopsABodyForGood) {
  for (const auto& [viscosity, slips] :
       {std::pair(10., ".false."), std::pair(1e4, ".false."), std::pair(1e4, ".true.")}) {
    const DeckRun run = run_text(
        "stopped", fmt::format("$in nx=17, ny=17, xleft=0., xright=1., ybot=0., ytop=1., tmax=.08, tstep=.01, "
                               "iout(33)=1, tiout(33)=.01 $\n{}$coupled density=1., viscosity={}, bodies_slip={} $\n",
                               body(0.5, 3, 1e9, 1), viscosity, slips));
    const auto v = run.history.column("body_vx_1"), energy = run.history.column("energy_total");
    EXPECT_GT(*std::min_element(v.begin(), v.end()), -0.01) << viscosity << slips;
    for (std::size_t k = 1; k < energy.size(); ++k)
      EXPECT_LT(energy[k] - energy[k - 1], 1e-4 * energy[0]) << viscosity << slips << k;
  }
}

/// The heat of Poiseuille's flow is 12 mu U^2 L / H a time, and its columns of energy are not those of errors.
TEST(ViscousBox, HeatsAtTheRateOfItsStrain) {
  for (const double viscosity : {1.0, 1e4}) {
    const DeckRun run =
        run_text("heated", fmt::format("$in nx=33, ny=17, xleft=0., xright=4., ybot=0., ytop=1., tmax=2., tstep=.1, "
                                       "iout(33)=1, tiout(33)=.1 $\n$coupled density=1., viscosity={}, side(2)='open', "
                                       "jet_on(1)='left', jet_speed(1)=1. $\n",
                                       viscosity));
    const auto heat = run.history.column("energy_viscous"), t = run.history.column("time");
    const std::size_t half = t.size() / 2;
    EXPECT_NEAR((heat.back() - heat[half]) / (t.back() - t[half]) / (12 * viscosity * 4), 1, 0.15) << viscosity;
    EXPECT_LT(run.summary.at("friction_passes"), 60);
  }
}

}  // namespace
}  // namespace tether::cases
