// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "physics/points/normals_cells.hpp"
#include "unit/physics/points/normals_support.hpp"

// Circular arcs of radius .4 in a unit cell (Figs. 79, 82 to 85), and circles on ever finer cells.

namespace tether::mpm {
namespace {

using namespace curves;

/// An arc of radius .4 that looks in a direction, its points' middle in the cell's.
Curve arc_in_cell(double towards, double span, int count) {
  Curve curve = arc_curve(0, 0, 0.4, towards - span / 2, towards + span / 2, count);
  double mean_x = 0, mean_y = 0;
  for (int k = 0; k < count; ++k) mean_x += curve.x[k] / count, mean_y += curve.y[k] / count;
  for (int k = 0; k < count; ++k) curve.x[k] += 0.5 - mean_x, curve.y[k] += 0.5 - mean_y;
  return curve;
}

// Fig. 79: with linear shape functions an arc is some degrees off, where its chord lies at 45 degrees to the cell.
TEST(MassMatrixArcs, LinearIsOffSomeDegrees) {
  const auto of = errors(arc_in_cell(45, 90, 6), setting(NormalRule::mass_linear));
  EXPECT_LT(rms(of), 4);
  EXPECT_LT(largest(of), 6);
  EXPECT_GT(largest(of), 4);
}

// Fig. 84: where points of the arc have the same y, their normals' x components cannot differ in sign. All that is left
// then is the chord, half the arc off at its ends.
TEST(MassMatrixArcs, LinearIsAsFarOffAsTheChordWhereTheArcLooksAlongAnAxis) {
  for (const double towards : {0.0, 90.0, 180.0, 270.0}) {
    const auto of = errors(arc_in_cell(towards, 90, 6), setting(NormalRule::mass_linear));
    EXPECT_NEAR(largest(of), 37.5, 0.1);
  }
}

// Fig. 82, (7.17): the x component of a gradient of linear shape functions depends on y alone. Points 0 and 4 of this
// arc have the same y.
TEST(MassMatrixArcs, LinearGradientsOfPointsWithOneYHaveOneXComponent) {
  const Curve curve = arc_in_cell(90, 100, 5);
  std::array<LocalPlace, 5> places;
  for (std::size_t p = 0; p < 5; ++p) places[p] = {curve.x[p], curve.y[p]};
  std::array<Pair, 5> linear, quadratic;
  fit_gradients<LinearColor>(places, {0.5, 0.25}, linear);
  fit_gradients<QuadraticColor>(places, {0.5, 0.25}, quadratic);
  EXPECT_NEAR(linear[0][0], linear[4][0], 1e-12);
  EXPECT_GT(std::abs(quadratic[0][0] - quadratic[4][0]), 1);
}

// Fig. 85: quadratic functions follow the arc whichever way it looks.
TEST(MassMatrixArcs, QuadraticIsBelowOneDegree) {
  for (const auto scope : {MatrixScope::cell, MatrixScope::membrane}) {
    for (const double span : {60.0, 90.0, 120.0}) {
      for (const int count : {5, 7, 9}) {
        for (double towards = 0; towards < 360; towards += 15) {
          const auto of = errors(arc_in_cell(towards, span, count), setting(NormalRule::mass_quadratic, scope));
          EXPECT_LT(rms(of), 1) << span << ' ' << count << ' ' << towards;
        }
      }
    }
  }
}

/// Mean square error on circles of a radius in cells, with so many points a cell's side, at places all over a cell.
double on_circles(double radius, double per_side, const Setting& s, double scatter = 0) {
  double sum = 0;
  const int places = 8;
  for (int k = 0; k < places; ++k) {
    const int count = static_cast<int>(2 * std::numbers::pi * radius * per_side);
    Curve curve = arc_curve(0.137 * k, 0.291 * k, radius, 0, 360, count);
    for (std::size_t p = 0; p < curve.size(); ++p) curve.x[p] += scatter * std::sin(1e4 * (p + 0.1 * k));
    sum += std::pow(rms(errors(curve, s)), 2) / places;
  }
  return std::sqrt(sum);
}

Setting on_wide_grid(NormalRule rule, MatrixScope scope) {
  Setting s = setting(rule, scope);
  s.grid = BackgroundGrid(61, 61, -30, 30, -30, 30);
  return s;
}

/// Order of convergence as the cells become finer on a circle.
double order(NormalRule rule, MatrixScope scope) {
  const Setting s = on_wide_grid(rule, scope);
  return std::log2(on_circles(6, 4, s) / on_circles(24, 4, s)) / 2;
}

// A bilinear colour has no curvature of its own, the chord of a cell's last two points none at all: first order. A cell
// of many points is better with quadratic functions, and best is the matrix of the whole membrane with them.
TEST(MassMatrixArcs, ErrorsOnACircleOfTenCellsAndOrders) {
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_linear, MatrixScope::cell)), 0.5);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_quadratic, MatrixScope::cell)), 0.25);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_linear, MatrixScope::membrane)), 1.4);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_quadratic, MatrixScope::membrane)), 0.06);
  EXPECT_GT(order(NormalRule::mass_linear, MatrixScope::cell), 0.9);
  EXPECT_GT(order(NormalRule::mass_quadratic, MatrixScope::cell), 0.9);
  EXPECT_GT(order(NormalRule::mass_linear, MatrixScope::membrane), 0.9);
  EXPECT_GT(order(NormalRule::mass_quadratic, MatrixScope::membrane), 0.9);
}

// Points that are a thousandth of a cell off the circle turn chords of neighbours, a quarter of a cell apart, by some
// tenths of a degree; the fits must not make more of it.
TEST(MassMatrixArcs, ScatterOfThePointsIsNotBlownUp) {
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_linear, MatrixScope::cell), 1e-3), 0.6);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_quadratic, MatrixScope::cell), 1e-3), 0.6);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_quadratic, MatrixScope::membrane), 1e-3), 0.1);
  EXPECT_LT(on_circles(10, 4, on_wide_grid(NormalRule::mass_quadratic, MatrixScope::membrane), 1e-2), 0.8);
}

}  // namespace
}  // namespace tether::mpm
