// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of revolution by the thesis' method and by the robust set, against exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/physics/points/robust_support.hpp"

namespace tether::mpm {
namespace {

using namespace scenes;
using std::numbers::pi;

enum class Set { thesis, robust };
void PrintTo(Set set, std::ostream* out) { *out << (set == Set::thesis ? "thesis" : "robust"); }

class AboutTheAxis : public testing::TestWithParam<Set> {
 protected:
  static bool robust() { return GetParam() == Set::robust; }
  static Method method() { return robust() ? robust_set() : Method{}; }
  static IdealGas gas() { return robust() ? robust_gas() : IdealGas{.rule = DensityRule::continuity}; }
  /// From the axis to an open edge, between slip walls below and above unless said otherwise.
  static Scene scene(const BackgroundGrid& grid, double dt, const Walls& walls,
                     Geometry geometry = Geometry::axisymmetric) {
    return scene_on(grid, walls, dt, method(), geometry);
  }
};
INSTANTIATE_TEST_SUITE_P(Sets, AboutTheAxis, testing::Values(Set::thesis, Set::robust));

constexpr Walls open_around{Wall::axis, Wall::open, Wall::open, Wall::open};
constexpr Walls closed_about_the_axis{Wall::axis, Wall::free_slip, Wall::free_slip, Wall::free_slip};

TEST_P(AboutTheAxis, ATranslationAlongItIsExactAndFreeOfStress) {
  Scene free = scene(BackgroundGrid(11, 21, 0, 1, -1, 1), 0.01, open_around);
  add_body(free, plane_strain(3, 0.3), lattice(0.05, 0, 0.5, -0.5, 0.1), 1.3);
  set_velocities(free, [](double, double) { return Vec<2>{0, 0.3}; });
  Running run(std::move(free));
  run.steps(150);
  const auto x = run.field("x"), y = run.field("y"), szz = run.field("szz"), sxx = run.field("sxx");
  for (std::size_t p = 0; p < x.size(); ++p) {
    EXPECT_NEAR(x[p], run.scene().points.x[p], 1e-14);
    EXPECT_NEAR(y[p], run.scene().points.y[p] + 0.3 * run.time(), 1e-14);
    EXPECT_NEAR(sxx[p], 0, 1e-14);
    EXPECT_NEAR(szz[p], 0, 1e-14);
  }
}

// v = (a r, b z) strains every point by a, b and about the axis a, a step: what is written is that, not the plane's.
TEST_P(AboutTheAxis, WrittenStrainsAreThoseOfTheMotion) {
  constexpr double a = 1e-3, b = -4e-4, dt = 0.001;
  Scene free = scene(BackgroundGrid(11, 21, 0, 1, -1, 1), dt, open_around);
  const PlaneElastic law = plane_strain(3, 0.3);
  add_body(free, law, lattice(0.1 / 3, 0, 0.8, -0.8, 0.8), 1.3);
  set_velocities(free, [=](double x, double y) { return Vec<2>{a * x, b * y}; });
  Running run(std::move(free));
  run.steps(1);
  const auto xx = run.field("strain_xx"), yy = run.field("strain_yy"), pressure = run.field("pressure");
  const double bulk = 3 / (3 * (1 - 2 * 0.3));
  std::size_t judged = 0;
  for (std::size_t p = 0; p < xx.size(); ++p) {
    const double r = run.scene().points.x[p], z = run.scene().points.y[p];
    if (r < 0.25 || r > 0.55 || std::abs(z) > 0.55) continue;  // where no edge has reached
    ++judged;
    EXPECT_NEAR(xx[p], a * dt, 0.05 * a * dt);
    EXPECT_NEAR(yy[p], b * dt, 0.05 * a * dt);
    EXPECT_NEAR(pressure[p], -bulk * (2 * a + b) * dt, 0.1 * bulk * a * dt);
  }
  EXPECT_GT(judged, 100U);
}

// The thesis' sums balance an even gas exactly (in the long run without viscosity they amplify rounding). With splines
// this holds for three points a cell's side; with two the axis pushes by .002 of the sound speed and no more (.003 in
// the first step, .0003 after 200), and there the nodes' gas is denser than it is by 2.7 % (1.3 % with three) on grids
// however fine: int N 2 pi r dr against its sum over points.
TEST_P(AboutTheAxis, AnEvenGasInACylinderRests) {
  for (const int per_side : {2, 3}) {
    Scene full = scene(BackgroundGrid(9, 9, 0, 1, 0, 1), 0.025, closed_about_the_axis);
    add_body(full, gas(), lattice(0.125 / per_side, 0, 1, 0, 1), 1.3, 2);
    Running run(std::move(full));
    const bool exact = !robust() || per_side == 3;
    for (const int steps : {1, 29}) {
      run.steps(steps);
      double fastest = 0;
      for (const double v : run.field("vx")) fastest = std::max(fastest, std::abs(v));
      EXPECT_LT(fastest, exact ? 1e-12 : 0.004) << per_side;
    }
    for (const double rho : run.field("density")) {
      EXPECT_GT(rho, 1.3 * (robust() ? 0.99 : 1 - 1e-12));
      EXPECT_LT(rho, 1.3 * (robust() ? 1.03 : 1 + 1e-12));
    }
  }
}

/// What became of the density and the energy of cold gas that falls on its centre, against the exact ones: worst of all
/// points beyond the axis' nodes and within what edges have not reached.
struct Collapse {
  double density = 0, energy = 0, density_spread = 0;
  double density_outside = 0;  // of points that began at r > .25, whatever the cells
};

Collapse collapse(Scene scene, const IdealGas& gas, double h) {
  scene.method.ledger = false;  // what the first transfer loses would heat gas this cold
  add_body(scene, gas, lattice(h / 3, 0, 1, -1, 1), 1, 1e-4);
  set_velocities(scene, [](double x, double y) { return Vec<2>{-x, -y}; });
  Running run(std::move(scene));
  run.until(0.2);
  const double rho = 1 / std::pow(1 - run.time(), 3), energy = 1e-4 * std::pow(rho, 0.4);
  const auto density = run.field("density"), specific_energy = run.field("specific_energy");
  Collapse worst;
  double least = 1e300, most = 0;
  for (std::size_t p = 0; p < density.size(); ++p) {
    const double r = run.scene().points.x[p];
    if (r < 2 * h || r > 0.6 || std::abs(run.scene().points.y[p]) > 0.6) continue;
    worst.density = std::max(worst.density, std::abs(density[p] / rho - 1));
    if (r > 0.25) worst.density_outside = std::max(worst.density_outside, std::abs(density[p] / rho - 1));
    worst.energy = std::max(worst.energy, std::abs(specific_energy[p] / energy - 1));
    least = std::min(least, density[p]), most = std::max(most, density[p]);
  }
  worst.density_spread = (most - least) / rho;
  return worst;
}

// Velocity -(r, z): it stays linear, every point flies freely, density grows as (1 - t)^-3 and stays even, energy
// follows the adiabat. First order in the step, which goes with the cells. The robust method writes the density of the
// place where a point stands, without an error of the step. By cells from the axis its error is the same on all grids:
// a point's gradient is that of the step's beginning, which the mean over rings, h^2 / (4 r) off the node, makes a
// velocity of. So it falls with the cells at each radius.
TEST_P(AboutTheAxis, UniformCompressionStaysUniform) {
  Collapse at[2];
  for (int k = 0; k < 2; ++k) {
    const int cells = 8 << k;
    IdealGas law = gas();
    law.lambda = 0;
    at[k] =
        collapse(scene(BackgroundGrid(3 * cells / 2 + 1, 3 * cells + 1, 0, 1.5, -1.5, 1.5), 0.08 / cells, open_around),
                 law, 1.0 / cells);
  }
  EXPECT_LT(at[1].density, 0.03);
  EXPECT_LT(at[1].energy, 0.02);
  EXPECT_LT(at[1].density_spread, 0.02);
  const double ratio = at[0].density_outside / at[1].density_outside;
  if (robust()) {
    EXPECT_LT(at[0].density, 0.004);  // .0146 and .0151 where points begin without the gradients of their velocities
    EXPECT_LT(at[1].density, 0.004);
    EXPECT_GT(ratio, 1.9);
  } else {
    EXPECT_NEAR(ratio, 2, 0.6);
  }
}

/// Largest error of a column's displacement at half its period, against the top's.
double column_error(Scene scene, int cells, const PlaneElastic& law) {
  const double modulus = law.lambda + 2 * law.G;
  add_body(scene, law, lattice(0.5 / cells, 0, 0.25, 0, 1), 1);
  scene.gravity = -0.01;
  Running run(std::move(scene));
  run.until(2 / std::sqrt(modulus));
  const auto y = run.field("y");
  double worst = 0;
  for (std::size_t p = 0; p < y.size(); ++p) {
    const double at = run.scene().points.y[p], rest = 0.01 * (at - at * at / 2) / modulus;
    worst = std::max(worst, std::abs(at - y[p] - 2 * rest) / (0.01 / modulus));
  }
  return worst;
}

// A column that gravity finds unstrained falls to twice its hydrostatic displacement, g (y - y^2/2) rho / M, at half
// its period, t = 2 L / c; in a cylinder as in the plane.
TEST_P(AboutTheAxis, AColumnFallsToTwiceItsHydrostaticRest) {
  const PlaneElastic law = plane_strain(100, 0.3);
  const double c = std::sqrt(law.lambda + 2 * law.G);
  double error[2];
  for (int k = 0; k < 2; ++k) {
    const int cells = 16 << k;
    const BackgroundGrid grid(cells / 4 + 1, 5 * cells / 4 + 1, 0, 0.25, 0, 1.25);
    Walls walls = closed_about_the_axis;
    walls.top = Wall::open;
    error[k] = column_error(scene(grid, 0.4 / cells / c, walls), cells, law);
    walls.left = Wall::free_slip;
    const double plane = column_error(scene(grid, 0.4 / cells / c, walls, Geometry::plane), cells, law);
    EXPECT_NEAR(error[k], plane, robust() ? 1e-3 : 1e-10);
  }
  EXPECT_LT(error[1], 0.01);
  EXPECT_GT(error[0] / error[1], 1.5);
}

/// A solid cylinder, held in length, that vibrates in its first radial mode.
struct Vibration {
  double period_error = 0, energy_drift = 0;
};

// x J_0(x) = (1 - 2 nu) / (1 - nu) J_1(x), x = omega R / c of pressure waves: nu = .3.
constexpr double first_root = 2.125748927810746;

Vibration vibration(Scene scene, int cells, const PlaneElastic& law) {
  const double h = 1.0 / cells, exact = 2 * pi / (first_root * std::sqrt(law.lambda + 2 * law.G));
  const auto mode = [](double r) { return std::cyl_bessel_j(1.0, first_root * r); };
  add_body(scene, law, lattice(h / 2, 0, 1, 0, 2 * h), 1);
  set_velocities(scene, [&](double x, double) { return Vec<2>{1e-3 * mode(x), 0}; });
  Running run(std::move(scene));
  const double energy = run.value("energy_total");
  const PointSet& P = run.scene().points;
  std::vector<double> zeros;
  for (double before = 1; zeros.size() < 4;) {
    const double t = run.time();
    run.steps(1);
    const auto v = run.field("vx");
    double now = 0;
    for (std::size_t p = 0; p < v.size(); ++p) now += P.mass[p] * v[p] * mode(P.x[p]);
    if (now * before < 0) zeros.push_back(t + (run.time() - t) * before / (before - now));
    before = now;
  }
  return {(zeros[3] - zeros[0]) / (1.5 * exact) - 1, run.value("energy_total") / energy - 1};
}

// Period and energy, both of second order (measured on 16 and 32 cells: thesis 1.5e-4, 3.7e-5 of the period, robust
// 2.9e-4, 7.1e-5).
TEST_P(AboutTheAxis, ACylinderVibratesAtItsExactFrequency) {
  const PlaneElastic law = plane_strain(1, 0.3);
  Vibration found[2];
  for (int k = 0; k < 2; ++k) {
    const int cells = 16 << k;
    const double h = 1.0 / cells;
    found[k] = vibration(
        scene(BackgroundGrid(5 * cells / 4 + 1, 3, 0, 1.25, 0, 2 * h), 0.3 * h / std::sqrt(law.lambda + 2 * law.G),
              {Wall::axis, Wall::open, Wall::free_slip, Wall::free_slip}),
        cells, law);
  }
  EXPECT_LT(std::abs(found[1].period_error), 1e-4);
  EXPECT_NEAR(std::log2(found[0].period_error / found[1].period_error), 2, 0.15);
  EXPECT_LT(std::abs(found[0].energy_drift), 0.002);
  EXPECT_LT(std::abs(found[1].energy_drift), 0.0004);
}

}  // namespace
}  // namespace tether::mpm
