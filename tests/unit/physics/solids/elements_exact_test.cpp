// SPDX-License-Identifier: GPL-3.0-or-later
// Membranes of elements against exact solutions: rings, tubes and spheres under pressure, a hanging string.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/physics/solids/elements_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;
using std::numbers::pi;

/// Largest force that tension and a pressure inside leave on a point, where the points have been moved from the origin
/// by these factors; the last `but` points aside.
double imbalance(Scene scene, double inside, double scale_x, double scale_y, std::size_t but = 0) {
  scene.ambient = -inside;
  Chain chain(std::move(scene));
  Points& P = chain.points();
  for (std::size_t p = 0; p < P.size(); ++p) P.x[p] *= scale_x, P.y[p] *= scale_y;
  chain.update();
  double most = 0;
  for (std::size_t p = 0; p + but < P.size(); ++p)
    most = std::max({most, std::abs(chain.elements().force(p)[0]), std::abs(chain.elements().force(p)[1])});
  return most;
}

// A ring of the radius r > R under p: sigma t = p r, with t r = t0 R for the thickness, sigma = E' ln(r / R). A polygon
// of n sides bears p = sigma t cos(pi / n) less: second order, and exact with it.
TEST(ThinRing, PressureTimesRadiusIsStressTimesThickness) {
  const double R = 1, r = 1.2, t0 = 0.05;
  const double sigma = both_ways.stress(std::log(r / R)), p = sigma * (t0 * R / r) / r;
  double left[2];
  for (int k = 0; k < 2; ++k) {
    const int n = 20 << k;
    Scene scene = scene_on(BackgroundGrid(21, 21, -2, 2, -2, 2), all_walls(Wall::open), 0.01, robust_set());
    auto points = arc(0, 0, R, R, 0, 2, n, t0);
    for (PointAt& at : points) at.area = t0 * 2 * R * std::sin(pi / n);
    add_body(scene, both_ways, points, 2, 0, true);
    left[k] = imbalance(scene, p, r, r) / (p * 2 * pi * r / n);
    EXPECT_LT(imbalance(scene, p / std::cos(pi / n), r, r), 1e-14);
  }
  EXPECT_LT(left[0], 0.02);
  EXPECT_NEAR(left[0] / left[1], 4, 0.1);
}

// A closed tube about the axis under p, held in length: hoop stress p r / t, t r = t0 R.
TEST(ThinTube, HoopStressIsPressureTimesRadiusOverThickness) {
  const double R = 1, r = 1.2, t0 = 0.05;
  const double sigma = both_ways.stress(0, std::log(r / R)).hoop, p = sigma * (t0 * R / r) / r;
  Scene scene = scene_on(BackgroundGrid(11, 11, 0, 2, 0, 2), all_walls(Wall::symmetry), 0.01, robust_set(),
                         Geometry::axisymmetric);
  add_body(scene, both_ways, line(R, 0, R, 2, 10, t0), 2);
  EXPECT_LT(imbalance(scene, p, r, 1), 1e-13);
  EXPECT_GT(imbalance(scene, 1.01 * p, r, 1), 1e-3);
}

// A sphere of the radius r > R: p r = 2 sigma t, both stresses E eps / (1 - nu), t r^2 = t0 R^2. A polygon's meridian
// bears it to second order. The flat piece around the pole bears a twelfth too little of what its last point has: the
// pressure's volume is a cone's, the membrane's that of its middle radius.
TEST(ThinSphere, StressIsHalfPressureTimesRadiusOverThickness) {
  const double R = 1, r = 1.2, t0 = 0.05, eps = std::log(r / R);
  const MembraneStress stress = both_ways.stress(eps, eps);
  EXPECT_NEAR(stress.tangent, 30 * eps / 0.7, 1e-12);
  const double p = 2 * stress.tangent * t0 * (R * R) / (r * r) / r;
  double left[3];
  for (int k = 0; k < 3; ++k) {
    const int n = 10 << k;
    Scene scene = scene_on(BackgroundGrid(11, 11, 0, 2, 0, 2), all_walls(Wall::symmetry), 0.01, robust_set(),
                           Geometry::axisymmetric);
    scene.walls.left = Wall::axis;
    add_body(scene, both_ways, arc(0, 0, R, R, 0, 0.5, n, t0), 2);
    const double piece = r * (pi / 2 / n), at_pole = 0.5 * piece;
    left[k] = imbalance(scene, p, r, r, 1) / (p * 2 * pi * r * piece);
    EXPECT_LT(imbalance(scene, p, r, r), p * 2 * pi * at_pole * piece / 10);
  }
  EXPECT_LT(left[0], 0.01);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::log2(left[k] / left[k + 1]), 2, 0.1) << left[k];
}

