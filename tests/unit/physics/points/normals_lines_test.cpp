// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "unit/physics/points/normals_support.hpp"

// The mass matrix method on lines and on the thesis' hyperbola (Figs. 76, 77, 78, 80). What a run begins with are
// chords, and these are exact on a line: so the tests begin with tangents that are 20 degrees off.

namespace tether::mpm {
namespace {

using namespace curves;

const std::vector<std::pair<NormalRule, MatrixScope>> matrices{{NormalRule::mass_linear, MatrixScope::cell},
                                                               {NormalRule::mass_quadratic, MatrixScope::cell},
                                                               {NormalRule::mass_linear, MatrixScope::membrane},
                                                               {NormalRule::mass_quadratic, MatrixScope::membrane}};

std::vector<double> errors_from_afar(const Curve& curve, const Setting& s) {
  std::vector<double> tx, ty;
  const double c = std::cos(20 * degree), si = std::sin(20 * degree);
  for (std::size_t p = 0; p < curve.size(); ++p) {
    tx.push_back(c * curve.tx[p] - si * curve.ty[p]), ty.push_back(si * curve.tx[p] + c * curve.ty[p]);
  }
  turn(curve, s, tx, ty);
  return angles(curve, tx, ty);
}

TEST(MassMatrixLines, At45DegreesIsExact) {
  const Curve curve = line_curve(0.5, 0.5, 45, {-0.5, -0.3, -0.1, 0.1, 0.3, 0.5});
  for (const auto& [rule, scope] : matrices) {
    EXPECT_LT(largest(errors_from_afar(curve, setting(rule, scope))), 1e-10);
  }
}

TEST(MassMatrixLines, At80DegreesUnevenlySpacedIsExact) {
  const Curve curve = line_curve(0.45, 0.5, 80, {-0.42, -0.35, -0.1, 0.02, 0.2, 0.41});
  for (const auto& [rule, scope] : matrices) {
    EXPECT_LT(largest(errors_from_afar(curve, setting(rule, scope))), 1e-9);  // the thesis: .01
  }
}

// Two points of a cell are a line, too. Through many cells, of two points and of more; cells that are not square.
TEST(MassMatrixLines, AtAnyAngleIsExact) {
  for (const auto& [rule, scope] : matrices) {
    Setting s = setting(rule, scope);
    s.grid = BackgroundGrid(21, 41, -4, 4, -4, 4);
    for (double angle = 0; angle < 360; angle += 7.5) {
      std::vector<double> distances;
      for (int k = 0; k < 40; ++k) distances.push_back(-2 + 0.1 * k + 0.03 * std::sin(5.0 * k));
      const Curve curve = line_curve(0.137, 0.291, angle, distances);
      EXPECT_LT(largest(errors_from_afar(curve, s)), 1e-7) << angle;
    }
  }
}

// Fig. 78. With C below 0 the curve crosses the unit cell; the first and last point stand on its sides or near them.
TEST(MassMatrixLines, TheHyperbolaHasItsNormalsToTheFifthPlace) {
  for (const double C : {-0.2, -0.3, -0.4, -0.55}) {
    Curve curve;
    const double from = std::max(0.02, -C / 1.1), to = 0.98;
    for (int k = 0; k < 6; ++k) {
      const double x = from + (to - from) * k / 5, y = -C / x - 0.1;
      curve.add(x, y, x, -(y + 0.1));  // across the gradient (y + .1, x)
    }
    auto [tx, ty] = chords(curve);
    turn(curve, setting(NormalRule::mass_linear), tx, ty);
    for (std::size_t p = 0; p < curve.size(); ++p) {
      EXPECT_NEAR(tx[p], curve.tx[p], 1e-5) << C;
      EXPECT_NEAR(ty[p], curve.ty[p], 1e-5) << C;
    }
  }
}

/// The plain 4 x 4 system (7.12): the smallest pivot of its elimination with pivoting, and the gradients of its
/// colours.
struct Plain {
  double smallest_pivot = 1e300;
  std::vector<Pair> gradients;
};

Plain plain_solution(const Curve& curve, LocalPlace extra) {
  std::array<std::array<double, 5>, 4> T{};
  const auto add = [&](LocalPlace at, double color) {
    const auto N = LinearColor::weights(at);
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) T[a][b] += N[a] * N[b];
      T[a][4] += N[a] * color;
    }
  };
  for (std::size_t p = 0; p < curve.size(); ++p) add({curve.x[p], curve.y[p]}, 1);
  add(extra, 0);
  Plain plain;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t a = k + 1; a < 4; ++a) {
      if (std::abs(T[a][k]) > std::abs(T[k][k])) std::swap(T[a], T[k]);
    }
    plain.smallest_pivot = std::min(plain.smallest_pivot, std::abs(T[k][k]));
    for (std::size_t a = 0; a < 4; ++a) {
      const double factor = T[a][k] / T[k][k];
      for (std::size_t b = 0; b < 5 && a != k; ++b) T[a][b] -= factor * T[k][b];
    }
  }
  const std::array<double, 4> colors{T[0][4] / T[0][0], T[1][4] / T[1][1], T[2][4] / T[2][2], T[3][4] / T[3][3]};
  for (std::size_t p = 0; p < curve.size(); ++p) {
    plain.gradients.push_back(color_gradient<LinearColor>(colors, {curve.x[p], curve.y[p]}));
  }
  return plain;
}

// Fig. 80 (a): the matrix of points above each other is singular. The fit is the line all the same.
TEST(MassMatrixLines, AVerticalLineIsExactThoughTheMatrixIsSingular) {
  for (const double x : {0.3, 0.5, 0.999}) {
    const Curve curve = line_curve(x, 0.5, 90, {-0.4, -0.2, 0.05, 0.2, 0.45});
    EXPECT_LT(plain_solution(curve, {0.05, 0.1}).smallest_pivot, 1e-14);
    for (const auto& [rule, scope] : matrices) {
      EXPECT_LT(largest(errors_from_afar(curve, setting(rule, scope))), 1e-10);
    }
  }
}

// Fig. 80 (b): three points not quite above each other. The only colours that fit are a saddle, whose gradient at the
// middle point lies along the membrane, however little the point is off. The line through them is what is meant.
TEST(MassMatrixLines, ASaddleThroughPointsNearlyInALineIsRefused) {
  for (const double off : {1e-4, 1e-3, 1e-2}) {
    Curve curve = line_curve(0.3, 0.5, 90, {-0.3, 0, 0.3});
    curve.x[1] += off;
    const Plain plain = plain_solution(curve, {0.9, 0.1});
    EXPECT_GT(plain.smallest_pivot, 1e-12);
    EXPECT_GT(std::abs(plain.gradients[1][1]), 5 * std::abs(plain.gradients[1][0]));
    const double slope = std::atan(off / 0.3) / degree;
    for (const auto& [rule, scope] : matrices) {
      EXPECT_LT(largest(errors_from_afar(curve, setting(rule, scope))), 2.1 * slope);  // a parabola's at its ends: 2
    }
  }
}

// With more points there are saddles for quadratic functions, too, in both scopes.
TEST(MassMatrixLines, ASaddleOfQuadraticFunctionsIsRefusedToo) {
  Curve curve = line_curve(0.3, 0.5, 90, {-0.4, -0.2, 0, 0.2, 0.4});
  curve.x[2] += 0.01;
  for (const auto& [rule, scope] : matrices) EXPECT_LT(largest(errors_from_afar(curve, setting(rule, scope))), 2);
}

}  // namespace
}  // namespace tether::mpm
