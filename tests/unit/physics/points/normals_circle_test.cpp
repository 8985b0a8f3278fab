// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "unit/physics/points/normals_support.hpp"

// The thesis' model problem (Figs. 66 to 72): a circle of radius 1 in cells of .1, all round or a quarter between
// mirrors, with vacuum inside, or 4 or 16 points of fluid a cell.

namespace tether::mpm {
namespace {

using namespace curves;

constexpr int quarter_points = 40;  // of the membrane

/// The circle and the fluid in it, so many points a cell's side.
Curve filled_circle(bool whole, int per_side) {
  Curve curve = arc_curve(0, 0, 1, 0, whole ? 360 : 90, whole ? 4 * quarter_points : quarter_points);
  const double h = 0.1 / per_side;
  for (int b = whole ? -15 * per_side : 0; b < 15 * per_side; ++b) {
    for (int a = whole ? -15 * per_side : 0; a < 15 * per_side; ++a) {
      const double x = (a + 0.5) * h, y = (b + 0.5) * h;
      if (x * x + y * y < 1) curve.x.push_back(x), curve.y.push_back(y);
    }
  }
  return curve;
}

Setting around_circle(bool whole, NormalRule rule, MatrixScope scope = MatrixScope::cell) {
  Setting s = setting(rule, scope);
  s.grid = whole ? BackgroundGrid(31, 31, -1.5, 1.5, -1.5, 1.5) : BackgroundGrid(16, 16, 0, 1.5, 0, 1.5);
  if (!whole) s.walls = {Wall::symmetry, Wall::open, Wall::axis, Wall::open};
  return s;
}

double circle_rms(NormalRule rule, int per_side, MatrixScope scope = MatrixScope::cell) {
  return rms(errors(filled_circle(false, per_side), around_circle(false, rule, scope)));
}

// Figs. 67 (a), 68 (a), 70 (a): in vacuum the colour has a ridge on the membrane, and the gradient there is noise. The
// cubic method is worse than the quadratic one.
TEST(CircleNormals, ColorsAreNoUseInVacuum) {
  EXPECT_GT(circle_rms(NormalRule::color, 0), 20);
  EXPECT_GT(circle_rms(NormalRule::quadratic, 0), 20);
  EXPECT_GT(circle_rms(NormalRule::cubic, 0), 1.2 * circle_rms(NormalRule::quadratic, 0));
}

// Figs. 67 (b), 68 (b), 69, 70 (b), 71: fluid helps, more fluid helps more, and smoother kernels are better.
TEST(CircleNormals, ColorsWithFluidRankAsInTheThesis) {
  const double color[] = {circle_rms(NormalRule::color, 2), circle_rms(NormalRule::color, 4)};
  const double quadratic[] = {circle_rms(NormalRule::quadratic, 2), circle_rms(NormalRule::quadratic, 4)};
  const double cubic[] = {circle_rms(NormalRule::cubic, 2), circle_rms(NormalRule::cubic, 4)};
  for (const int k : {0, 1}) {
    EXPECT_LT(cubic[k], quadratic[k]);
    EXPECT_LT(quadratic[k], color[k]);
  }
  EXPECT_LT(color[1], 0.6 * color[0]);
  EXPECT_LT(quadratic[1], 0.6 * quadratic[0]);
  EXPECT_LT(cubic[1], 0.6 * cubic[0]);
  EXPECT_LT(cubic[1], 1.1);
}

// Fig. 72: the mass matrix method is as good as connectivity, and asks for no fluid: with it nothing changes.
TEST(CircleNormals, TheMassMatrixIsBestWithoutFluid) {
  const Curve curve = filled_circle(false, 4);
  const auto [tx, ty] = chords(curve);
  const double connectivity = rms(angles(curve, tx, ty));
  EXPECT_LT(connectivity, 0.3);
  for (const auto rule : {NormalRule::mass_linear, NormalRule::mass_quadratic}) {
    EXPECT_LT(circle_rms(rule, 0), 0.7);
    EXPECT_EQ(circle_rms(rule, 0), circle_rms(rule, 4));
    EXPECT_LT(circle_rms(rule, 0), circle_rms(NormalRule::cubic, 4));
  }
  EXPECT_LT(circle_rms(NormalRule::mass_linear, 0, MatrixScope::membrane), 1.4);
  EXPECT_LT(circle_rms(NormalRule::mass_quadratic, 0, MatrixScope::membrane), connectivity);
}

// What a mirror shows counts as if it were there. The fits of cells do not look behind the wall.
TEST(CircleNormals, AQuarterBetweenMirrorsIsAQuarterOfTheWhole) {
  for (const auto rule : {NormalRule::color, NormalRule::quadratic, NormalRule::cubic, NormalRule::mass_linear,
                          NormalRule::mass_quadratic}) {
    for (const int per_side : {0, 2}) {
      const auto quarter = errors(filled_circle(false, per_side), around_circle(false, rule));
      const auto whole = errors(filled_circle(true, per_side), around_circle(true, rule));
      for (std::size_t p = 0; p < quarter.size(); ++p) EXPECT_NEAR(quarter[p], whole[p], 1e-7);
    }
  }
}

}  // namespace
}  // namespace tether::mpm
