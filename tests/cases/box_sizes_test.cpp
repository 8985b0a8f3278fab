// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cases/run_deck.hpp"

// What a grid makes of obstacles, voids and closed parts of a box, and what it does not hold there: said by the
// program.

namespace tether::cases {
namespace {

/// A box of 2 x 1 (x 1) with cells of .25, one step of a fluid that does not move.
std::string still(bool in_space, const std::string& coupled) {
  return std::string(
             "$in nx=9,ny=5,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.01,tstep=.01,iout(33)=1,tiout(33)=.01 $\n") +
         "$coupled density=1.,side(2)='open'," + (in_space ? "nz=5,zback=0.,zfront=1.," : "") + coupled + " $\n";
}

long count(const std::vector<std::string>& texts, const std::string& part) {
  return std::count_if(texts.begin(), texts.end(),
                       [&](const auto& text) { return text.find(part) != std::string::npos; });
}

/// Of its cells: those whose middles lie in it.
TEST(BoxSizes, OfObstaclesAndVoidsAreInTheSummary) {
  const auto volume = [](bool in_space, const std::string& kind, const std::string& box) {
    return run_text("sizes", still(in_space, kind + "(1,1)=" + box)).summary.at(kind + "_volume");
  };
  for (const char* kind : {"obstacle", "void"}) {
    EXPECT_NEAR(volume(false, kind, ".3,1.2,.1,.6"), 0.5, 1e-14);
    EXPECT_NEAR(volume(false, kind, ".25,1.25,0.,.5"), 0.5, 1e-14);
    EXPECT_NEAR(volume(true, kind, ".3,1.2,.1,.6,.2,.7"), 0.25, 1e-14);
    EXPECT_NEAR(volume(true, kind, ".25,1.25,0.,.5,.25,.75"), 0.25, 1e-14);
  }
}

/// A bag on the left side, which a jet fills through its mouth there.
const char* const bag =
    "$in nx=21,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.04,tstep=.02,iout(33)=1,tiout(33)=.02 $\n"
    "$reg nreg=3,nvi=4,4,4,densir(1)=3*1000.,xvi(1,1)=0.,.5,.4,0.,yvi(1,1)=.2,.2,.3,.3,\n"
    "xvi(1,2)=.5,.5,.4,.4,yvi(1,2)=.2,.8,.7,.3,xvi(1,3)=0.,.4,.5,0.,yvi(1,3)=.7,.7,.8,.8,\n"
    "matr(1,1)=1e5,.3,matr(1,2)=1e5,.3,matr(1,3)=1e5,.3 $\n"
    "$mesh element='p1',cells(1,1)=8,2,cells(1,2)=8,2,cells(1,3)=8,2 $\n"
    "$fem fix_on(1)='1.left',fix(1:2,1)=0.,0.,fix_on(2)='3.left',fix(1:2,2)=0.,0. $\n"
    "$coupled density=1000.,side(2)='open',jet_on(1)='left',jet(1:2,1)=.4,.6,jet_speed(1)=.1 $\n";

/// Nothing measures its volume; that of a bag without a jet, and that outside of it, are not what the term holds.
TEST(BoxSizes, AVolumeThatTheVolumeTermDoesNotHoldIsToldOnce) {
  const char* const text = "volume_term does not hold its volume";
  const auto told = [&](const std::vector<std::string>& overrides) {
    return count(run_text("bag", bag, overrides).messages, text);
  };
  EXPECT_EQ(told({}), 1);
  EXPECT_EQ(told({"coupled.mode='symmetric'"}), 1);
  EXPECT_EQ(told({"coupled.volume_term=.false."}), 0);
  EXPECT_EQ(told({"coupled.jet_speed(1)=0."}), 0);
  EXPECT_EQ(told({"coupled.jet(1,1)=.85", "coupled.jet(2,1)=.95"}), 0);
}

}  // namespace
}  // namespace tether::cases
