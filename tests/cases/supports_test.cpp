// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cases/run_deck.hpp"

// Forces and torques of supports.

namespace tether::cases {
namespace {

/// A beam of 4 x 1 with a load on its end, and gravity.
std::string beam(const std::string& fem, const std::string& more = "") {
  return "a beam\n$in nx=2,ny=2,xleft=-9.,xright=9.,ybot=-9.,ytop=9.,wl=1,wr=1,wb=1,wt=1,tmax=1.,tstep=.01,gravc=-.5,"
         "iout(33)=1,tiout(33)=.01 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,4.,4.,0.,yvi(1,1)=0.,0.,1.,1.,densir(1)=.3,"
         "matr(1,1)=1.e4,.3 $\n$mesh element='q2',cells(1,1)=8,2 $\n$fem law(1)='svk',fix_on(1)='1.left',fix(1:2,1)=0.,"
         "0.,load_on(1)='1.right',load(1:2,1)=2.,.1," +
         fem + " $\n" + more;
}

TEST(Supports, HoldWhatLoadsAndGravityDo) {
  const DeckRun run = run_text("beam", beam("static=.true."));
  const double weight = 0.3 * 4 * 0.5;
  EXPECT_NEAR(run.last("support_force_x_1"), -2, 1e-8);
  EXPECT_NEAR(run.last("support_force_y_1"), -0.1 + weight, 1e-8);
  // About the middle of the clamped side; loads act where the beam has gone to.
  const double x = run.last("body_x_1"), tip = run.last("support_torque_z_1");
  EXPECT_NEAR(tip, weight * x - 0.1 * 4, 0.02);
}

/// The forces over time are the change of momentum, by every integrator: of implicit steps exactly.
TEST(Supports, ChangeTheMomentum) {
  for (const auto& [integrator, within] :
       {std::pair("energy", 1e-8), {"midpoint", 1e-8}, {"trapezoid", 1e-8}, {"central", 2e-3}}) {
    SCOPED_TRACE(integrator);
    const DeckRun run = run_text("beam", beam("integrator='" + std::string(integrator) + "',cfl=.5"));
    const auto dt = run.history.column("dt"), time = run.history.column("time");
    const auto fx = run.history.column("support_force_x_1"), fy = run.history.column("support_force_y_1");
    double px = 2 * time.back(), py = (0.1 - 0.3 * 4 * 0.5) * time.back(), most = 0;
    for (std::size_t k = 1; k < dt.size(); ++k) {
      px += fx[k] * (time[k] - time[k - 1]), py += fy[k] * (time[k] - time[k - 1]);
      most = std::max(most, std::abs(fx[k]));
    }
    EXPECT_GT(most, 2.5);
    if (std::string(integrator) == "central") continue;  // history has a few of its steps only
    EXPECT_NEAR(run.last("momentum_x"), px, within);
    EXPECT_NEAR(run.last("momentum_y"), py, within);
  }
}

/// Explicit steps as far as history has each of them.
TEST(Supports, OfExplicitStepsHoldABodyThatRests) {
  const DeckRun run = run_text("beam", beam("integrator='central',settle=.true.,alpha=5."));
  EXPECT_NEAR(run.last("support_force_x_1"), -2, 1e-6);
  EXPECT_NEAR(run.last("support_force_y_1"), -0.1 + 0.3 * 4 * 0.5, 1e-6);
  EXPECT_NEAR(run.first("support_force_x_1"), -2, 1e-6);
}

/// A node that two supports hold counts to the last one; walls come after the deck's supports.
TEST(Supports, WallsComeAfterThem) {
  const DeckRun run =
      run_text("beam", beam("static=.true.,fix_on(4)='1.bottom',fix(2,4)=0."), {"in.xright=4.0", "in.wr=4"});
  double up = 0, along = 0;
  for (const char* k : {"1", "2", "3"}) {
    up += run.last(std::string("support_force_y_") + k);
    along += run.last(std::string("support_force_x_") + k);
  }
  EXPECT_NEAR(up, -0.1 + 0.3 * 4 * 0.5, 1e-8);
  EXPECT_NEAR(along, -2, 1e-8);
  EXPECT_LT(run.last("support_force_x_3"), -0.5);
  EXPECT_NEAR(run.last("support_force_x_2"), 0, 1e-12);
}

}  // namespace
}  // namespace tether::cases
