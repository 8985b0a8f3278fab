// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/run_deck.hpp"

// What goes into a box and out of it through parts of its sides, whatever the grid; and how far in a step.

namespace tether::cases {
namespace {

std::string channel(int nx, int ny, const std::string& coupled, const std::string& step = ".01") {
  return "$in nx=" + std::to_string(nx) + ",ny=" + std::to_string(ny) +
         ",xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=.1,tstep=" + step +
         ",iout(33)=1,tiout(33)=.05,iout(39)=1,tiout(39)=.1 $\n$coupled density=1.," + coupled + " $\n";
}

/// .2 of a side, by 1.9 in .1 s: .038 of smoke, on grids whose faces the jet's ends do and do not meet.
TEST(Boxes, JetsBringWhatTheDeckSays) {
  for (const int cells : {5, 16, 48, 51}) {
    for (const char* mode : {"symmetric", "cut-cell"}) {
      const DeckRun run = run_text(
          "jet", channel(2 * cells + 1, cells + 1,
                         "side(2)='open',jet_on(1)='left',jet(1,1)=.2,.4,jet_speed(1)=1.9,jet_smoke(1)=1.,mode='" +
                             std::string(mode) + "'"));
      EXPECT_NEAR(run.last("smoke_in"), 0.038, 1e-14) << cells << mode;
      EXPECT_NEAR(run.last("smoke_in"), run.last("smoke_mass") + run.last("smoke_out"), 1e-14) << cells << mode;
    }
  }
}

/// Two jets that share a face, one of clean fluid, and one that is narrower than a face and takes some out.
TEST(Boxes, JetsShareFaces) {
  const DeckRun run =
      run_text("shared", channel(17, 9,
                                 "side(2)='open',jet_on(1)=3*'left',jet(1,1)=.1,.3,jet(1,2)=.3,.55,jet(1,3)=.9,.92,"
                                 "jet_speed(1)=1.,2.,-1.,jet_smoke(1)=1.,0.,1."));
  EXPECT_NEAR(run.last("smoke_in"), 0.02, 1e-15);
}

/// All that comes in goes out by the opening, which ends within faces: as much as through the same part of an open side
/// whose rest obstacles close; and closed up it leaves nothing to go.
TEST(Boxes, OpeningsLetOut) {
  for (const char* mode : {"symmetric", "cut-cell"}) {
    const std::string jet = std::string("mode='") + mode + "',jet_on(1)='left',jet_speed(1)=.5,";
    const DeckRun run = run_text("opening", channel(33, 17, jet + "open_on(1)='right',open(1,1)=.33,.71"));
    const auto vx = read_variable(run.folder + "/mesh.nc", "vx");
    const double* last = &vx[vx.size() - 32 * 16];
    double inner = 0;  // through the column of cells in the middle
    for (int j = 0; j < 16; ++j) inner += last[j * 32 + 15] / 16;
    EXPECT_NEAR(inner, 0.5, 1e-10) << mode;
    EXPECT_GT(last[8 * 32 + 31], 0.7) << mode;
    EXPECT_LT(std::abs(last[1 * 32 + 31]), 0.2) << mode;
  }
}

/// Whether an opening ends at a face or next to it makes next to no difference, half a face does.
TEST(Boxes, OpeningsGoByPartsOfFaces) {
  const auto kinetic = [](const std::string& extent) {
    return run_text("parts", channel(33, 17, "jet_on(1)='left',jet_speed(1)=.5,open_on(1)='right',open(1,1)=" + extent))
        .last("energy_kinetic");
  };
  const double aligned = kinetic(".25,.75"), wider = kinetic(".2499,.7501"), half = kinetic(".28125,.71875");
  EXPECT_LT(std::abs(wider / aligned - 1), 5e-3);
  EXPECT_GT(half / aligned, 1.01);
}

/// The key and the warning use the velocities of the run, the plan's by those of the deck.
TEST(Boxes, FarStepsAreTold) {
  const std::string deck = "side(2)='open',jet_on(1)='left',jet_speed(1)=1.5";
  const DeckRun shorter = run_text("short", channel(33, 17, deck, ".02"));
  EXPECT_NEAR(shorter.summary.at("cfl_largest"), 0.48, 1e-9);
  EXPECT_TRUE(shorter.messages.empty());
  EXPECT_TRUE(shorter.warnings.empty());
  const DeckRun longer = run_text("long", channel(33, 17, deck, ".2"), {"in.tmax=.6"});
  EXPECT_NEAR(longer.summary.at("cfl_largest"), 4.8, 1e-9);
  const auto tells = [](const std::string& text) { return text.find("cfl of $limits") != std::string::npos; };
  EXPECT_EQ(std::count_if(longer.messages.begin(), longer.messages.end(), tells), 1);
  EXPECT_EQ(std::count_if(longer.warnings.begin(), longer.warnings.end(), tells), 1);
  const DeckRun off = run_text("off", channel(33, 17, deck, ".2"), {"in.tmax=.6", "limits.cfl=0.,0."});
  EXPECT_EQ(std::count_if(off.messages.begin(), off.messages.end(), tells), 0);
  EXPECT_EQ(std::count_if(off.warnings.begin(), off.warnings.end(), tells), 0);
}

}  // namespace
}  // namespace tether::cases
