// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/read/scene_support.hpp"
#include "unit/total.hpp"

namespace tether::test {
namespace {

/// Points of the middle four cells: the lattice of a cell is at the middles of side x side sub-cells.
void expect_lattice(int side) {
  const Built built = build(square_region("", "nprg=" + std::to_string(side * side) + ",vrx=2.,vry=-1."));
  ASSERT_EQ(built.errors(), Texts{});
  const PointSet& points = built.scene.points;
  const auto n = static_cast<std::size_t>(4 * side * side);
  ASSERT_EQ(points.size(), n);
  std::vector<std::pair<double, double>> here, expected;
  for (std::size_t p = 0; p < n; ++p) here.emplace_back(points.x[p], points.y[p]);
  for (int a = 0; a < 2 * side; ++a) {
    for (int b = 0; b < 2 * side; ++b) expected.emplace_back(.25 + .25 * (a + .5) / side, .25 + .25 * (b + .5) / side);
  }
  std::sort(here.begin(), here.end());
  std::sort(expected.begin(), expected.end());
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_NEAR(here[p].first, expected[p].first, 1e-15);
    EXPECT_NEAR(here[p].second, expected[p].second, 1e-15);
    EXPECT_NEAR(points.volume[p], 0.0625 / (side * side), 1e-17);
    EXPECT_NEAR(points.mass[p], 3 * 0.0625 / (side * side), 1e-17);
    EXPECT_EQ(points.vx[p], 2);
    EXPECT_EQ(points.vy[p], -1);
    EXPECT_EQ(points.sxx[p], 0);
    EXPECT_EQ(points.syy[p], 0);
    EXPECT_EQ(points.sxy[p], 0);
  }
}

TEST(Regions, OnePointACell) { expect_lattice(1); }
TEST(Regions, FourPointsACell) { expect_lattice(2); }
TEST(Regions, NinePointsACell) { expect_lattice(3); }

TEST(Regions, BodyOfARegion) {
  const Scene scene = build(square_region()).scene;
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].name, "region 1");
  EXPECT_EQ(scene.bodies[0].density, 3);
  EXPECT_EQ(scene.bodies[0].specific_energy, 0);
  EXPECT_EQ(scene.bodies[0].first, 0u);
  EXPECT_EQ(scene.bodies[0].count, 16u);  // nprg = 4 where it is not given
}

/// A region of one polygon on the grid of 4 x 4 cells, 16 points a cell.
Built with_polygon(int vertices, const std::string& x, const std::string& y, const std::string& more = "") {
  return build(
      on_unit_square("$\n$reg\nnreg=1,nprg=16,densir=1.,ipath(4,1)=0,matr(1,1)=1.\nnvi=" + std::to_string(vertices) +
                     "\nxvi(1,1)=" + x + "\nyvi(1,1)=" + y + "\n" + more + "\n$\n"));
}

/// An L of 3/4 height and width and 1/4 thickness: 5 cells of 16 points.
TEST(Regions, NonConvexPolygon) {
  const Scene scene = with_polygon(6, "0.,.75,.75,.25,.25,0.", "0.,0.,.25,.25,.75,.75").scene;
  ASSERT_EQ(scene.points.size(), 80u);
  EXPECT_NEAR(total(scene.points.mass), 5.0 / 16, 1e-15);
  for (std::size_t p = 0; p < 80; ++p) EXPECT_TRUE(scene.points.x[p] < .25 || scene.points.y[p] < .25);
}

/// Points stand at odd 32nds. Edges at .25 + 1/32 cut a row of them, which belongs to one of the two regions.
TEST(Regions, TwoThatShareAnEdgeThroughPointsShareNoPoint) {
  const std::string two =
      "$\n$reg\nnreg=2,nvi=4,4,nprg=16,16,densir=1.,1.,ipath(4,1)=0,ipath(4,2)=0,matr(1,1)=1.,matr(1,2)=1.\n"
      "xvi(1,1)=0.,.28125,.28125,0.\nyvi(1,1)=0.,0.,1.,1.\nxvi(1,2)=.28125,1.,1.,.28125\nyvi(1,2)=0.,0.,1.,1.\n$\n";
  const Scene scene = build(on_unit_square(two)).scene;
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.points.size(), 256u);
  EXPECT_EQ(scene.bodies[1].name, "region 2");
  EXPECT_EQ(scene.bodies[1].first, scene.bodies[0].count);
  EXPECT_EQ(scene.bodies[0].count + scene.bodies[1].count, 256u);
  EXPECT_NEAR(total(scene.points.mass), 1, 1e-14);
}

/// The part beyond the grid holds no points: what is left is 2 x 4 cells.
TEST(Regions, AreClippedByTheGrid) {
  EXPECT_EQ(with_polygon(4, "-3.,.5,.5,-3.", "-3.,-3.,5.,5.").scene.points.size(), 128u);
}

/// Sub-cells whose middle (2 i + 1, 2 j + 1) / 2 lies inside the quarter circle of radius n, in whole numbers.
int quarter_disc_count(int n) {
  int count = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = 2 * i + 1, b = 2 * j + 1;
      count += a * a + b * b < 4 * n * n ? 1 : 0;
    }
  }
  return count;
}

