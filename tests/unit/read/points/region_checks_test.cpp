// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/points/region_checks.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "read/points/region_extent.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

using std::numbers::pi;

Polygon box(double x0, double x1, double y0, double y1) { return {{x0, x1, x1, x0}, {y0, y0, y1, y1}}; }

const Ellipse everywhere{0, 0, 1e30, 1e30};

TEST(DrawnExtent, OfPolygonsIsExact) {
  const BackgroundGrid grid(5, 5, 0, 4, 0, 4);
  const RegionShape rectangle{box(.3, 1.7, .2, 3.9), everywhere, {}};
  EXPECT_NEAR(drawn_extent(rectangle, grid, Geometry::plane).area, 1.4 * 3.7, 1e-13);
  EXPECT_NEAR(drawn_extent(rectangle, grid, Geometry::plane).volume, 1.4 * 3.7, 1e-13);
  EXPECT_NEAR(drawn_extent(rectangle, grid, Geometry::axisymmetric).volume, pi * (1.7 * 1.7 - .3 * .3) * 3.7, 1e-12);
  const RegionShape triangle{{{.5, 3.5, 1}, {.5, 1, 3}}, everywhere, {}};
  EXPECT_NEAR(drawn_extent(triangle, grid, Geometry::plane).area, .5 * (3 * 2.5 - .5 * .5), 1e-13);
  const RegionShape beyond{box(-1, 2, 3, 7), everywhere, {}};  // two by one of it lie in the grid
  EXPECT_NEAR(drawn_extent(beyond, grid, Geometry::plane).area, 2, 1e-13);
}

TEST(DrawnExtent, OfEllipses) {
  const BackgroundGrid grid(5, 5, 0, 4, 0, 4);
  const RegionShape ring{box(0, 4, 0, 4), {2, 2, 1.5, 1.2}, {2, 2, .7, .4}};
  EXPECT_NEAR(drawn_extent(ring, grid, Geometry::plane).area, pi * (1.5 * 1.2 - .7 * .4), 1e-4);
  const RegionShape quarter{box(0, 4, 0, 4), {0, 0, 1, 1}, {}};
  EXPECT_NEAR(drawn_extent(quarter, grid, Geometry::plane).area, pi / 4, 2e-5);
  EXPECT_NEAR(drawn_extent(quarter, grid, Geometry::axisymmetric).volume, 2 * pi / 3, 2e-4);  // half a ball
}

TEST(SharedExtent, OfTwoShapes) {
  const BackgroundGrid grid(5, 5, 0, 4, 0, 4);
  const RegionShape left{box(1, 2, 1, 3), everywhere, {}}, right{box(1.75, 3, 2.5, 4), everywhere, {}};
  EXPECT_NEAR(shared_extent(left, right, grid, Geometry::plane).area, .25 * .5, 1e-13);
  const RegionShape inner{box(0, 4, 0, 4), {2, 2, 1, 1}, {}}, outer{box(0, 4, 0, 4), everywhere, {2, 2, 1, 1}};
  EXPECT_EQ(shared_extent(inner, outer, grid, Geometry::plane).area, 0);
}

/// "line: message" of each warning.
Texts warned(const Built& built) {
  Texts texts;
  for (const auto& d : built.diagnostics.warnings()) texts.push_back(std::to_string(d.place.line) + ": " + d.message);
  return texts;
}

/// Two bars .8 high in cells of .05 with four points each; the columns of points stand at odd 80ths.
std::string two_bars(const std::string& first, const std::string& second) {
  return "$in nx=21,ny=21,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.01,tstep=1.e-4 $\n$reg nreg=2,nvi=4,4,\nxvi(1,1)=" +
         first + ",yvi(1,1)=.1,.1,.9,.9\nxvi(1,2)=" + second +
         ",yvi(1,2)=.1,.1,.9,.9\ndensir=1000.,1000.,matr(1,1)=1.e5,.3,matr(1,2)=1.e5,.3,ipath(4,1)=0,ipath(4,2)=0 $\n";
}

