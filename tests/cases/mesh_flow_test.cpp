// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// Runs of a fluid on triangles and tetrahedra, against those on a grid.

namespace tether::cases {
namespace {

/// Smoke is neither made nor lost, also where a body goes through it, and no cell has more than comes in; what jets
/// bring is the deck's.
TEST(MeshFlowRuns, KeepSmoke) {
  const DeckRun run = run_deck("coupled-bar", {"coupled.flow='mesh'", "in.tmax=.5"});
  EXPECT_NEAR(run.last("smoke_in"), 0.125, 1e-12);
  EXPECT_NEAR(run.last("smoke_in"), run.last("smoke_mass") + run.last("smoke_out"), 1e-13);
  EXPECT_LT(run.last("smoke_largest"), 1 + 1e-9);
  EXPECT_LT(run.summary.at("interface_mismatch"), 1e-10);
}

/// Boxes of smoke have what the deck says, also where their edges go through cells.
TEST(MeshFlowRuns, BeginWithTheDecksSmoke) {
  const DeckRun run =
      run_text("smoke",
               "smoke\n$in nx=17,ny=17,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.02,tstep=.01,iout(33)=1,"
               "tiout(33)=.01 $\n$coupled density=1.,flow='mesh',size=.09,smoke_box(1,1)=.31,.53,.22,.41,"
               "box_smoke(1)=2. $\n");
  EXPECT_NEAR(run.first("smoke_mass"), 2 * 0.22 * 0.19, 1e-13);
  EXPECT_NEAR(run.last("smoke_mass"), 2 * 0.22 * 0.19, 1e-13);
}

/// Where TetGen fails, which spoils the memory of its process, a surface moved back farther leads on.
TEST(MeshFlowRuns, GoOnWhereTetGenFails) {
  const DeckRun run = run_deck("coupled-sheets-3d", {"coupled.flow='mesh'", "coupled.size=.25", "in.tmax=.06"});
  EXPECT_GT(run.summary.at("mesh_cells"), 1000);
  EXPECT_LT(run.summary.at("energy_drift"), 1e-9);
}

/// A jet from the right is the mirror image of one from the left.
TEST(MeshFlowRuns, JetsBlowAlikeFromBothEnds) {
  const auto jet_from = [](const std::string& side, const std::string& open) {
    return run_text("jet",
                    "a jet\n$in nx=33,ny=17,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.5,tstep=.05,iout(33)=1,"
                    "tiout(33)=.05 $\n$coupled density=1.,flow='mesh'," +
                        open + "='open',jet_on(1)='" + side + "',jet(1:2,1)=.3,.7,jet_speed(1)=1. $\n");
  };
  const DeckRun right = jet_from("right", "side(1)"), left = jet_from("left", "side(2)");
  for (const char* energy : {"energy_fluid", "energy_jets", "energy_open", "energy_advected"})
    EXPECT_NEAR(right.last(energy), left.last(energy), 1e-10) << energy;
  EXPECT_NEAR(right.last("momentum_x"), -left.last("momentum_x"), 1e-10);
}

/// A block on a spring in a channel swings at 1 Hz, and loses little.
TEST(MeshFlowRuns, APistonSwings) {
  const DeckRun run = run_deck("coupled-piston", {"coupled.flow='mesh'", "coupled.size=.0625", "in.tmax=3."});
  const auto t = run.history.column("time"), x = run.history.column("body_x_1");
  std::vector<double> passed;
  const double middle = 0.5 * (*std::ranges::max_element(x) + *std::ranges::min_element(x));
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    if (x[k] < middle && x[k + 1] >= middle)
      passed.push_back(t[k] + (middle - x[k]) / (x[k + 1] - x[k]) * (t[k + 1] - t[k]));
  }
  ASSERT_GE(passed.size(), 3U);
  EXPECT_NEAR((passed.back() - passed.front()) / static_cast<double>(passed.size() - 1), 1, 0.01);
  EXPECT_GT(*std::max_element(x.end() - 100, x.end()) - middle,
            0.99 * (x.front() < middle ? middle - x.front() : *std::max_element(x.begin(), x.begin() + 100) - middle));
  EXPECT_LT(run.summary.at("energy_drift"), 1e-9);
}

/// A balloon full of water on the floor is as high as by a grid of 193 x 193, whose unknowns are 18 times as many.
TEST(MeshFlowRuns, ABalloonFalls) {
  const DeckRun run = run_deck("coupled-balloon",
                               {"coupled.flow='mesh'", "coupled.size=.03", "in.tmax=.8", "in.tstep=.00416666666667"});
  EXPECT_NEAR(run.last("body_y_1"), 0.5717, 0.01 * (0.9 - 0.5));
  EXPECT_LT(run.summary.at("unknowns"), 2500);
  EXPECT_LT(run.summary.at("interface_mismatch"), 1e-10);
}

/// A block on a spring swings near walls, and another falls to the floor: carrying velocities along makes no energy.
TEST(MeshFlowRuns, NearWallsNoEnergyIsMade) {
  for (const char* gap : {"0.02", "0.06", "0.11"}) {
    const DeckRun run = run_text(
        "spring",
        "spring\n$in nx=25,ny=25,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.3,tstep=.01,iout(33)=1,tiout(33)=.01 $\n"
        "$reg nreg=1,nvi(1)=4,densir(1)=3000.,xvi(1,1)=.35,.65,.65,.35,yvi(1,1)=2*" +
            std::string(gap) +
            ",.2,.2,matr(1,1)=1e6,.3,vry(1)=.2 $\n$mesh cells(1,1)=3,2 $\n"
            "$coupled density=1000.,flow='mesh',spring_on(1)='region 1',spring(1:2,1)=1e4,1e4 $\n");
    const auto kinetic = run.history.column("energy_kinetic");
    EXPECT_LE(*std::ranges::max_element(kinetic), 1.001 * kinetic.front()) << gap;
    EXPECT_GT(run.last("energy_advected"), -0.01 * kinetic.front()) << gap;
  }
  const DeckRun run =
      run_text("fall",
               "fall\n$in nx=25,ny=25,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=1.,tstep=.01,gravc=-10.,iout(33)=1,"
               "tiout(33)=.01 $\n$reg nreg=1,nvi(1)=4,densir(1)=3000.,xvi(1,1)=.35,.65,.65,.35,yvi(1,1)=.4,.4,.55,.55,"
               "matr(1,1)=1e6,.3 $\n$mesh cells(1,1)=3,2 $\n$coupled density=1000.,flow='mesh' $\n");
  EXPECT_LT(run.summary.at("energy_rise"), 0.01);
}

/// Power is the same on both sides in space, too, and energy is accounted for: by linear solids and by steps that keep
/// their energy.
TEST(MeshFlowRuns, InSpaceEnergyIsAccountedFor) {
  std::vector<const char*> decks{"mesh-bar-3d", "coupled-paddle-3d"};
  if (at_full_length()) decks.push_back("coupled-toy-3d");
  for (const char* deck : decks) {
    const DeckRun run = run_deck(deck, {"coupled.flow='mesh'", "coupled.size=.2", "in.tmax=.2"});
    EXPECT_LT(run.summary.at("interface_mismatch"), 1e-10) << deck;
    EXPECT_LT(run.summary.at("energy_drift"), 1e-9) << deck;
  }
}

/// Heavy bodies that sink through each other without $contact. Where a side crosses itself the fluid around is still
/// there, and the run goes on.
TEST(MeshFlowRuns, BodiesThatCrossKeepTheFluidAround) {
  const std::string text =
      "bodies that cross\n$in nx=17, ny=17, xleft=0., xright=2., ybot=0., ytop=1., tmax=1., tstep=.02, gravc=-10. $\n"
      "$reg nreg=3, nvi=3*4,\n"
      "xvi(1,1)=1.50656786,1.5212592,1.27961335,1.264922, yvi(1,1)=.364311198,.42581738,.483536821,.42203064,\n"
      "xvi(1,2)=1.19555858,1.1354345,.85571169,.915835764, yvi(1,2)=.64984376,.844092715,.757512713,.563263758,\n"
      "xvi(1,3)=1.3075085,1.34530288,1.28641555,1.24862117, yvi(1,3)=.7487717,.875286354,.892878072,.766363418,\n"
      "densir(1)=8620.,3039.,8213., matr(1,1)=3.315e5,.3, matr(1,2)=7.85e5,.3, matr(1,3)=2.268e5,.3,\n"
      "vrx(1)=-.0686,.0135, vry(1)=-.0276,-.0883 $\n"
      "$fem law=3*'neo-hookean' $\n"
      "$mesh cells(1,1)=3,1, cells(1,2)=2,1, cells(1,3)=1,1 $\n"
      "$coupled density=1000., flow='mesh', size=.16, side(4)='open' $\n";
  const DeckRun run = run_text("crossed", text);
  EXPECT_GT(run.summary.at("nodes_inside"), 0);
  EXPECT_GT(run.summary.at("mesh_cells"), 60);
}

}  // namespace
}  // namespace tether::cases
