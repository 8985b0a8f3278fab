// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Bodies that a flow on a mesh carries onto each other: on coarse cells the fluid between them does not keep them
// apart.

namespace tether::cases {
namespace {

/// A heavy block sinks onto a lighter one, and both onto a plane above the bottom of a closed box.
std::string sinking(const std::string& contact, double time = 2, double step = .005) {
  return fmt::format(
             "two blocks that sink\n$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=1.5,gravc=-10.,tmax={},"
             "tstep={},iout(33)=1,tiout(33)=.005 $\n",
             time, step) +
         "$reg nreg=3,nvi=4,4,4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.5,1.5,"
         "xvi(1,2)=.2,.7,.7,.2,yvi(1,2)=.3,.3,.5,.5,xvi(1,3)=.35,.75,.75,.35,yvi(1,3)=.75,.75,.95,.95,"
         "densir(1)=1.,2.,20.,matr(1,1)=.1,matr(1,2)=1000.,.3,matr(1,3)=1000.,.3 $\n"
         "$mesh element='q2',cells(1,1)=6,9,cells(1,2)=7,3,cells(1,3)=6,3 $\n"
         "$fem law(1)='fluid','neo-hookean','neo-hookean' $\n$flow element='q2q1' $\n" +
         contact;
}

double highest(const DeckRun& run, const char* column) {
  const auto values = run.history.column(column);
  return *std::max_element(values.begin(), values.end());
}

/// In steps of .005, or .02.
TEST(ImmersedContact, KeepsBodiesApart) {
  const double step = at_full_length() ? .005 : .02;
  const DeckRun through = run_text("sink", sinking("", 2, step));
  EXPECT_GT(through.summary.at("nodes_inside"), 0);
  const DeckRun met = run_text("sink", sinking("$contact plane(1,1)=0.,.02,0.,1. $\n", 2, step));
  EXPECT_EQ(met.summary.at("nodes_inside"), 0);
  EXPECT_GT(highest(met, "contact_sides"), 0);
  EXPECT_LE(met.summary.at("energy_drift"), 1e-6);
}

/// What friction and damped contact take has columns of its own, and is lost nowhere else: until t = 2, or until the
/// upper block, which comes down at .8, has slid on the lower one for some steps.
TEST(ImmersedContact, FrictionIsBooked) {
  const DeckRun run =
      run_text("rub", sinking("$contact friction=.4,plane(1,1)=0.,.02,0.,1. $\n", at_full_length() ? 2 : .85));
  EXPECT_EQ(run.summary.at("nodes_inside"), 0);
  EXPECT_GT(run.last("energy_contact_damped"), 0);
  EXPECT_GT(run.last("energy_friction"), 0);
  EXPECT_LE(run.summary.at("energy_drift"), 1e-6);
}

}  // namespace
}  // namespace tether::cases
