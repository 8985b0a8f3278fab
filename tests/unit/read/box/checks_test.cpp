// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a deck of $coupled, or has no effect there. The decks of tests/bad_decks have one mistake each;
// here is where a mistake begins.
#include "read/box/checks.hpp"

#include <gtest/gtest.h>

#include "deck/document.hpp"
#include "unit/read/box/coupled_support.hpp"

namespace tether::test {
namespace {

const std::string in = "jet_on(1)='left',jet_speed(1)=1.,";

/// The message of the one error there is.
std::string error_of(const Built& built) {
  const Texts errors = built.errors();
  return errors.size() == 1 ? errors[0] : std::to_string(errors.size()) + " errors";
}

TEST(CoupledRegions, AreClosedWithoutAnOpenSideOrVoid) {
  EXPECT_EQ(error_of(box(in)), "5:11: the region about (0.125, 0.125) is closed, and at t = 0 jets bring 1 into it");
  EXPECT_EQ(box(in + "side(2)='open'").errors(), Texts{});
  EXPECT_EQ(box(in + "void(1,1)=1.5,2.,.5,1.").errors(), Texts{});
  EXPECT_EQ(box(in + "side(1)='open',jet(1,1)=0.,.75").errors(), Texts{});  // beside the jet it is open
  EXPECT_EQ(box(in + "side(1)='open'").errors().size(), 1u);
  EXPECT_EQ(box("").errors(), Texts{});
}

TEST(CoupledRegions, TakeWhatGoesInAndOutAlike) {
  const std::string out = "jet_on(2)='top',jet(1,2)=1.,1.5,jet_speed(2)=";
  EXPECT_EQ(box(in + out + "-2.").errors(), Texts{});
  EXPECT_NE(error_of(box(in + out + "-1.5")).find("at t = 0 jets bring 0.25 into it"), std::string::npos);
  EXPECT_NE(error_of(box(in + out + "-2.5")).find("at t = 0 jets bring -0.25 into it"), std::string::npos);
  EXPECT_EQ(box(in + out + "-2.,jet_expression='t','t'").errors(), Texts{});
  EXPECT_NE(error_of(box(in + out + "-2.,jet_expression(1)='1+(t>1.85)'")).find("at t = 1.9 "), std::string::npos);
}

/// A time of a table between those that are looked at anyway, 0, .1, ... 2.
TEST(CoupledRegions, AreLookedAtWhenTablesTurn) {
  const std::string pulse = "jet_time(1,1)=1.01,1.05,1.09,jet_factor(1,1)=0.,1.,0.";
  EXPECT_NE(error_of(box(in + pulse)).find("at t = 1.05 jets bring 1 into it"), std::string::npos);
}

TEST(CoupledRegions, AreDividedByObstacles) {
  const std::string wall = "side(2)='open',obstacle(1,1)=1.,1.25,0.,", low = "jet(1,1)=0.,.5,";
  EXPECT_EQ(box(in + low + wall + ".75").errors(), Texts{});
  EXPECT_NE(error_of(box(in + low + wall + "1.")).find("jets bring 0.5 into it"), std::string::npos);
  // a jet in each part: the open one is not to blame
  EXPECT_NE(
      error_of(box("jet_on(1)='top',jet(1,1)=1.5,2.,jet_speed(1)=1.,jet_on(2)='left',jet_speed(2)=-1.," + wall + "1."))
          .find("jets bring -1 into it"),
      std::string::npos);
}

TEST(CoupledRegions, OfSpaceHaveAPlaceInSpace) {
  EXPECT_NE(error_of(box(depth + in + "jet(1,1)=0.,.5,0.,.5"))
                .find("about (0.125, 0.125, 0.125) is closed, and at t "
                      "= 0 jets bring 0.25 into it"),
            std::string::npos);
  EXPECT_EQ(box(depth + in + "side(6)='open'").errors(), Texts{});
}

TEST(CoupledRegions, AnExpressionWithoutAValueIsLeftToTheRun) {
  EXPECT_EQ(box(in + "side(2)='open',jet_expression(1)='1/t'").errors(), Texts{});
  EXPECT_NE(error_of(box(in + "jet_expression(1)='1/t'")).find("at t = 0.1 "), std::string::npos);
}

TEST(CoupledPlaces, NodesMayStandAtWallsAndObstacles) {
  const auto body = [](const std::string& x, const std::string& y) {
    return "$reg nreg=1,nvi=4,xvi(1,1)=" + x + ",yvi(1,1)=" + y +
           ",densir=5.,matr(1,1)=100.,.3 $\n$mesh element='p1' $\n";
  };
  EXPECT_EQ(box("", body("0.,2.,2.,0.", "0.,0.,.5,.5")).errors(), Texts{});
  EXPECT_EQ(box("", body("0.,2.,2.,0.", "-1e-12,-1e-12,.5,.5")).errors(), Texts{});
  EXPECT_EQ(error_of(box("", body("0.,2.,2.,0.", "-1e-6,-1e-6,.5,.5"))),
            "7:28: region 1: its node 1 at (0, -1e-06) lies outside the box");
  const std::string obstacle = "obstacle(1,1)=1.,2.,0.,.5";
  EXPECT_EQ(box(obstacle, body("0.,1.,1.,0.", "0.,0.,.5,.5")).errors(), Texts{});
  EXPECT_EQ(box(obstacle, body("1.,2.,2.,1.", ".5,.5,1.,1.")).errors(), Texts{});
  EXPECT_NE(
      error_of(box(obstacle, body("0.,1.01,1.01,0.", ".1,.1,.75,.75"))).find("at (1.01, 0.1) lies in an obstacle"),
      std::string::npos);
}

TEST(CoupledPlaces, JetsMeetBodiesThatStandAtTheirSide) {
  for (const std::string element : {"p1", "q1", "p2", "q2"}) {
    SCOPED_TRACE(element);
    const auto body = [&](const std::string& x) {
      return "$reg nreg=1,nvi=4,xvi(1,1)=" + x +
             ",yvi(1,1)=.5,.5,1.,1.,densir=5.,matr(1,1)=100.,.3 $\n$mesh "
             "element='" +
             element + "',cells(1,1)=1,3 $\n";
    };
    const std::string open = in + "side(2)='open',jet(1,1)=";
    EXPECT_EQ(box(open + "0.,.5", body("0.,.5,.5,0.")).errors(), Texts{});
    EXPECT_NE(
        error_of(box(open + "0.,.75", body("0.,.5,.5,0."))).find("jet 1 comes in through a body: through element"),
        std::string::npos);
    // thinner than half a cell, at the side itself
    EXPECT_NE(error_of(box(open + "0.,.75", body("0.,.01,.01,0."))).find("through a body"), std::string::npos);
    // over the middles of the cells at the side, not at the side itself
    EXPECT_NE(error_of(box(open + "0.,.75", body(".05,.5,.5,.05"))).find("through a body"), std::string::npos);
    // beyond the cells at the side
    EXPECT_EQ(box(open + "0.,.75", body(".25,.5,.5,.25")).errors(), Texts{});
  }
}

TEST(CoupledPlaces, JetsMeetBodiesInSpace) {
  const std::string jet = "side(2)='open',jet_on='back',jet_speed=1.,";
  EXPECT_EQ(box(depth + jet, cube_body()).errors(), Texts{});
  const std::string thick = "nz=5,zback=.25,zfront=1.,";
  EXPECT_NE(error_of(box(thick + jet, cube_body())).find("jet 1 comes in through a body"), std::string::npos);
  EXPECT_EQ(box(thick + jet + "jet(1,1)=1.,2.,0.,1.", cube_body()).errors(), Texts{});
}

/// The error of a deck of a box with a mesh file of one triangle.
std::string error_with_file(const std::string& coupled) {
  Diagnostics diagnostics;
  const Deck deck =
      read_deck("$in\nnx=9,ny=5,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=2.,tstep=.01\n$\n$coupled density=2.," +
                    coupled + "$\n$reg nreg=1,densir=5.,matr(1,1)=100.,.3 $\n$mesh file='a.msh' $\n",
                "a.in", {}, diagnostics)
          .with_mesh_text(
              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 1 .5 0\n2 1.5 .5 0\n3 1 .75 0\n"
              "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
  const Scene scene = build_scene(deck, std::nullopt, Path::coupled, diagnostics);
  return diagnostics.has_errors() ? diagnostics.errors()[0].message : "";
}

TEST(CoupledChecks, TakeMeshFilesOfAsManyDimensions) {
  EXPECT_EQ(error_with_file(""), "");
  EXPECT_EQ(error_with_file(depth), "the mesh is of 2 dimensions, but the box of 3");
}

/// Both have a pressure of zero somewhere: where, gravity makes the deck say.
TEST(CoupledChecks, VoidsBesideOpenSidesWantALevel) {
  const std::string both = "side(1)='open',void(1,1)=1.,2.,.5,1.,";
  EXPECT_EQ(warnings_of(box(both, "", "gravc=-9.81")),
            Texts{"fluid beyond the open sides has a pressure of zero at ytop = 1, voids have it everywhere"});
  EXPECT_EQ(warnings_of(box(both + "level=.5", "", "gravc=-9.81")), Texts{});
  EXPECT_EQ(warnings_of(box(both)), Texts{});
}

TEST(CoupledChecks, TellOfWhatHasNoEffect) {
  EXPECT_EQ(warnings_of(
                box("area_repair=.false.,smoke_lift=1.,solver='direct',tolerance=1e-6", square_body("cfl=.5"), "wl=0")),
            (Texts{"wl of $in has no effect", "cfl of $fem has no effect", "area_repair of $coupled has no effect",
                   "tolerance of $coupled has no effect", "smoke_lift of $coupled has no effect"}));
  EXPECT_EQ(warnings_of(box("level=.5")), Texts{"level of $coupled has no effect"});
  EXPECT_EQ(warnings_of(box("side(1)='open',level=.5")), Texts{});
  EXPECT_EQ(warnings_of(box("", square_body("integrator='midpoint',tolerance=1e-5"))),
            (Texts{"integrator of $fem has no effect", "tolerance of $fem has no effect"}));
  EXPECT_EQ(warnings_of(box("", square_body("integrator='energy',cfl=.9"), "wl=6")), Texts{});
}

TEST(CoupledChecks, TellOfBodiesThatThereAreNot) {
  EXPECT_EQ(
      warnings_of(box("friction=.1",
                      "$reg nreg=1,nvi=4 $\n$fem law(1)='linear' $\n$points tracked_at(1,1)=1.,1. "
                      "$\n$mpm method='robust' $\n")),
      (Texts{"friction of $coupled has no effect", "method of $mpm has no effect beside $coupled",
             "nreg of $reg has no effect: there is no body", "nvi of $reg has no effect: there is no body",
             "tracked_at of $points has no effect: there is no body", "law of $fem has no effect: there is no body"}));
}

TEST(CoupledChecks, TellOfOutputsOfPoints) {
  EXPECT_EQ(warnings_of(box("", "", "iout(13)=1,tiout(13)=1.,iout(39)=1,tiout(39)=1.")),
            (Texts{"iout(13)=1 writes nothing: fluid and elements have no points"}));
}

/// deck.effective shows defaults, too, and must read back in silence.
TEST(CoupledChecks, SayNothingOfTheEffectiveDeck) {
  Diagnostics diagnostics;
  const std::string text =
      "$in\nnx=9,ny=5,xleft=0.,xright=2.,ybot=0.,ytop=1.,tmax=2.,tstep=.01\n$\n$coupled "
      "density=2.,side(2)='open'," +
      in + "hinge(1,1)=.5,.25 $\n" + square_body("beta=.1");
  const Deck deck = read_deck(text, "a.in", {}, diagnostics);
  const std::string effective = effective_deck(deck);
  EXPECT_NE(effective.find("area_repair = .true."), std::string::npos);
  const Deck again = read_deck(effective, "b.in", {}, diagnostics);
  const Scene scene = build_scene(again, std::nullopt, Path::coupled, diagnostics);
  ASSERT_NE(scene.coupled(), nullptr);
  EXPECT_EQ(scene.coupled()->jets.size(), 1u);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.all()[0].message;
}

TEST(CoupledChecks, TellAllMistakesAtOnce) {
  const Built built = box("jet_on='left',jet(1,1)=.5,2.,obstacle(1,1)=1.,.5,0.,1.,w0=1.,friction=1.,contact=.false.");
  EXPECT_EQ(built.errors().size(), 5u);
}

/// Cells of .25 whose middles lie in a box: from .25 to 1.25 where it goes from .3 to 1.2.
TEST(CoupledBoxes, ThatAreNotAtFacesAreToldWithTheSizeOfTheirCells) {
  for (const std::string kind : {"obstacle", "void"}) {
    const auto told = [&](const std::string& places, const std::string& more) {
      return warnings_of(box("side(2)='open'," + more + kind + "(1,1)=" + places));
    };
    const std::string start = "for the fluid " + kind + " 1 is made of the cells from ";
    EXPECT_EQ(told(".3,1.2,.1,.6", ""), Texts{start + "0.25 to 1.25 in x, 0 to 0.5 in y: 0.5 in place of 0.45, +11 %"});
    EXPECT_EQ(told(".3,1.1,.1,.6", ""), Texts{start + "0.25 to 1 in x, 0 to 0.5 in y: 0.375 in place of 0.4, -6.2 %"});
    EXPECT_EQ(told(".3,1.2,.1,.6,.2,.7", depth),
              Texts{start + "0.25 to 1.25 in x, 0 to 0.5 in y, 0.25 to 0.75 in z: 0.25 in place of 0.225, +11 %"});
    EXPECT_EQ(told(".25,1.25,0.,.5", ""), Texts{});
    EXPECT_EQ(told(".25,1.25,0.,.5,.25,.75", depth), Texts{});
  }
}

}  // namespace
}  // namespace tether::test
