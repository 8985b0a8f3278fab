// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/run_deck.hpp"

// Bodies that come through one another: counted, and told once.

namespace tether::cases {
namespace {

/// Two blocks .4 wide and .2 apart that meet at t = .1.
const char* const plane_blocks =
    "$reg nreg=2,nvi=4,4,densir(1)=2*1000.,xvi(1,1)=.5,.9,.9,.5,yvi(1,1)=.8,.8,1.2,1.2,\n"
    "xvi(1,2)=1.1,1.5,1.5,1.1,yvi(1,2)=.85,.85,1.15,1.15,matr(1,1)=1e6,.3,matr(1,2)=1e6,.3,vrx(1)=1.,-1. $\n";
const char* const frame =
    "xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=.3,tstep=.01,iout(33)=1,tiout(33)=.01,wl=1,wr=1,wb=1,wt=1 $\n";

void expect_told(const DeckRun& run) {
  const auto& t = run.history.column("time");
  const auto& inside = run.history.column("nodes_inside");
  for (std::size_t k = 0; k < t.size(); ++k) {
    const bool before = t[k]<0.095, after = t[k]> 0.125 && t[k] < 0.2;
    EXPECT_TRUE(!before || inside[k] == 0) << t[k];
    EXPECT_TRUE(!after || inside[k] > 0) << t[k];
  }
  EXPECT_EQ(run.summary.at("nodes_inside"), *std::max_element(inside.begin(), inside.end()));
  const auto tells = [](const std::string& text) { return text.find("lies inside body") != std::string::npos; };
  ASSERT_EQ(std::count_if(run.messages.begin(), run.messages.end(), tells), 1);
  const std::string text = *std::find_if(run.messages.begin(), run.messages.end(), tells);
  for (const char* part : {"t = 0.1", "body 1 (region 1)", "body 2 (region 2)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  const auto place = text.find(" at (");
  ASSERT_NE(place, std::string::npos) << text;
  EXPECT_NEAR(std::stod(text.substr(place + 5)), 1, 0.02) << text;  // sides at 1.01 and .99
}

TEST(Overlaps, OfBodiesInAFluid) {
  expect_told(run_text("plane", std::string("$in nx=17,ny=17,") + frame + plane_blocks +
                                    "$mesh element='p1',cells(1,1)=4,4,cells(1,2)=3,3 $\n"
                                    "$coupled density=1e-3,side(1)=4*'open' $\n"));
}

TEST(Overlaps, OfBodiesInAFluidInSpace) {
  expect_told(
      run_text("space", std::string("$in nx=9,ny=9,") + frame + plane_blocks +
                            "$mesh element='p1',cells(1,1)=2,2,1,cells(1,2)=2,2,1,z(1,1)=.8,1.2,z(1,2)=.85,1.15 $\n"
                            "$coupled density=1e-3,side(1)=6*'open',nz=9,zback=0.,zfront=2. $\n"));
}

TEST(Overlaps, OfElasticBodies) {
  for (const char* more : {"", ",integrator='central',cfl=.5"}) {
    for (const char* element : {"q1", "q2"}) {
      if (more[0] != '\0' && element[1] == '2') continue;
      expect_told(run_text("elastic", std::string("$in nx=9,ny=9,") + frame + plane_blocks + "$mesh element='" +
                                          element + "',cells(1,1)=4,4,cells(1,2)=3,3 $\n$fem alpha=0." + more +
                                          " $\n"));
    }
  }
}

/// At the start they are the deck's to tell.
TEST(Overlaps, OfImmersedBodies) {
  const DeckRun run =
      run_text("immersed",
               "$in nx=2,ny=2,xleft=0.,xright=2.,ybot=0.,ytop=2.,tmax=.02,tstep=.01,iout(33)=1,tiout(33)=.01 $\n"
               "$reg nreg=3,nvi=3*4,densir(1)=3*1.,xvi(1,1)=0.,2.,2.,0.,yvi(1,1)=0.,0.,2.,2.,\n"
               "xvi(1,2)=.5,.9,.9,.5,yvi(1,2)=.8,.8,1.2,1.2,xvi(1,3)=.8,1.2,1.2,.8,yvi(1,3)=.9,.9,1.3,1.3,\n"
               "matr(1,1)=1.,matr(1,2)=100.,.3,matr(1,3)=100.,.3 $\n"
               "$mesh cells(1,1)=8,8,cells(1,2)=3,3,cells(1,3)=3,3 $\n$fem law(1)='fluid' $\n");
  EXPECT_GE(run.last("nodes_inside"), 2);
  EXPECT_EQ(run.summary.at("nodes_inside"), run.last("nodes_inside"));
  for (const std::string& text : run.messages) EXPECT_EQ(text.find("lies inside body"), std::string::npos) << text;
}

}  // namespace
}  // namespace tether::cases