/// Mass pi r^2 / 4 of a quarter disc: the count of the lattice is exact, and its error falls with the spacing 1/n.
TEST(Regions, MassOfAQuarterDisc) {
  for (const int side : {1, 2, 4, 8, 16, 32}) {
    const int n = 4 * side;
    const Scene scene =
        with_polygon(4, "0.,1.,1.,0.", "0.,0.,1.,1.", "rex=1.,rey=1.,nprg=" + std::to_string(side * side)).scene;
    EXPECT_EQ(scene.points.size(), static_cast<std::size_t>(quarter_disc_count(n)));
    const double mass = total(scene.points.mass);
    EXPECT_NEAR(mass, quarter_disc_count(n) / static_cast<double>(n * n), 1e-12);
    EXPECT_NEAR(mass, std::numbers::pi / 4, 0.25 / n) << side;
  }
}

/// Between the ellipses 1 x 3/4 and 1/2 x 1/4 about the lower left corner; middles in 32nds, (2 i + 1) / 32.
TEST(Regions, BetweenTwoEllipses) {
  std::size_t expected = 0;
  for (int a = 1; a < 32; a += 2) {
    for (int b = 1; b < 32; b += 2) {
      const bool in_outer = 9 * a * a + 16 * b * b < 9 * 1024, in_inner = a * a + 4 * b * b < 256;
      expected += in_outer && !in_inner ? 1 : 0;
    }
  }
  const Built built = with_polygon(4, "0.,1.,1.,0.", "0.,0.,1.,1.", "rex=1.,rey=.75,rix=.5,riy=.25");
  EXPECT_EQ(built.scene.points.size(), expected);
  EXPECT_NEAR(total(built.scene.points.mass), std::numbers::pi / 4 * (0.75 - 0.125), 0.01);
}

/// A cylinder of radius 3/4 and height 1/2, turned about x = 0: the lattice's middles give pi R^2 h exactly.
TEST(Regions, PointsAreRingsAboutAnAxis) {
  const Built built =
      build(on_unit_square("cyl=1.\n$\n$reg\nnreg=1,nprg=9,densir=2.,ipath(4,1)=0,matr(1,1)=1.,nvi=4\n"
                           "xvi(1,1)=0.,.75,.75,0.\nyvi(1,1)=0.,0.,.5,.5\n$\n"));
  ASSERT_EQ(built.errors(), Texts{});
  const PointSet& points = built.scene.points;
  EXPECT_NEAR(total(points.volume), std::numbers::pi * 0.5625 * 0.5, 1e-14);
  EXPECT_NEAR(total(points.mass), 2 * std::numbers::pi * 0.5625 * 0.5, 1e-14);
  EXPECT_NEAR(points.volume[0], 0.0625 / 9 * 2 * std::numbers::pi * points.x[0], 1e-17);
}

Texts region_errors(const std::string& reg) { return build(on_unit_square("$\n$reg\n" + reg + "\n$\n")).errors(); }

TEST(RegionErrors, AllAtOnceAtTheirPlaces) {
  EXPECT_EQ(region_errors("nreg=1,nvi=2\nnprg=5\nipath(4,1)=7"),
            (Texts{"5:12: region 1: a polygon has at least 3 vertices, not 2", "6:6: region 1: nprg = 5 is no square",
                   "4:1: region 1: densir(1) is not given",
                   "7:12: region 1: a gas needs siep(1), its initial specific internal energy"}));
}

TEST(RegionErrors, AVertexThatIsNotGiven) {
  const std::string region = "nreg=1,nvi=4,densir=1.,ipath(4,1)=0,matr(1,1)=1.\n";
  EXPECT_EQ(region_errors(region + "xvi(1,1)=0.,1.,1.\nyvi(1,1)=0.,0.,1.,1."),
            (Texts{"5:12: region 1: xvi(4,1) is not given"}));
  EXPECT_EQ(region_errors(region + "xvi(1,1)=0.,1.,1.,0.\nyvi(1,1)=0.,,1.,1."),
            (Texts{"5:12: region 1: yvi(2,1) is not given"}));
}

TEST(RegionErrors, OutsideTheGridOrWithoutAPoint) {
  const Built outside = with_polygon(3, "2.,3.,3.", "0.,0.,1.");
  EXPECT_EQ(outside.errors(), (Texts{"7:10: region 1: it lies wholly outside the grid"}));
  const Built sliver = with_polygon(3, "0.,.01,.01", "0.,0.,.01");
  EXPECT_EQ(sliver.errors(), (Texts{"7:10: region 1: it holds no point"}));
}

TEST(RegionErrors, TheLargestIntegerIsNoSquare) {
  EXPECT_EQ(with_polygon(4, "0.,1.,1.,0.", "0.,0.,1.,1.", "nprg=2147483647").errors(),
            (Texts{"9:6: region 1: nprg = 2147483647 is no square"}));
}

/// 46340^2 points in each of 16 cells.
TEST(RegionErrors, MorePointsThanTheMemoryHolds) {
  const Texts errors = region_errors(
      "nreg=1,nvi=4,densir=1.,ipath(4,1)=0,matr(1,1)=1.\nnprg=2147395600\nxvi(1,1)=0.,1.,1.,0.\nyvi(1,1)=0.,0.,1.,1.");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_TRUE(errors[0].starts_with("6:6: region 1: 5 x 5 nodes and 3.44e+10 points would need ")) << errors[0];
}

}  // namespace
}  // namespace tether::test
