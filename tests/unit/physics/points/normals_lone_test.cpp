// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "unit/physics/points/normals_support.hpp"

// Points that are alone in their cells (Fig. 88), images behind mirrors, edges of the grid, the sense of a tangent.

namespace tether::mpm {
namespace {

using namespace curves;

const std::vector<NormalRule> mass_rules{NormalRule::mass_linear, NormalRule::mass_quadratic};
const std::vector<NormalRule> grid_rules{NormalRule::color, NormalRule::quadratic, NormalRule::cubic};

struct Turned {
  std::vector<double> tx, ty;
};

/// Tangents of a curve by a rule that begins with one and the same tangent everywhere.
Turned turned(const Curve& curve, const Setting& s, double tx, double ty) {
  Turned t{std::vector<double>(curve.size(), tx), std::vector<double>(curve.size(), ty)};
  turn(curve, s, t.tx, t.ty);
  return t;
}

// Points more than a cell apart on a line at 30 degrees: the ghost cell of each holds a neighbour.
TEST(LonePoints, AGhostCellFindsTheLine) {
  const Curve curve = line_curve(0.5, 0.5, 30, {-1.1, 0, 1.1});
  for (const auto rule : mass_rules) {
    const Turned t = turned(curve, setting(rule), 1, 0);
    EXPECT_LT(largest(angles(curve, t.tx, t.ty)), 1e-10);
  }
}

TEST(LonePoints, OrTheTangentBeforeStays) {
  const Curve curve = line_curve(0.5, 0.5, 30, {-1.1, 0, 1.1});
  for (const auto rule : mass_rules) {
    const Turned t = turned(curve, setting(rule, MatrixScope::cell, LonePoint::previous), 0.6, 0.8);
    for (std::size_t p = 0; p < 3; ++p) EXPECT_TRUE(t.tx[p] == 0.6 && t.ty[p] == 0.8);
  }
}

// Only the lone point takes the normal of the ghost cell: the two in the cell beside it keep their own chord's.
TEST(LonePoints, OnlyTheLonePointTakesTheGhostCellsNormal) {
  Curve curve;
  curve.add(0.9, 0.5, 1, 0), curve.add(1.2, 0.4, 1, 0.5), curve.add(1.6, 0.6, 1, 0.5);
  const Turned t = turned(curve, setting(NormalRule::mass_linear), 1, 0);
  EXPECT_NEAR(t.ty[1] / t.tx[1], 0.5, 1e-12);
  EXPECT_NEAR(t.ty[2] / t.tx[2], 0.5, 1e-12);
  EXPECT_LT(t.ty[0] / t.tx[0], 0.4);
}

// Nothing around: every mass matrix leaves the tangent where it was.
TEST(LonePoints, FarFromAllOthersTheTangentStays) {
  Curve curve;
  curve.add(0.2, 0.3, 0.6, 0.8);
  curve.add(-1.5, 2.5, 0.6, 0.8);
  for (const auto rule : mass_rules) {
    for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
      const Turned t = turned(curve, setting(rule, scope), 0.6, 0.8);
      for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_NEAR(t.tx[p], 0.6, 1e-7);
        EXPECT_NEAR(t.ty[p], 0.8, 1e-7);
      }
    }
  }
}

// Points on one spot are one point: they tell no direction, and no number becomes unsound.
TEST(LonePoints, PointsOnOneSpotCountAsOne) {
  Curve curve;
  for (int k = 0; k < 3; ++k) curve.add(0.4, 0.6, 0.6, 0.8);
  curve.add(0.4 + 1e-9, 0.6, 0.6, 0.8);
  for (const auto rule : mass_rules) {
    for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
      const Turned t = turned(curve, setting(rule, scope), 0.6, 0.8);
      EXPECT_NEAR(t.tx[3], 0.6, 1e-6);
      EXPECT_NEAR(t.ty[3], 0.8, 1e-6);
    }
  }
}

// In one matrix for the whole membrane a neighbour's colours reach into the cell of a lone point.
TEST(LonePoints, NeedNoGhostInTheMatrixOfTheMembrane) {
  const Curve curve = line_curve(0.4, 0.45, 20, {-1.5, -1.25, -1, 0, 0.8, 1.05, 1.3});
  for (const auto rule : mass_rules) {
    const Turned t = turned(curve, setting(rule, MatrixScope::membrane), 1, 0);
    EXPECT_LT(largest(angles(curve, t.tx, t.ty)), 0.1);
  }
}

// A membrane that crosses a mirror at a right angle, its last point alone beside the wall: its image is its neighbour.
TEST(LonePoints, SeeTheirImageInAMirror) {
  for (const auto rule : mass_rules) {
    Setting s = setting(rule);
    for (const bool mirror : {true, false}) {
      const Wall wall = mirror ? Wall::symmetry : Wall::open;
      s.walls = {wall, wall, wall, wall};
      for (const double x : {-1.8, 2.8}) {  // beside the left and the right wall
        const Turned t = turned(line_curve(x, 0.4, 0, {0}), s, 0.8, 0.6);
        EXPECT_NEAR(t.tx[0], mirror ? 1 : 0.8, 1e-10);
      }
      for (const double y : {-1.8, 2.8}) {
        const Turned t = turned(line_curve(0.4, y, 90, {0}), s, 0.8, 0.6);
        EXPECT_NEAR(t.ty[0], mirror ? 1 : 0.6, 1e-10);
      }
    }
  }
}

