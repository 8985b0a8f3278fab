// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cases/run_deck.hpp"

// Bodies whose nodes stand further apart than the fluid's: the fluid goes through, and the program says so.

namespace tether::cases {
namespace {

/// A flap on the floor of a channel, of so many elements, for some steps.
DeckRun flap(const std::string& element, const std::string& cells) {
  return run_text("flap", fmt::format("a flap in a stream\n$in nx=2,ny=2,xleft=0.,xright=3.1,ybot=0.,ytop=.83,tmax=.02,"
                                      "tstep=.01,iout(33)=1,tiout(33)=.01 $\n"
                                      "$reg nreg=2,nvi=4,4,xvi(1,1)=0.,3.1,3.1,0.,yvi(1,1)=0.,0.,.83,.83,"
                                      "densir=1000.,1300.,matr(1,1)=1.5,xvi(1,2)=.93,.99,.99,.93,"
                                      "yvi(1,2)=0.,0.,.34,.34,matr(1,2)=2.e6,.4 $\n"
                                      "$mesh element='{}',cells(1,1)=25,8,cells(1,2)={} $\n"
                                      "$fem law='fluid','neo-hookean',fix_on='2.bottom',fix(1,1)=0.,0. $\n"
                                      "$flow boundary_on(1)='1.left',boundary(1)='inflow',"
                                      "boundary_u(1)='3*y*(.83-y)*min(t/.3,1)',boundary_on(2)='1.right',"
                                      "boundary(2)='open',boundary_on(3)='1.top',boundary(3)='slip' $\n",
                                      element, cells));
}

bool told(const DeckRun& run) {
  return std::ranges::any_of(run.warnings, [](const std::string& text) {
    return text.find("times as far apart as the fluid's") != std::string::npos;
  });
}

/// The fluid's elements are .124 x .104, of order 2: its nodes stand .052 apart along the flap.
TEST(ImmersedSpacing, OfCoarseBodiesIsTold) {
  const DeckRun coarse = flap("q2", "1,1");  // .34 long: .17 apart
  ASSERT_TRUE(told(coarse));
  EXPECT_NE(coarse.warnings[0].find("region 2: its q2 elements are up to 0.34 long in a fluid of elements 0.104 long "
                                    "there, their nodes 3.28 times"),
            std::string::npos)
      << coarse.warnings[0];
  EXPECT_TRUE(told(flap("q1", "1,3")));   // .113 apart
  EXPECT_FALSE(told(flap("q2", "1,3")));  // .057 apart
  EXPECT_FALSE(told(flap("q1", "1,6")));
}

}  // namespace
}  // namespace tether::cases