Built bars(const std::string& first, const std::string& second) { return build(two_bars(first, second)); }

/// Each is .03 wide.
TEST(FilledRegions, WhoseMassDependsOnTheGridAreWarnedOf) {
  const std::string other = "where 0.024 is drawn, and so its mass is ";
  const Built built = bars(".215,.245,.245,.215", ".661,.691,.691,.661");
  EXPECT_EQ(warned(built),
            (Texts{"3: region 1: its points hold an area of 0.02 " + other + "20 in place of 24, -16.7 %",
                   "4: region 2: its points hold an area of 0.04 " + other + "40 in place of 24, +66.7 %"}));
}

TEST(FilledRegions, AlongTheLatticeAreExact) { EXPECT_EQ(warned(bars(".2,.225,.225,.2", ".65,.7,.7,.65")), Texts{}); }

TEST(FilledRegions, HaveALineEach) {
  const std::string text = two_bars(".2,.225,.225,.2", ".661,.691,.691,.661");
  Diagnostics ignored;
  EXPECT_EQ(
      regions_text(read_deck(text, "a.in", {}, ignored), build(text).scene),
      "region 1: its points hold an area of 0.02 and a mass of 20, as drawn\nregion 2: its points hold an area of "
      "0.04 and a mass of 40, drawn are 0.024 and 24: +66.7 %\n");
}

/// The thesis' piston has a column .3 wide in cells of 1, of one point each.
TEST(FilledRegions, OfOneCellAcrossAreRemarkedOn) {
  const Built built = build(
      "$in nx=2,ny=11,xleft=0.,xright=1.,ybot=0.,ytop=10.,tmax=.1,tstep=.01 $\n$reg nreg=1,nvi=4,"
      "nprg=1,xvi(1,1)=.35,.65,.65,.35,yvi(1,1)=0.,0.,10.,10.,densir=1.,matr(1,1)=1.,ipath(4,1)=8 $\n");
  EXPECT_EQ(warned(built), Texts{});
  ASSERT_EQ(built.diagnostics.remarks().size(), 1u);
  EXPECT_NE(built.diagnostics.remarks().front().message.find("10 in place of 3"), std::string::npos);
}

/// By a tenth of their widths; as far apart as rounding; by less than the area of a point.
TEST(FilledRegions, ThatShareSpaceAreWarnedOf) {
  const Texts found = warned(bars(".2,.4,.4,.2", ".3,.6,.6,.3"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(
      found.front(),
      "4: region 2: it shares an area of 0.08 with region 1, 50 % of the smaller one: what is there has the points "
      "and the mass of both");
  EXPECT_EQ(warned(bars(".2,.4,.4,.2", ".4,.6,.6,.4")), Texts{});
  EXPECT_EQ(warned(bars(".2,.4,.4,.2", ".3999999,.6,.6,.3999999")), Texts{});
}

/// A closed membrane of half axes .3 and .2 about the middle, and gas out to `a` and `b`.
Built bag(const std::string& a, const std::string& b) {
  return build(
      "$in nx=41,ny=41,xleft=0.,xright=1.,ybot=0.,ytop=1.,tmax=.01,tstep=1.e-4 $\n$fluid siep=2.5 $\n$reg "
      "nreg=1,nvi=4,\nxvi(1,1)=0.,1.,1.,0.,yvi(1,1)=0.,0.,1.,1.,xcenter=.5,ycenter=.5,rex=" +
      a + ",rey=" + b +
      ",densir=1.,ipath(4,1)=7 $\n$membrane curve='ellipse',xc=.5,yc=.5,a=.3,b=.2,count=200,thickness=.001,"
      "density=1.,young=1.,strain='element' $\n");
}

TEST(FilledRegions, OfGasOnBothSidesOfAMembraneAreWarnedOf) {
  EXPECT_EQ(warned(bag(".3", ".2")), Texts{});
  const Texts found = warned(bag(".45", ".2"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found.front().find("of its gas lies outside membrane 1, which is closed"), std::string::npos)
      << found.front();
}

}  // namespace
}  // namespace tether::test
