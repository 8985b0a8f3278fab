// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "cases/run_deck.hpp"

// What stands still moves by rounding, or settles under the pressure around it: no number that is watched may take that
// for a motion.

namespace tether::cases {
namespace {

using Texts = std::vector<std::string>;

constexpr const char* tank =
    "water at rest\n$in nx=2,ny=2,xleft=0.,xright=1.,ybot=0.,ytop=.7,tmax=.5,tstep=.05,gravc=-9.81,iout(33)=1,"
    "tiout(33)=.05 $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,.7,.7,densir=1000.,matr(1,1)=1. $\n"
    "$mesh cells(1,1)=7,9 $\n$fem law='fluid' $\n";

TEST(Rest, OfAFluidOnAMesh) {
  for (const char* element : {"q1q1", "q2q1"}) {
    for (const char* side : {"", ",boundary_on='1.right',boundary='open'", ",boundary_on='1.top',boundary='slip'"}) {
      const DeckRun run = run_text("tank", fmt::format("{}$flow element='{}'{} $\n", tank, element, side));
      EXPECT_EQ(run.messages, Texts{}) << element << side;
      EXPECT_LT(run.summary.at("energy_rise"), 1e-9) << element << side;
      // the depth's mean is .35; in a box the pressure is known but for a constant
      EXPECT_GT(run.last("energy_pressure"), 0.4 * 1000 * 9.81 * 0.35 * 0.7) << element << side;
    }
  }
}

/// A block as heavy as the water, or nearly, that the pressure around it squeezes.
DeckRun neutral_block(const std::string& stiffness, const std::string& density) {
  return run_text("block",
                  fmt::format("a neutral block\n$in nx=31,ny=27,xleft=0.,xright=.93,ybot=0.,ytop=.77,tmax=.2,tstep=.01,"
                              "gravc=-9.81,iout(33)=1,tiout(33)=.05 $\n"
                              "$reg nreg=1,nvi=4,densir={},xvi(1,1)=.41,.61,.56,.38,yvi(1,1)=.24,.26,.44,.42,"
                              "matr(1,1)={},.35 $\n$mesh element='p1',cells(1,1)=4,4 $\n"
                              "$coupled density=1000.,side(4)='open' $\n",
                              density, stiffness));
}

TEST(Rest, OfABlockInAFluid) {
  for (const char* stiffness : {"1e6", "1e7", "3e8"}) {
    for (const char* density : {"1000", "1001", "1010"}) {
      const DeckRun run = neutral_block(stiffness, density);
      EXPECT_EQ(run.messages, Texts{}) << stiffness << " " << density;
    }
  }
}

}  // namespace
}  // namespace tether::cases