// Four cells hold each point once, the lone one first, and the image where there is a mirror.
TEST(LonePoints, GhostCellHoldsEachPointOnce) {
  const std::vector<double> x{0.2, 0.4, 1.1, 2.5}, y{1.75, 2.5, 1.25, 1.5};
  for (const auto wall : {Wall::symmetry, Wall::open}) {
    MembraneCells cells(BackgroundGrid(4, 4, 0, 3, 0, 3), {wall, Wall::open, Wall::open, Wall::open}, 4);
    cells.sort({x, y}, {0, 4});
    std::vector<LocalPlace> places;
    cells.ghost_places(*cells.find(0, 1), places);
    const std::vector<LocalPlace> with_image{{0.6, 0.375}, {0.4, 0.375}, {0.3, 0.75}, {0.7, 0.75}};
    const std::vector<LocalPlace> without{{0.1, 0.375}, {0.55, 0.125}, {0.2, 0.75}};
    const auto& expected = wall == Wall::symmetry ? with_image : without;
    ASSERT_EQ(places.size(), expected.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_NEAR(places[k].r, expected[k].r, 1e-15);
      EXPECT_NEAR(places[k].s, expected[k].s, 1e-15);
    }
  }
}

// At an open edge there is nothing behind it: the ghost cell stays inside, and finds the neighbour that is there.
TEST(LonePoints, AtAnOpenEdgeTheGhostCellLiesInside) {
  for (const auto rule : mass_rules) {
    for (const double x : {-1.8, 2.8}) {
      const Curve curve = line_curve(x, 0.5, 10, {0, x < 0 ? 1.2 : -1.2});
      const Turned t = turned(curve, setting(rule), 1, 0);
      EXPECT_LT(angles(curve, t.tx, t.ty)[0], 1e-10);
    }
  }
}

// The only cell of a grid has no images behind open edges.
TEST(LonePoints, InTheOnlyCellOfAGridStay) {
  for (const auto rule : mass_rules) {
    for (const double x : {0.2, 0.8}) {
      Setting s = setting(rule);
      s.grid = BackgroundGrid(2, 2, 0, 1, 0, 1);
      const Turned t = turned(line_curve(x, x, 0, {0}), s, 0.6, 0.8);
      EXPECT_TRUE(t.tx[0] == 0.6 && t.ty[0] == 0.8);
    }
  }
}

// Grids of one cell, and points on their edges and corners.
TEST(LonePoints, StandAnywhereOnTheSmallestGrid) {
  for (const auto wall : {Wall::open, Wall::symmetry, Wall::fixed}) {
    for (const double x : {0.0, 0.4, 1.0}) {
      for (const auto rule : {NormalRule::color, NormalRule::quadratic, NormalRule::cubic, NormalRule::mass_linear,
                              NormalRule::mass_quadratic}) {
        for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
          Setting s = setting(rule, scope);
          s.grid = BackgroundGrid(2, 2, 0, 1, 0, 1);
          s.walls = {wall, Wall::open, wall, wall};
          const Turned t = turned(line_curve(x, 0, 90, {0, 1}), s, 0.6, 0.8);
          for (std::size_t p = 0; p < 2; ++p) EXPECT_NEAR(std::hypot(t.tx[p], t.ty[p]), 1, 1e-12);
        }
      }
    }
  }
}

// By symmetry the colour of a point alone in the middle of a cell has no gradient there: no rule may make one up.
TEST(GridNormals, WithoutAGradientTheTangentStays) {
  for (const auto rule : grid_rules) {
    const Turned t = turned(line_curve(0.5, 0.5, 0, {0}), setting(rule), 0.6, 0.8);
    EXPECT_EQ(t.tx[0], 0.6);
    EXPECT_EQ(t.ty[0], 0.8);
  }
}

// A membrane on the flat side of a block of fluid, cells twice as long as high: exact by symmetry along the side.
TEST(GridNormals, AFlatSideIsExact) {
  for (const auto rule : grid_rules) {
    Setting s = setting(rule);
    s.grid = BackgroundGrid(6, 11, -2, 3, -2, 3);
    s.walls = {Wall::symmetry, Wall::free_slip, Wall::open, Wall::open};
    Curve curve;
    for (int k = 0; k < 20; ++k) curve.add(-2 + 0.25 * (k + 0.5), 1.1, 1, 0);
    for (int b = 0; b < 12; ++b) {
      for (int a = 0; a < 20; ++a) {
        curve.x.push_back(-2 + 0.25 * (a + 0.5)), curve.y.push_back(-2 + 0.25 * (b + 0.5));
      }
    }
    const Turned t = turned(curve, s, 0.8, 0.6);
    EXPECT_LT(largest(angles(curve, t.tx, t.ty)), 1e-10);
  }
}

