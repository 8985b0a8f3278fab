// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "cases/run_deck.hpp"

// Each exchange of energy of the finite element path in its own column, against what theory says of it; and that what
// is left of the balance is small.

namespace tether::cases {
namespace {

/// A channel 2 x 1 of a fluid of density 2 and viscosity .5; `sides` of $flow says what its sides do.
std::string channel(const std::string& flow, const std::string& in = "") {
  return "a channel\n$in nx=2,ny=2,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.5,tstep=.05,iout(33)=1,tiout(33)=.05" + in +
         " $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=2.,matr(1,1)=.5 $\n"
         "$mesh cells(1,1)=8,6 $\n$fem law(1)='fluid' $\n$flow tolerance=1e-10," +
         flow + " $\n";
}

double relative(double value, double exact) { return std::abs(value / exact - 1); }

/// A parabola u = y (1 - y) that goes through: the inflow works with the difference of pressures 2 mu L Q, which
/// viscosity takes; kinetic energy comes in and goes out alike.
TEST(FemBalance, AnInflowDoesTheWorkThatViscosityTakes) {
  for (const char* element : {"'q2q1'", "'q1q1'"}) {
    const DeckRun run = run_text("parabola", channel(std::string("element=") + element +
                                                     ",u0='y*(1-y)',boundary_on(1)='1.left',boundary(1)='inflow',"
                                                     "boundary_u(1)='y*(1-y)',boundary_on(2)='1.right',"
                                                     "boundary(2)='open'"));
    const double heat = 0.5 * 2.0 / 3 * 0.5;               // mu L <(1 - 2 y)^2> t
    const double within = element[2] == '2' ? 1e-9 : 0.1;  // six bilinear elements are coarse for it
    EXPECT_LT(relative(run.last("energy_viscous"), heat), within) << element;
    EXPECT_LT(relative(run.last("energy_inflow") + run.last("energy_open"), heat), within) << element;
    EXPECT_LT(std::abs(run.last("energy_walls")), 1e-12) << element;
    EXPECT_LT(run.summary.at("energy_drift"), 1e-8) << element;
  }
}

/// A lid over a periodic channel: u = y is driven by the force mu an area.
TEST(FemBalance, AMovingWallDoesTheWorkThatViscosityTakes) {
  const DeckRun run =
      run_text("couette", channel("u0='y',boundary_on(1)='1.top',boundary(1)='moving',boundary_u(1)='1',"
                                  "boundary_on(2)='1.left',boundary(2)='periodic',boundary_with(2)='1.right'"));
  EXPECT_LT(relative(run.last("energy_walls"), 0.5 * 2 * 0.5), 1e-9);
  EXPECT_LT(relative(run.last("energy_viscous"), 0.5 * 2 * 0.5), 1e-9);
  EXPECT_LT(run.summary.at("energy_drift"), 1e-9);
}

/// A body force b on a fluid at rest between periodic sides without friction: v = b t, the work rho V b^2 t^2/2.
TEST(FemBalance, ABodyForceIsAColumnOfItsOwn) {
  const DeckRun run =
      run_text("pushed", channel("bx='3',boundary_on(1)='1.top',boundary(1)='slip',boundary_on(2)='1.bottom',"
                                 "boundary(2)='slip',boundary_on(3)='1.left',boundary(3)='periodic',"
                                 "boundary_with(3)='1.right'"));
  EXPECT_LT(relative(run.last("energy_body_forces"), 2 * 2 * 9 * 0.25 / 2), 1e-6);
  EXPECT_LT(relative(run.last("energy_kinetic"), run.last("energy_body_forces")), 1e-9);
}

/// A vortex whose velocities are free of divergence against the pressure's functions only: what advection loses is a
/// column, and nothing is left; of backward Euler what its steps lose, too.
TEST(FemBalance, WhatTheMethodLosesIsInColumns) {
  for (const char* integrator : {"'midpoint'", "'euler'"}) {
    for (const char* element : {"'q2q1'", "'q1q1'"}) {
      const DeckRun run = run_text("vortex", channel(std::string("element=") + element + ",integrator=" + integrator +
                                                     ",u0='sin(pi*x/2)*cos(pi*y)*4',v0='-cos(pi*x/2)*sin(pi*y)*2',"
                                                     "boundary_on(1)='1.right',boundary(1)='open'"));
      EXPECT_LT(run.summary.at("energy_drift"), 1e-7) << element << integrator;
      EXPECT_GT(std::abs(run.summary.at("energy_lost")), 1e-6) << element << integrator;
    }
  }
}

TEST(FemBalance, BodiesInAFlowAreInIt) {
  for (const char* integrator : {"'midpoint'", "'euler'"}) {
    const DeckRun run =
        run_deck("disk", {"in.tmax=.2", "in.tstep=.05", "mesh.cells(1,1)=16,16", "mesh.cells(1,2)=4,4",
                          "mesh.cells(1,3)=2,4", "mesh.cells(1,4)=2,4", "mesh.cells(1,5)=2,4", "mesh.cells(1,6)=2,4",
                          std::string("flow.integrator=") + integrator, "flow.tolerance=1e-10", "reg.densir(2)=2.",
                          "reg.densir(3)=2.", "reg.densir(4)=2.", "reg.densir(5)=2.", "reg.densir(6)=2."});
    EXPECT_LT(run.summary.at("energy_drift"), 1e-7) << integrator;
    EXPECT_GT(run.last("energy_walls"), 0);
  }
}

/// Loads and supports apart: a bar pulled by 1e-3 in ten equilibria works F u/2 where it is held, and F where it goes.
TEST(FemBalance, LoadsAndSupportsAreApart) {
  const DeckRun pulled = run_deck(
      "bar-vibration", {"fem.static=.true.", "fem.settle=.false.", "fem.law(1)='linear'", "fem.load(1,1)=1e-3",
                        "fem.load_time(1,1)=0.,1.", "fem.load_factor(1,1)=0.,1.", "in.tmax=1.0", "in.tstep=0.1"});
  EXPECT_LT(relative(pulled.last("energy_loads"), pulled.last("energy_strain")), 1e-9);
  EXPECT_EQ(pulled.last("energy_supports"), 0);
  EXPECT_EQ(pulled.summary.count("energy_drift"), 0u);  // equilibria have no time in which energy is exchanged
  EXPECT_LT(pulled.summary.at("equilibrium_residual"), 1e-9);
}

TEST(FemBalance, SteadyFlowsHaveNone) {
  const DeckRun run = run_deck("cavity", {"mesh.cells(1,1)=8,8"});
  EXPECT_EQ(run.summary.count("energy_drift"), 0u);
  EXPECT_EQ(run.summary.count("energy_growth"), 0u);
  EXPECT_LT(run.summary.at("steady_residual"), 1e-5);
}

/// What the guide says of bodies that nothing holds is in summary.txt.
TEST(FemBalance, FreeBodiesKeepTheirMomenta) {
  for (const char* name : {"l-block", "elastic-body"}) {
    const DeckRun run = run_deck(name, {"in.tmax=8."});
    EXPECT_LT(run.summary.at("momentum_drift"), 1e-9) << name;
    EXPECT_LT(run.summary.at("angular_momentum_drift"), 1e-9) << name;
  }
  const DeckRun rigid = run_deck("rigid-free", {"in.tmax=10."});
  EXPECT_LT(rigid.summary.at("angular_momentum_drift"), 1e-12);
  const DeckRun held = run_deck("bar-vibration", {"in.tmax=.1"});
  EXPECT_EQ(held.summary.count("momentum_drift"), 0u);
}

}  // namespace
}  // namespace tether::cases
