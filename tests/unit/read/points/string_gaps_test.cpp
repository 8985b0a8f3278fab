// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/string_gaps.hpp"

#include <gtest/gtest.h>

#include "unit/read/points/membranes_support.hpp"

namespace tether::test {
namespace {

/// A level string of points so many cells apart from .05 on, on cells of 1.
StringGaps level(double cells, int points, Kernel kernel) {
  std::vector<double> x, y;
  for (int k = 0; k < points; ++k) x.push_back(0.05 + cells * k), y.push_back(0.5);
  return string_gaps(BackgroundGrid(21, 2, 0, 20, 0, 1), kernel, {x, y});
}

TEST(StringGaps, NeighboursACellApartAlwaysShareANode) {
  for (const Kernel kernel : {Kernel::linear, Kernel::bspline}) {
    const StringGaps gaps = level(1, 12, kernel);
    EXPECT_EQ(gaps.apart, 0u);
    EXPECT_NEAR(gaps.widest, 1, 1e-14);
  }
}

TEST(StringGaps, NeighboursFurtherApartShareOneByTheirPlace) {
  EXPECT_EQ(level(1.5, 2, Kernel::linear).apart, 0u);  // .05 and 1.55 have node 1 in common
  const StringGaps some = level(1.5, 4, Kernel::linear);
  EXPECT_EQ(some.apart, 1u);  // 1.55 and 3.05 have none
  EXPECT_EQ(some.first_apart, 1u);
  EXPECT_EQ(level(2.1, 5, Kernel::linear).apart, 4u);
  EXPECT_EQ(level(2.1, 5, Kernel::bspline).apart, 0u);
  EXPECT_EQ(level(3.1, 5, Kernel::bspline).apart, 4u);
}

TEST(StringGaps, AClosedOneHasAPairMore) {
  const std::vector<double> x{0.5, 1.5, 2.5, 3.5}, y(4, 0.5);
  const BackgroundGrid grid(21, 2, 0, 20, 0, 1);
  EXPECT_EQ(string_gaps(grid, Kernel::linear, {x, y, false}).apart, 0u);
  const StringGaps closed = string_gaps(grid, Kernel::linear, {x, y, true});
  EXPECT_EQ(closed.apart, 1u);
  EXPECT_EQ(closed.first_apart, 3u);
  EXPECT_EQ(closed.widest, 3);
}

// Cells of .25 and a line of .8.
TEST(StringGaps, AStringThatDoesNotHoldTogetherIsRefused) {
  EXPECT_EQ(one_line("count(1)=2").errors(), Texts{});
  const Built built = membranes(membrane_properties +
                                std::string("curve(1)='line',x(1,1)=.0,1.,y(1,1)=.5,.5\ncount(1)=2,pinned(1)='both'"));
  EXPECT_EQ(built.errors(),
            (Texts{"7:10: membrane 1: points 1 and 2 share no node of the grid: 1 of 1 neighbours do not, and the "
                   "string does not hold together there"}));
  EXPECT_EQ(one_line("count(1)=2,pinned(1)='both',strain='element'").errors(), Texts{});  // elements join its points
}

TEST(StringGaps, NeighboursMoreThanACellApartAreWarnedOf) {
  EXPECT_EQ(warnings(one_line("count(1)=4")), Texts{});
  EXPECT_EQ(warnings(one_line("count(1)=2")),
            (Texts{"7:10: membrane 1: points 1 and 2 are 1.6 cells apart: as they move they can come to share no node, "
                   "and the string comes apart"}));
  EXPECT_EQ(warnings(one_line("count(1)=2,strain='element'")), Texts{});  // there is no fluid to pass
}

TEST(StringGaps, AnEndOffItsWallIsWarnedOf) {
  const auto to = [](const std::string& end, const std::string& in) {
    return warnings(
        membranes(membrane_properties + ("curve(1)='line',x(1,1)=.3," + end + ",y(1,1)=.5,.5\ncount(1)=8"), in));
  };
  EXPECT_EQ(to("1.", "wr=0"), Texts{});  // half a piece off the wall
  EXPECT_EQ(
      to("0.88", "wr=0"),
      (Texts{"7:10: membrane 1: its last point stands 0.625 of a cell off the right wall, whose nodes hold little "
             "of it: the string comes off, and fluid passes there"}));
  EXPECT_EQ(to("0.88", "wr=1"), Texts{});  // no wall
  EXPECT_EQ(to("0.88", "wr=6"), Texts{});  // and no fluid that would pass
  EXPECT_EQ(to("0.5", "wr=0"), Texts{});   // far from it
}

TEST(StringGaps, TheRowsOfAFileAreJudgedToo) {
  std::string text = string_deck();  // .125, .375, .625: a cell apart
  EXPECT_EQ(build(text).errors(), Texts{});
  text.replace(text.find("nx=5"), 4, "nx=9");  // two
  const Texts errors = build(text).errors();
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("points 1 and 2 share no node of the grid: 2 of 2 neighbours"), std::string::npos)
      << errors[0];
}

TEST(MembraneEnds, CarryMasses) {
  const Built built = one_line("count(1)=4,heavy(1,1)=7.,heavy(2,1)=9.");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_EQ(built.scene.points.mass.front(), 7);
  EXPECT_EQ(built.scene.points.mass.back(), 9);
  EXPECT_EQ(built.scene.points.volume.front(), built.scene.points.volume[1]);
  EXPECT_EQ(built.scene.points.mass[1], built.scene.points.mass[2]);
  EXPECT_EQ(one_line("count(1)=4,heavy(2,2)=9.").errors(),
            (Texts{"7:23: heavy(2,2) is given, and no curve belongs to membrane 2"}));
}

}  // namespace
}  // namespace tether::test