// About the axis a cap's end carries as well: the whole force along the axis is the pressure on the opening.
TEST(ThinSphere, ForceAlongTheAxisIsThePressureOnTheEquator) {
  Scene scene = scene_on(BackgroundGrid(11, 11, 0, 2, 0, 2), all_walls(Wall::symmetry), 0.01, robust_set(),
                         Geometry::axisymmetric);
  add_body(scene, string, arc(0, 0, 1, 1, 0, 0.5, 16, 0.05), 2);
  scene.ambient = 0.6;
  Chain chain(std::move(scene));
  const double equator = chain.points().x[0];
  EXPECT_NEAR(chain.total_force()[1], -0.6 * pi * equator * equator, 1e-13);
}

/// A string that hangs from its first point, with the tension of its weight below: masses of pieces, halves at the
/// ends.
Scene hanging(int n, double length, double gravity, double E) {
  Scene scene = scene_on(BackgroundGrid(13, 17, -1.2, 1.2, -1.6, 1.6), all_walls(Wall::open), 0.002, robust_set());
  const double thickness = 0.02, density = 2;
  add_body(scene, Membrane{E, 0, true}, line(0, 1.2, 0, 1.2 - length, n, thickness, true), density);
  for (int k = 0; k < n; ++k)
    scene.points.syy[static_cast<std::size_t>(k)] = density * gravity * length * (1 - k / (n - 1.0));
  scene.gravity = -gravity;
  scene.pinned = {0};
  return scene;
}

// Tension grows by the weight of every point, and the pin bears all of it but the half piece that is the pin's.
TEST(HangingString, RestsUnderItsOwnTension) {
  const int n = 33;
  const double length = 2, gravity = 9, weight = 0.02 * 2 * length * gravity, E = 5000;
  Scene scene = hanging(n, length, gravity, E);
  const State at_start = start(scene);
  EXPECT_NEAR(at_start.elements_of[0]->force(0)[1], -weight * (n - 1.5) / (n - 1), 1e-13);
  Running run(std::move(scene));
  run.steps(500);
  const auto y = run.field("y"), syy = run.field("syy");
  EXPECT_EQ(y[0], 1.2);
  for (std::size_t k = 0; k < y.size(); ++k) {
    EXPECT_NEAR(y[k], run.scene().points.y[k], 1e-12);
    const double part = 1 - static_cast<double>(k) / (n - 1);
    if (k == 0 || k + 1 == y.size()) continue;  // the ends stand for half a piece
    EXPECT_NEAR(syy[k], 2 * gravity * length * part, 1e-9) << k;
  }
  EXPECT_LT(run.value("energy_kinetic"), 1e-20);
}

/// Time at which the lowest point of a string comes back through the vertical; `cells` to the length .2.
double half_period(int cells, double dt) {
  const double length = 2, gravity = 9, j01 = 2.404825557695773;
  Scene scene = hanging(65, length, gravity, 20000);
  scene.grid = BackgroundGrid(12 * cells + 1, 16 * cells + 1, -1.2, 1.2, -1.6, 1.6);
  scene.clock.tstep = dt;
  for (std::size_t p = 0; p < scene.points.size(); ++p)
    scene.points.vx[p] = 0.05 * std::cyl_bessel_j(0.0, j01 * std::sqrt((scene.points.y[p] + 0.8) / length));
  Running run(std::move(scene));
  double before = 0;
  for (;;) {
    const double t = run.time();
    run.steps(1);
    const double x = run.field("x").back();
    if (x < 0 && t > 0.1) return t + (run.time() - t) * before / (before - x);
    before = x;
  }
}

// Its first swing, J_0(2.405 sqrt(z / L)): period 4 pi / 2.405 sqrt(L / g) of a string that does not stretch; this one
// stretches by .1 %. Measured 1.1 % and .34 % too long, then .09 %.
TEST(HangingString, SwingsInItsFirstMode) {
  const double exact = 2 * pi / 2.404825557695773 * std::sqrt(2 / 9.0);
  const double coarse = half_period(1, 0.0006) / exact - 1, fine = half_period(2, 0.0003) / exact - 1;
  EXPECT_LT(fine, 0.004);
  EXPECT_NEAR(std::log2(coarse / fine), 1.8, 0.3) << coarse << " " << fine;
}

}  // namespace
}  // namespace tether::mpm
