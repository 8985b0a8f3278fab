// SPDX-License-Identifier: GPL-3.0-or-later
// What a deck asks for and finite elements cannot represent is told at its place, all at once.
#include <gtest/gtest.h>

#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

Built build_fem(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Built built;
  const Deck deck = read_deck(text, "a.in", overrides, built.diagnostics);
  const auto particles = load_particles(deck, std::nullopt, built.diagnostics);
  built.scene = build_scene(deck, particles, Path::fem, built.diagnostics);
  return built;
}

TEST(FemScene, OfAStringIsFree) {
  const Built built = build_fem(string_deck());
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(warnings_of(built), Texts{});
  EXPECT_EQ(built.scene.path(), Path::fem);
  EXPECT_EQ(built.scene.clock.cfl, 0.9);
}

TEST(FemScene, TakesItsOwnFactorOfTheStep) {
  EXPECT_EQ(build_fem(string_deck("$fem cfl=.25 $\n")).scene.clock.cfl, 0.25);
  const Built built = build_fem(string_deck("$mpm cfl=.25 $\n"));
  EXPECT_EQ(built.scene.clock.cfl, 0.9);
  EXPECT_EQ(warnings_of(built), Texts{"cfl of $mpm has no effect on the fem path"});
}

TEST(FemScene, APinHoldsABarsNode) {
  const Built built = build_fem(string_deck("$points pinned(2)=.true. $\n"));
  EXPECT_EQ(warnings_of(built), Texts{});
  EXPECT_EQ(built.scene.pinned, std::vector<std::size_t>{1});
}

TEST(FemScene, DefaultsOfTheOtherMethodAreNotTold) {
  EXPECT_EQ(warnings_of(build_fem(string_deck("$mpm method='thesis',criterion=1,jaumann=.false. $\n"))), Texts{});
}

TEST(FemScene, BodiesOfPointsAreRefused) {
  const Texts solid{"9:22: region 1: the fem path cannot represent a solid of points without a mesh"};
  EXPECT_EQ(build_fem(square_region()).errors(), solid);
  const auto region = [](const char* law) {
    return build_fem(square_region("", "ipath(4,1)=" + std::string(law) + "")).errors();
  };
  EXPECT_EQ(region("2"), Texts{"10:12: region 1: the fem path cannot represent a solid of points without a mesh"});
  const Texts gas{"10:12: region 1: a gas needs siep(1), its initial specific internal energy",
                  "10:12: region 1: the fem path cannot represent a gas"};
  EXPECT_EQ(region("7"), gas);
  EXPECT_EQ(region("9"), gas);
  EXPECT_EQ(region("8"), Texts{"10:12: region 1: the fem path cannot represent a linear fluid"});
}

TEST(FemScene, ASolidOfTheParticleFileIsRefused) {
  std::string deck = string_deck();
  deck.replace(deck.find("3,3,3,8"), 7, "3,3,3,0");
  EXPECT_EQ(build_fem(deck).errors(), Texts{"7:1: the fem path cannot represent a solid of points without a mesh"});
}

TEST(FemScene, AllIsToldAtOnce) {
  const Built built =
      build_fem(string_deck("$membrane law='plane-stress' $\n$fluid pambient=3. $\n", "igen=0,cyl=1.,wl=4"));
  EXPECT_EQ(built.errors(), (Texts{"3:12: the fem path is plane: it has no axis",
                                   "6:17: the fem path has no pressure outside membranes",
                                   "5:15: the fem path cannot represent plane stress: law(1)"}));
}

TEST(FemScene, PlaneStressOfAMembraneOfCurvesIsRefused) {
  const char* groups =
      "$membrane curve(3)='line',x(1,3)=.1,.9,y(1,3)=.5,.5,body(3)=2,\nlaw(2)='plane-stress',count(2)=5,"
      "thickness(2)=.1,density(2)=1.,young(2)=1. $\n";
  EXPECT_EQ(build_fem(on_unit_square(std::string("igen=3 $\n") + groups)).errors(),
            Texts{"5:8: the fem path cannot represent plane stress: law(2)"});
}

TEST(FemScene, NeighboursInOnePlaceAreRefused) {
  std::string deck = string_deck();
  deck.replace(deck.find(".375"), 4, ".125");
  EXPECT_EQ(build_fem(deck).errors(), Texts{"11:1: point 2 at (0.125, 0.5) is where point 1 is"});  // told once
  // There and half way back: the points beside the turn are one.
  const char* groups =
      "$membrane curve(1)='polyline',x(1,1)=.2,.8,.5,y(1,1)=.5,.5,.5,\ncount=6,thickness=.1,density=1.,"
      "young=1. $\n";
  const auto errors = build_fem(on_unit_square(std::string("igen=3 $\n") + groups)).errors();
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("points 4 and 5 of the string stand in one place"), std::string::npos) << errors[0];
}

TEST(FemScene, HasNoFieldsOfAGrid) {
  const Built built = build_fem(string_deck("", "igen=0,iout(30)=1,tiout(30)=.1,iout(13)=1,tiout(13)=.1"));
  EXPECT_EQ(warnings_of(built), Texts{"iout(30)=1 writes nothing: bars have no grid"});
  EXPECT_EQ(built.scene.outputs.grid, 0);
  EXPECT_EQ(built.scene.outputs.points, 0.1);
}

}  // namespace
}  // namespace tether::test
