// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

TEST(FileBody, HasTheRowsOfTheFile) {
  const Built built = build(string_deck());
  ASSERT_EQ(built.errors(), Texts{});
  const PointSet& points = built.scene.points;
  EXPECT_EQ(points.x, (std::vector<double>{.125, .375, .625}));
  EXPECT_EQ(points.y, (std::vector<double>{.5, .5, .5}));
  EXPECT_EQ(points.vx, (std::vector<double>{1, 0, -1}));
  EXPECT_EQ(points.vy, (std::vector<double>{2, 0, 0}));
  EXPECT_EQ(points.sxx, (std::vector<double>{3, 0, 0}));
  EXPECT_EQ(points.syy, (std::vector<double>{4, 0, 0}));
  EXPECT_EQ(points.sxy, (std::vector<double>{5, 0, 0}));
}

/// V = dx dy / np2 = (1/4)(1/4) / 2 (5.4.4), m = .5 V.
TEST(FileBody, SharesTheVolumeOfACell) {
  const Scene scene = build(string_deck()).scene;
  EXPECT_EQ(scene.points.volume, std::vector<double>(3, 0.03125));
  EXPECT_EQ(scene.points.mass, std::vector<double>(3, 0.015625));
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "particle file");
  EXPECT_EQ(scene.bodies[0].density, 0.5);
  EXPECT_EQ(scene.bodies[0].count, 3u);
}

/// What is said of rows that are not there has no ground where the file could not be used.
TEST(FileBody, ThatIsNoneHasOneError) {
  std::string deck = string_deck("$points heavy(2)=3.3,tracked(3)=.true. $\n");
  deck.replace(deck.find("3,3,3,8"), 7, "3,3,3,5");
  const Texts errors = build(deck).errors();
  ASSERT_EQ(errors.size(), 1u) << errors.back();
  EXPECT_NE(errors.front().find("names no law"), std::string::npos);
}

TEST(FileBody, AHeavyPointKeepsItsVolumeAndTheDensityOfTheBody) {
  const Scene scene = build(string_deck("$points heavy(2)=3.3,heavy(3)=.1 $\n")).scene;
  EXPECT_EQ(scene.points.mass, (std::vector<double>{0.015625, 3.3, 0.1}));
  EXPECT_EQ(scene.points.volume, std::vector<double>(3, 0.03125));
  EXPECT_EQ(scene.bodies[0].density, 0.5);
}

TEST(FileBody, TracksRowsInTheirOrderThenPlaces) {
  const Scene scene =
      build(string_deck("$points\ntracked_at(1,1)=.4,.9\ntracked(3)=.true.,tracked(1)=.true.,tracked(2)=.false.\n$\n"))
          .scene;
  EXPECT_EQ(scene.tracked, (std::vector<std::size_t>{0, 2, 1}));
}

/// Rows count from the file's first one, places from all points: region 1 has the first 16.
TEST(FileBody, StandsBehindTheRegionsWithIgen3) {
  const std::string groups =
      "$reg\nnreg=1,nvi=4,xvi(1,1)=.25,.75,.75,.25,yvi(1,1)=.25,.25,.75,.75\ndensir=3.,ipath(4,1)=0,matr(1,1)=10.,."
      "25\n$\n"
      "$points heavy(1)=7.,tracked(2)=.true.,tracked_at(1,1)=0.,.5,tracked_at(1,2)=.26,.26 $\n";
  const Built built = build(string_deck(groups, "igen=3"));
  ASSERT_EQ(built.errors(), Texts{});
  const Scene& scene = built.scene;
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].name, "region 1");
  EXPECT_EQ(scene.bodies[1].first, 16u);
  EXPECT_EQ(scene.bodies[1].count, 3u);
  EXPECT_EQ(scene.points.mass[16], 7);
  EXPECT_EQ(scene.points.mass[0], 3.0 / 64);
  ASSERT_EQ(scene.tracked.size(), 3u);
  EXPECT_EQ(scene.tracked[0], 17u);
  EXPECT_EQ(scene.tracked[1], 16u);  // the file's first row, at (.125, .5)
  EXPECT_EQ(scene.points.x[scene.tracked[2]], .3125);
  EXPECT_EQ(scene.points.y[scene.tracked[2]], .3125);
}

