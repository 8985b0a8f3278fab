// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "cases/run_deck.hpp"

// The force on a side that ends at another one: it has no part of what acts there.

namespace tether::cases {
namespace {

/// Viscosity 1.9, a channel 2.3 long and .37 wide, from y = -.11; the parabola's largest speed 1.2.
constexpr double mu = 1.9, channel_length = 2.3, width = 0.37, speed = 1.2;

DeckRun parabola(const std::string& more) {
  return run_text("channel",
                  "a parabola\n$in nx=2,ny=2,xleft=.2,xright=2.5,ybot=-.11,ytop=.26,tmax=1.,tstep=.25,iout(33)=1,"
                  "tiout(33)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=.2,2.5,2.5,.2,yvi(1,1)=-.11,-.11,.26,.26,densir=870.,"
                  "matr(1,1)=1.9 $\n$mesh cells(1,1)=5,4,grading(1,1)=1.3 $\n$fem law='fluid' $\n"
                  "$flow steady=.true.,boundary_on(1)='1.left',boundary(1)='inflow',"
                  "boundary_u(1)='4*1.2*(y+.11)*(.26-y)/.37^2',boundary_on(2)='1.right',boundary(2)='open'," +
                      more + " $\n");
}

/// The exact shear and pressure, whatever the mesh: biquadratic velocities contain the parabola.
TEST(SideForce, OfAWallFromAnInflowToAnOpenSide) {
  const DeckRun run = parabola("force_on(1)='1.bottom',force_on(2)='1.top',force_x(1)=.2,force_y(1)=-.11");
  const double drag = mu * 4 * speed / width * channel_length, slope = 8 * mu * speed / (width * width);
  const double lift = slope * channel_length * channel_length / 2, torque = slope * std::pow(channel_length, 3) / 6;
  EXPECT_NEAR(run.last("side_force_x_1"), drag, 1e-6 * drag);
  EXPECT_NEAR(run.last("side_force_x_2"), drag, 1e-6 * drag);
  EXPECT_NEAR(run.last("side_force_y_1"), -lift, 1e-6 * lift);
  EXPECT_NEAR(run.last("side_force_y_2"), lift, 1e-6 * lift);
  EXPECT_NEAR(run.last("side_torque_z_1"), -torque, 1e-6 * torque);
}

/// Of half the channel, whose middle line slips: the wall has the same shear, the line none, and both the pressure.
TEST(SideForce, OfAWallAndOfALineOfSymmetry) {
  const DeckRun run =
      run_text("half",
               "half a parabola\n$in nx=2,ny=2,xleft=0.,xright=2.,ybot=0.,ytop=.5,tmax=1.,tstep=.25,iout(33)=1,"
               "tiout(33)=1. $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,.5,.5,densir=1.,matr(1,1)=1. $\n"
               "$mesh cells(1,1)=5,3 $\n$fem law='fluid' $\n$flow steady=.true.,boundary_on(1)='1.left',"
               "boundary(1)='inflow',boundary_u(1)='4*y*(1-y)',boundary_on(2)='1.right',boundary(2)='open',"
               "boundary_on(3)='1.top',boundary(3)='slip',force_on(1)='1.bottom',force_on(2)='1.top',"
               "force_on(3)='1.left' $\n");
  EXPECT_NEAR(run.last("side_force_x_1"), 8, 1e-6);
  EXPECT_NEAR(run.last("side_force_x_2"), 0, 1e-6);
  EXPECT_NEAR(run.last("side_force_y_1"), -16, 1e-6);
  EXPECT_NEAR(run.last("side_force_y_2"), 16, 1e-6);
  EXPECT_NEAR(run.last("side_force_x_3"), -8, 1e-6);  // 16 of the pressure, on half the width
}

/// Water at rest presses on the floor from above alone.
TEST(SideForce, OfTheFloorOfATank) {
  for (const char* element : {"q2q1", "q1q1"}) {
    const DeckRun run = run_text(
        "floor",
        fmt::format("water at rest\n$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=.7,tmax=.1,tstep=.05,"
                    "gravc=-9.81,iout(33)=1,tiout(33)=.05 $\n"
                    "$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,.7,.7,densir=1000.,matr(1,1)=1. $\n"
                    "$mesh cells(1,1)=7,9 $\n$fem law='fluid' $\n"
                    "$flow element='{}',boundary_on='1.right',boundary='open',level=.7,force_on='1.bottom' $\n",
                    element));
    EXPECT_NEAR(run.last("side_force_x_1"), 0, 1e-6) << element;
    EXPECT_NEAR(run.last("side_force_y_1"), -6867, 1e-6 * 6867) << element;
  }
}

}  // namespace
}  // namespace tether::cases
