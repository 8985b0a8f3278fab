// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/reference/reference.hpp"

#include <gtest/gtest.h>

#include <string>

#include "unit/read/scene_support.hpp"

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
                              "yvi(1,1)=0.,0.,.5,.5\ndensir=3.,ipath(4,1)=9\n$\n$reference solution='thin-ring' $\n"
                              "$membrane strain='element' $\n" +
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

/// Two gases side by side, p = 1 and .1, that fill the unit square; $in is lines 1 to 3, $reference line 14.
Built tube(const std::vector<std::string>& overrides = {}, const std::string& reference = "solution='riemann'") {
  return build(on_unit_square("\n$\n$fluid siep(1)=2.5,siep(2)=2. $\n$reg\nnreg=2,nvi=4,4\nxvi(1,1)=0.,.5,.5,0.\n"
                              "yvi(1,1)=0.,0.,1.,1.\nxvi(1,2)=.5,1.,1.,.5\nyvi(1,2)=0.,0.,1.,1.\n"
                              "rex=9.,9.,rey=9.,9.,densir=1.,.125,ipath(4,1)=7,ipath(4,2)=7\n$\n$reference " +
                              reference + " $\n"),
               overrides);
}

/// What follows "needs " in the only error; empty without one.
std::string needed(const Built& built) {
  const Texts errors = built.errors();
  if (errors.empty()) return "";
  const auto at = errors.front().find(" needs ");
  return at == std::string::npos || errors.size() > 1 ? "other errors: " + errors.front()
                                                      : errors.front().substr(at + 7);
}

TEST(RiemannReference, OfTwoGasesThatFillTheTube) {
  EXPECT_EQ(tube().errors(), Texts{});
  EXPECT_EQ(tube().scene.reference, ReferenceKind::riemann);
  EXPECT_EQ(tube({"reg.vrx(1)=.75", "in.wr=1", "in.wl=0"}).errors(), Texts{});
  EXPECT_EQ(tube({"reg.xvi(1,1)=.5,1.,1.,.5", "reg.xvi(1,2)=0.,.5,.5,0."}).errors(), Texts{});  // the right one first
}

/// Each of these ran to its end with an error that was the solution's.
TEST(RiemannReference, NeedsWhatTheSolutionDescribes) {
  const auto said = [](const std::vector<std::string>& overrides) { return needed(tube(overrides)); };
  EXPECT_EQ(said({"in.gravc=-1."}), "gravc = 0");
  EXPECT_EQ(said({"fluid.mu=1."}), "gas without viscosity (mu = 0)");
  EXPECT_EQ(said({"reg.vry(2)=1."}), "regions that move along the tube alone (vry = 0)");
  for (const char* wall : {"in.wb=0", "in.wt=0", "in.wb=1", "in.wt=1"}) {
    EXPECT_EQ(said({wall}), "a bottom and a top wall along which gas slips (wb and wt of 4 or 6)") << wall;
  }
  EXPECT_EQ(said({"in.ytop=4."}), "regions that fill the tube from the bottom wall to the top wall");
  const std::string wanted = "regions that lie side by side in x, one left of the other: here both are from x = ";
  EXPECT_EQ(said({"in.nx=2", "reg.xvi(1,1)=0.,1.,1.,0.", "reg.yvi(1,1)=0.,0.,.5,.5", "reg.xvi(1,2)=0.,1.,1.,0.",
                  "reg.yvi(1,2)=.5,.5,1.,1."}),
            wanted + "0 to 1");
  EXPECT_EQ(said({"in.nx=41", "reg.xvi(1,2)=.25,1.,1.,.25"}), wanted + "0.25 to 0.5");
  EXPECT_EQ(said({"in.nx=41", "reg.xvi(1,2)=.6,1.,1.,.6"}), "regions that meet: here they are a cell or more apart");
}

TEST(RiemannWindow, IsAPartOfTheTube) {
  const Built built = tube({}, "solution='riemann',window=.2,.8");
  EXPECT_EQ(built.errors(), Texts{});
  ASSERT_TRUE(built.scene.reference_window);
  EXPECT_EQ(built.scene.reference_window->front(), 0.2);
  EXPECT_EQ(built.scene.reference_window->back(), 0.8);
  EXPECT_FALSE(tube().scene.reference_window);
  const Texts none{"14:38: the window from 0.8 to 0.2 is no part of the tube"};
  EXPECT_EQ(tube({}, "solution='riemann',window=.8,.2").errors(), none);
  EXPECT_EQ(tube({}, "solution='riemann',window=.8,1.2").errors().size(), 1u);
  EXPECT_EQ(tube({}, "solution='riemann',window=.8").errors(),
            Texts{"14:38: window has two numbers, where it begins and where it ends"});
}