TEST(FileBody, IsNotThereWithIgen1) {
  const Built built = build(square_region("igen=1") + "0.5\n1,0,0,0,0,0,0\n3,3,3,8\n1\n1,1\n.1 .1 0 0 0 0 0\n");
  EXPECT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.bodies.size(), 1u);
  EXPECT_EQ(built.scene.points.size(), 16u);
}

TEST(FileBody, RegionsAreNotThereWithIgen0) {
  const std::string groups = "$reg\nnreg=1,nvi=4,xvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,densir=1.,ipath(4,1)=0 $\n";
  EXPECT_EQ(build(string_deck(groups)).scene.points.size(), 3u);
}

TEST(FileBodyErrors, RowsBeyondTheFile) {
  const Built built = build(string_deck("$points heavy(4)=1.,2.,tracked(9)=3*.true. $\n"));
  EXPECT_EQ(built.errors(), (Texts{"5:18: heavy(4) counts rows of the particle file, which has 3",
                                   "5:37: tracked(9) counts rows of the particle file, which has 3"}));
}

TEST(FileBodyErrors, APlaceWithoutY) {
  EXPECT_EQ(build(string_deck("$points tracked_at(1,2)=.4 $\n")).errors(), (Texts{"5:25: tracked_at needs x and y"}));
}

/// V = 2 pi r dx dy / np2: the whole ring of the point's radius.
TEST(FileBody, PointsAreRingsAboutAnAxis) {
  const Scene scene = build(string_deck("", "igen=0,cyl=1.")).scene;
  ASSERT_EQ(scene.points.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(scene.points.volume[p], 0.03125 * 2 * std::numbers::pi * scene.points.x[p], 1e-16);
    EXPECT_NEAR(scene.points.mass[p], 0.5 * scene.points.volume[p], 1e-17);
  }
}

/// File 2 from line 5 on: header of 5 lines, then the rows from line 10 on.
Texts file_errors(const std::string& header, const std::string& rows) {
  return build(on_unit_square("igen=0\n$\n" + header + rows)).errors();
}

TEST(FileBodyErrors, EveryPointOutsideTheGridIsNamed) {
  EXPECT_EQ(
      file_errors("1.\n1,0,0,0,0,0,0\n3,3,3,0\n3\n3,1\n", ".5 .5 0 0 0 0 0\n1.5 .5 0 0 0 0 0\n.5 -.25 0 0 0 0 0\n"),
      (Texts{"11:1: point 2 at (1.5, 0.5) lies outside the grid",
             "12:1: point 3 at (0.5, -0.25) lies outside the grid"}));
}

TEST(FileBodyErrors, APointOnTheAxis) {
  const std::string file = "1.\n1,0,0,0,0,0,0\n3,3,3,0\n2\n2,1\n.5 .5 0 0 0 0 0\n0. .5 0 0 0 0 0\n";
  EXPECT_EQ(build(on_unit_square("igen=0,cyl=1.\n$\n" + file)).errors(),
            (Texts{"11:1: point 2 at (0, 0.5) lies on the axis"}));
  EXPECT_EQ(build(on_unit_square("igen=0\n$\n" + file)).errors(), Texts{});
}

TEST(FileBodyErrors, AStringIsOneSequenceOfTwoPointsAtLeast) {
  EXPECT_EQ(file_errors("1.\n1,0,0,0,0,0,0\n3,3,3,8\n2\n1,1\n", ".5 .5 0 0 0 0 0\n"),
            (Texts{"0:0: a string needs at least 2 points",
                   "0:0: 2 points in the sequence, 1 in total: a string is one sequence"}));
}

TEST(FileBodyErrors, ASolidNeedsNoSequence) {
  EXPECT_EQ(file_errors("1.\n1,0,0,0,0,0,0\n3,3,3,0\n0\n1,1\n", ".5 .5 0 0 0 0 0\n"), Texts{});
}

TEST(FileBodyErrors, ADeckThatDescribesNoPoint) {
  EXPECT_EQ(build(on_unit_square("igen=1\n$\n")).errors(), (Texts{"3:6: the deck describes no point"}));
}

}  // namespace
}  // namespace tether::test