// And on a side at 45 degrees: some degrees in cells that are not square, where the kernels are not round.
TEST(GridNormals, ASlopingSideInCellsThatAreNotSquare) {
  for (const auto rule : grid_rules) {
    Setting s = setting(rule);
    s.grid = BackgroundGrid(11, 21, 0, 10, 0, 10);
    Curve curve;
    for (int k = 0; k < 64; ++k) curve.add(8 - (k + 0.5) / 16, 2 + (k + 0.5) / 16, -1, 1);
    for (int b = 0; b < 80; ++b) {
      for (int a = 0; a < 80; ++a) {
        const double x = (a + 0.5) / 8, y = (b + 0.5) / 8;
        if (x + y < 10) curve.x.push_back(x), curve.y.push_back(y);
      }
    }
    const Turned t = turned(curve, s, 0, 1);
    EXPECT_LT(rms(angles(curve, t.tx, t.ty)), 8);
  }
}

// The tangent keeps its sense: with the one before reversed, it comes out reversed and else the same.
TEST(Normals, TangentsKeepTheirSense) {
  Curve curve = arc_curve(0.5, 0.5, 1.2, 0, 300, 40);
  for (int k = 0; k < 50; ++k) {
    curve.x.push_back(0.5 + 0.9 * std::sin(2.4 * k) * std::sqrt(k / 50.0));
    curve.y.push_back(0.5 + 0.9 * std::cos(2.4 * k) * std::sqrt(k / 50.0));
  }
  for (const auto rule : {NormalRule::color, NormalRule::quadratic, NormalRule::cubic, NormalRule::mass_linear,
                          NormalRule::mass_quadratic}) {
    for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
      auto [tx, ty] = chords(curve);
      auto back_x = tx, back_y = ty;
      for (std::size_t p = 0; p < tx.size(); ++p) back_x[p] = -tx[p], back_y[p] = -ty[p];
      const auto before_x = tx, before_y = ty;
      turn(curve, setting(rule, scope), tx, ty);
      turn(curve, setting(rule, scope), back_x, back_y);
      for (std::size_t p = 0; p < tx.size(); ++p) {
        EXPECT_GE(tx[p] * before_x[p] + ty[p] * before_y[p], 0);
        EXPECT_NEAR(back_x[p], -tx[p], 1e-9);
        EXPECT_NEAR(back_y[p], -ty[p], 1e-9);
      }
    }
  }
}

// Heaps, clusters and doubles of points, on a few cells: whatever comes out is a unit vector on the side of the one
// before.
TEST(Normals, AreUnitVectorsForAnyHeapOfPoints) {
  const auto number = [](int k) { return 0.5 + 0.5 * std::sin(12.9898 * k + 0.3 * k * k); };  // 0 to 1
  for (int heap = 0; heap < 60; ++heap) {
    Curve curve;
    const double size = heap % 3 == 0 ? 5 : heap % 3 == 1 ? 1 : 1e-3;
    for (int k = 0; k < 3 + heap % 17; ++k) {
      const int seed = 100 * heap + k - k % (1 + heap % 2);  // in every other heap, all points twice
      curve.add(-2 + size * number(seed), -2 + size * number(seed + 50000), 1, 0);
    }
    for (const auto rule : {NormalRule::color, NormalRule::quadratic, NormalRule::cubic, NormalRule::mass_linear,
                            NormalRule::mass_quadratic}) {
      for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
        const Turned t = turned(curve, setting(rule, scope), 0.6, 0.8);
        for (std::size_t p = 0; p < curve.size(); ++p) {
          EXPECT_NEAR(std::hypot(t.tx[p], t.ty[p]), 1, 1e-12);
          EXPECT_GE(0.6 * t.tx[p] + 0.8 * t.ty[p], 0);
        }
      }
    }
  }
}

// Work space is no memory: another membrane, or the same elsewhere, leaves no trace in the next answer.
TEST(Normals, ForgetWhatTheyWereAskedBefore) {
  const Curve curve = arc_curve(0.5, 0.5, 1.2, 0, 300, 40), other = arc_curve(-0.3, 0.9, 0.7, 20, 200, 31);
  for (const auto rule : {NormalRule::color, NormalRule::quadratic, NormalRule::cubic, NormalRule::mass_linear,
                          NormalRule::mass_quadratic}) {
    for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
      const Setting s = setting(rule, scope);
      auto [tx, ty] = chords(curve);
      auto [again_x, again_y] = chords(curve);
      auto [other_x, other_y] = chords(other);
      turn(curve, s, tx, ty);
      MembraneNormals normals(s.grid, s.walls, s.method, curve.size());
      normals.update(other.places(), other.range(), {}, {other_x, other_y});
      normals.update(curve.places(), curve.range(), {}, {again_x, again_y});
      EXPECT_EQ(tx, again_x);
      EXPECT_EQ(ty, again_y);
    }
  }
}

}  // namespace
}  // namespace tether::mpm