/// Five points .1 apart below the top wall, the last of which is a mass of 3.3; the unit square has cells of .1.
Built string(const std::string& solution, const std::vector<std::string>& overrides = {}, const std::string& rows = "",
             const std::string& groups = "") {
  const std::string hanging =
      ".5 .95 0. 0. 0. 0. 0.\n.5 .85 0. 0. 0. 0. 0.\n.5 .75 0. 0. 0. 0. 0.\n.5 .65 0. 0. 0. 0. 0.\n"
      ".5 .55 0. 0. 0. 0. 0.\n";
  std::vector<std::string> all{"in.nx=11", "in.ny=11", "in.gravc=-1."};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return build(on_unit_square("igen=0\n$\n$points heavy(5)=3.3,tracked(5)=.true. $\n$reference solution='" + solution +
                              "' $\n" + groups + "0.5 ! density\n1.e4,.3,0.,0.,0.,0.,0.\n3,3,3,8\n5\n5,2\n" +
                              (rows.empty() ? hanging : rows)),
               all);
}

/// From (.3, .95), .1 apart along 3:4, to (.54, .63).
const std::string slanted =
    ".3 .95 0. 0. 0. 0. 0.\n.36 .87 0. 0. 0. 0. 0.\n.42 .79 0. 0. 0. 0. 0.\n.48 .71 0. 0. 0. 0. 0.\n"
    ".54 .63 0. 0. 0. 0. 0.\n";

TEST(StringReferences, OfAStringThatIsHeld) {
  EXPECT_EQ(string("spring").errors(), Texts{});
  EXPECT_EQ(string("string").errors(), Texts{});
  EXPECT_EQ(string("pendulum", {"in.xleft=-.5", "in.nx=16", "in.wt=0"}, slanted).errors(), Texts{});
  EXPECT_EQ(string("pendulum", {"in.xleft=-.5", "in.nx=16", "points.pinned(1)=.true."}, slanted).errors(), Texts{});
}

TEST(StringReferences, NeedAStringThatIsHeld) {
  const std::string held =
      "a string that is held: its first point pinned, or in the row of cells beside a wall that holds it, straight on";
  EXPECT_EQ(needed(string("spring", {"in.wt=1"})), held);
  EXPECT_EQ(needed(string("spring", {"in.ytop=1.2"})), held);  // two cells away
  EXPECT_EQ(needed(string("spring", {"in.ytop=1.1", "in.ny=6"})),
            "points up to what holds the string: its first one is more than a spacing from the wall, and nothing is in "
            "between");
  EXPECT_EQ(needed(string("pendulum", {"in.wt=6"}, slanted)),
            "a string whose end is fixed: here it slides along its wall");
}

TEST(StringReferences, NeedAStringAlone) {
  const std::string straight = "a string whose points stand evenly on a straight line";
  const std::string uniform = "points of one volume and mass, but for the string's last one, the mass";
  EXPECT_EQ(needed(string("spring", {"points.heavy(3)=1."})), uniform);
  EXPECT_EQ(needed(string("spring", {},
                          ".5 .95 0. 0. 0. 0. 0.\n.51 .85 0. 0. 0. 0. 0.\n.5 .75 0. 0. 0. 0. 0.\n"
                          ".5 .65 0. 0. 0. 0. 0.\n.5 .55 0. 0. 0. 0. 0.\n")),
            straight);
  const std::string gas =
      "$fluid siep(1)=2. $\n$reg nreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,.2,.2,densir=1.,ipath(4,1)=7 $\n";
  EXPECT_EQ(needed(string("spring", {"in.igen=3"}, "", gas)), "a string alone: no other body");
  EXPECT_EQ(needed(string("spring", {"in.gravc=0."})),
            "a string from a particle file that begins at rest, its last point tracked, and gravc < 0");
}

TEST(StringReferences, NeedRoom) {
  const std::string fall =
      "room: the grid down to the lowest place, without walls that hold the string at its sides or the mass below";
  EXPECT_EQ(needed(string("spring", {"in.gravc=-150."})), fall);  // E A/L = 2000, it falls by half a metre
  EXPECT_EQ(needed(string("spring", {"in.nx=2", "in.wl=0"})), fall);
  EXPECT_EQ(needed(string("pendulum", {"points.pinned(1)=.true."}, slanted)),
            "room: the whole swing inside the grid, a cell away from walls that are not open");
}

TEST(StringReferences, NeedTheStateThatTheyBeginWith) {
  std::string stressed =
      ".5 .95 0. 0. 0. -1. 0.\n.5 .85 0. 0. 0. -1. 0.\n.5 .75 0. 0. 0. -1. 0.\n"
      ".5 .65 0. 0. 0. -1. 0.\n.5 .55 0. 0. 0. -1. 0.\n";
  EXPECT_EQ(needed(string("spring", {}, stressed)), "a spring without stress at the start");
  EXPECT_EQ(string("string", {}, stressed).errors(), Texts{});
  EXPECT_EQ(needed(string("string", {"membrane.wrinkle=.false."}, stressed)),
            "a string that carries no compression (wrinkle=.true.)");
  EXPECT_EQ(needed(string("spring", {"in.wt=0"}, slanted)), "a string that hangs straight down from where it is held");
}

}  // namespace
}  // namespace tether::test
