// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Bodies whose nodes stand further apart than the fluid's, and those that are thin in its cells: the program says so.

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

bool any_has(const std::vector<std::string>& texts, const std::string& what) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return text.find(what) != std::string::npos; });
}

bool told(const DeckRun& run, const std::string& what = "times as far apart as the fluid's") {
  return any_has(run.warnings, what);
}

/// A plate 0.1 thick across a stream in cells of h from x = 0.8 on, of 0.1 before; it goes `speed` in a time of 1.
DeckRun plate(const std::string& element, double x, int cells_after) {
  return run_text("plate",
                  fmt::format("a plate\n$in nx=2,ny=2,xleft=0.,xright=1.6,ybot=0.,ytop=1.,tmax=.4,tstep=.1,iout(33)=1,"
                              "tiout(33)=.1 $\n"
                              "$reg nreg=3,nvi=3*4,xvi(1,1)=0.,.8,.8,0.,yvi(1,1)=0.,0.,1.,1.,xvi(1,2)=.8,1.6,1.6,.8,"
                              "yvi(1,2)=0.,0.,1.,1.,densir=3*1.,matr(1,1)=1.,matr(1,2)=1.,xvi(1,3)={0},{1},{1},{0},"
                              "yvi(1,3)=.3,.3,.7,.7,matr(1,3)=100.,.3 $\n"
                              "$mesh element='q2',cells(1,1)=8,10,cells(1,2)={2},10,cells(1,3)=1,4 $\n"
                              "$fem law='fluid','fluid','neo-hookean' $\n"
                              "$flow element='{3}',boundary_on(1)='1.left',boundary(1)='inflow',boundary_u(1)='1.',"
                              "boundary_on(2)='2.right',boundary(2)='open',boundary_on(3)='1.top',boundary(3)='slip',"
                              "boundary_on(4)='1.bottom',boundary(4)='slip',boundary_on(5)='2.top',boundary(5)='slip',"
                              "boundary_on(6)='2.bottom',boundary(6)='slip',u0='1.' $\n",
                              x, x + 0.1, cells_after, element));
}

/// The fluid's elements are .124 x .104, of order 2: its nodes stand .052 apart along the flap.
TEST(ImmersedSpacing, OfCoarseBodiesIsTold) {
  const DeckRun coarse = flap("q2", "1,1");  // .34 long: .17 apart
  ASSERT_TRUE(told(coarse));
  EXPECT_TRUE(std::ranges::any_of(coarse.warnings, [](const std::string& warning) {
    return warning.find(
               "region 2: its q2 elements are up to 0.34 long in a fluid of elements 0.104 long there, their "
               "nodes 3.28 times") != std::string::npos;
  }));
  EXPECT_TRUE(told(flap("q1", "1,3")));   // .113 apart
  EXPECT_FALSE(told(flap("q2", "1,3")));  // .057 apart
  EXPECT_FALSE(told(flap("q1", "1,6")));
}

TEST(ImmersedSpacing, OfThinBodiesIsTold) {
  const std::string thin = "cells of the fluid thick";
  const DeckRun one = plate("q1q1", 0.25, 8);
  EXPECT_TRUE(told(one, "region 3: it is 1 cells of the fluid thick"));
  EXPECT_NEAR(one.summary.at("cells_across"), 1, 1e-6);
  EXPECT_FALSE(told(plate("q2q1", 0.25, 8), thin));
}

/// The stream takes the plate from cells of 0.1 to such of 0.4, of which it is a quarter thick, or to such of 0.025,
/// where its nodes stand four times as far apart as the fluid's.
TEST(ImmersedSpacing, OfBodiesThatComeToOtherCellsIsTold) {
  const DeckRun coarse = plate("q2q1", 0.55, 2), fine = plate("q2q1", 0.55, 32);
  EXPECT_TRUE(coarse.warnings.empty() && fine.warnings.empty());
  EXPECT_TRUE(any_has(coarse.messages, "region 3 has come where it is"));
  EXPECT_LT(coarse.summary.at("cells_across"), 0.6);
  EXPECT_TRUE(any_has(fine.messages, "the bodies have come where their nodes stand"));
  EXPECT_NEAR(fine.summary.at("node_spacing"), 4, 0.2);
}

}  // namespace
}  // namespace tether::cases
