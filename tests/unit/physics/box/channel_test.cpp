// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of a box against what is known of them: a viscous channel, a jet that swells, a body that leaves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/box/solver.hpp"
#include "unit/physics/box/plan_support.hpp"

namespace tether::coupled {
namespace {

double column(const CoupledSolver& solver, const std::string& name) {
  const auto names = solver.history_layout().column_names();
  return solver.record()[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

/// A channel 1 high and 2 long of 8 cells across, which fluid of mean speed 1 flows through.
const char* const channel_of_8_cells =
    "$in nx=17,ny=9,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=20.,tstep=.1 $\n"
    "$coupled density=1.,viscosity=1.,side(2)='open',jet_on(1)='left',jet_speed(1)=1. $\n";

/// By the pressures of two cells next to the middle, half a channel's length from its end.
double pressure_gradient(const CoupledSolver& solver) {
  const Snapshot cells = solver.grid();
  const auto find = [&](const char* name) {
    return std::find_if(cells.fields.begin(), cells.fields.end(),
                        [&](const Field& field) { return field.quantity.name == name; });
  };
  const std::vector<double>& p = find("p")->values;
  const std::size_t middle = 4 * 16 + 10;
  return (p[middle] - p[middle + 2]) / 0.25;
}

/// Viscosity acts and the pressure follows: where each had all of the step to itself, a steady flow was another at each
/// length of the steps, its drag 4.4, 6.7, 10.4 where it is 12. That of cells of d is 12/(1 + 2 d^2), by a parabola
/// whose mean they have with a wall half a cell away.
TEST(ViscousChannel, HasOneSteadyFlowWhateverTheStep) {
  const double exact = 12 / (1 + 2. / 64);
  for (const auto& [step, time] : {std::pair(0.2, 8.), std::pair(0.05, 3.), std::pair(0.01, 1.)}) {
    const Plan plan = plan_of(channel_of_8_cells, {"in.tstep=" + std::to_string(step)});
    CoupledSolver solver(plan);
    solver.advance(time);
    EXPECT_NEAR(pressure_gradient(solver) / exact, 1, 2e-3) << step;
  }
}

/// What a jet brings in within a step is h times its mean there.
TEST(SwellingJet, BringsItsIntegralInStepsOfAnyLength) {
  for (const char* step : {"in.tstep=.05", "in.tstep=.1"}) {
    const Plan plan = plan_of(
        "$in nx=9,ny=9,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.5,tstep=.05 $\n"
        "$coupled density=1.,side(2)='open',jet_on(1)='left',jet(1:2,1)=.213,.557,jet_speed(1)=1.3,jet_smoke(1)=2.,\n"
        "jet_expression(1)='sin(pi*t)' $\n",
        {step});
    CoupledSolver solver(plan);
    solver.advance(0.5);
    EXPECT_NEAR(column(solver, "smoke_in") / (1.3 * 0.344 * 2 / std::numbers::pi), 1, 1e-6) << step;
  }
}

/// A block that a stream takes along is reported once, as it is wholly out of the box.
TEST(LeavingBody, IsToldOfOnceWithItsPlaceAndTime) {
  const Plan plan = plan_of(
      "$in nx=11,ny=11,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.8,tstep=.02 $\n"
      "$reg nreg=1,nvi=4,densir(1)=1000.,matr(1,1)=1e6,.3,xvi(1,1)=.5,.7,.7,.5,yvi(1,1)=.32,.32,.62,.62,vrx(1)=1. $\n"
      "$mesh element='p1',cells(1,1)=2,3 $\n$coupled density=1000.,u0=1.,side(1)='open','open' $\n");
  CoupledSolver solver(plan);
  solver.take_messages();
  solver.advance(0.48);
  EXPECT_TRUE(solver.take_messages().empty());
  solver.advance(0.8);
  const auto messages = solver.take_messages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find("body 1 has left the box by its right"), std::string::npos) << messages[0];
  const Summary summary = solver.more_summary();
  EXPECT_NE(std::find(summary.begin(), summary.end(), std::pair<std::string, std::string>("bodies_left", "1")),
            summary.end());
}

}  // namespace
}  // namespace tether::coupled
