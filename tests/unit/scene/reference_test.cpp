// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reference.hpp"

#include <gtest/gtest.h>

#include <string>

#include "unit/scene/scene_support.hpp"

namespace tether::test {
namespace {

/// A quarter of a cylinder of gas of the radius .7 about the lower left corner, on 20 x 20 cells; `reg` sets the
/// region.
Built gas_quarter(const std::vector<std::string>& overrides = {}) {
  const std::string deck = on_unit_square(
      "\n$\n$fluid siep(1)=2. $\n$reg\nnreg=1,nvi=4\nxvi(1,1)=0.,1.,1.,0.\nyvi(1,1)=0.,0.,1.,1.\n"
      "rex=.7,rey=.7,densir=3.,ipath(4,1)=9\n$\n$reference solution='radial-gas' $\n");
  std::vector<std::string> all{"in.nx=21", "in.ny=21"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return build(deck, all);
}

const Texts no_radial_gas{
    "12:21: the solution 'radial-gas' needs a quarter of a cylinder of gas about the lower left corner, at rest and "
    "without viscosity, walls left and below that mirror, gravc = 0 and nothing else"};

TEST(RadialGasReference, OfAQuarterOfGas) {
  const Built built = gas_quarter();
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.reference, ReferenceKind::radial_gas);
  EXPECT_EQ(gas_quarter({"in.wl=4", "in.wb=4", "in.wr=1", "in.wt=1"}).errors(), Texts{});
}

TEST(RadialGasReference, NeedsWhatTheSolutionDescribes) {
  for (const char* wrong : {"in.gravc=-1.", "in.wl=0", "in.wb=1", "fluid.mu=1.", "reg.vrx(1)=1.", "reg.ipath(4,1)=8",
                            "reg.rey=.4", "reg.xcenter=.3", "reg.rix=.3"}) {
    std::vector<std::string> overrides{wrong};
    if (overrides[0] == "reg.ipath(4,1)=8") overrides.push_back("reg.matr(1,1)=10.");
    if (overrides[0] == "reg.rix=.3") overrides.push_back("reg.riy=.3");
    EXPECT_EQ(gas_quarter(overrides).errors(), no_radial_gas) << wrong;
  }
}

TEST(RadialGasReference, ASquareIsNoQuarterOfACylinder) {
  EXPECT_EQ(gas_quarter({"reg.rex=9.", "reg.rey=9.", "reg.xvi(1,1)=0.,.5,.5,0.", "reg.yvi(1,1)=0.,0.,.5,.5"}).errors(),
            no_radial_gas);
}

/// Gas in the corner, and a membrane of three points from the left to the bottom wall; `points` are its rows.
Built ring(const std::vector<std::string>& overrides = {}, const std::string& points = "",
           const std::string& groups = "") {
  const std::string rows =
      points.empty() ? ".05 .9 0. 0. 0. 0. 0.\n.6 .6 0. 0. 0. 0. 0.\n.9 .05 0. 0. 0. 0. 0.\n" : points;
  return build(on_unit_square("igen=3\n$\n$fluid siep(1)=2. $\n$reg\nnreg=1,nvi=4\nxvi(1,1)=0.,.5,.5,0.\n"
                              "yvi(1,1)=0.,0.,.5,.5\ndensir=3.,ipath(4,1)=9\n$\n$reference solution='thin-ring' $\n" +
                              groups + "0.5 ! density\n100.,.3,0.,0.,0.,0.,0.\n3,3,3,8\n3\n3,2\n" + rows),
               overrides);
}

const Texts no_thin_ring{
    "12:21: the solution 'thin-ring' needs one unstressed membrane from the left to the bottom wall, both of which "
    "mirror, gas inside, all at rest, gravc = 0, pambient = 0 and nothing else"};

TEST(ThinRingReference, OfAMembraneAroundGas) {
  const Built built = ring();
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.reference, ReferenceKind::thin_ring);
  EXPECT_EQ(ring({}, ".9 .05 0. 0. 0. 0. 0.\n.6 .6 0. 0. 0. 0. 0.\n.05 .9 0. 0. 0. 0. 0.\n").errors(), Texts{});
}

TEST(ThinRingReference, NeedsWhatTheSolutionDescribes) {
  for (const char* wrong : {"in.gravc=-1.", "in.wl=1", "in.wb=0", "reg.vry(1)=1.", "fluid.pambient=1."}) {
    EXPECT_EQ(ring({wrong}).errors(), no_thin_ring) << wrong;
  }
  EXPECT_EQ(ring({"reg.ipath(4,1)=0", "reg.matr(1,1)=10."}).errors(), no_thin_ring);  // no gas
}

TEST(ThinRingReference, NeedsAMembraneFromWallToWallAtRest) {
  const std::string middle = ".6 .6 0. 0. 0. 0. 0.\n", end = ".9 .05 0. 0. 0. 0. 0.\n";
  EXPECT_EQ(ring({}, ".35 .9 0. 0. 0. 0. 0.\n" + middle + end).errors(), no_thin_ring);
  EXPECT_EQ(ring({}, ".05 .9 0. 0. 0. 0. 0.\n" + middle + ".9 .35 0. 0. 0. 0. 0.\n").errors(), no_thin_ring);
  EXPECT_EQ(ring({}, ".05 .9 0. 1. 0. 0. 0.\n" + middle + end).errors(), no_thin_ring);
  EXPECT_EQ(ring({}, ".05 .9 0. 0. 0. 5. 0.\n" + middle + end).errors(), no_thin_ring);
}

}  // namespace
}  // namespace tether::test
