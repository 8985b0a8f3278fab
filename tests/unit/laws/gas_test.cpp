// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/fluids.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tether {
namespace {

IdealGas air() {
  IdealGas gas;
  gas.gm1 = 0.4;
  return gas;
}

TEST(IdealGasTest, PressureOfSodsTwoStates) {  // (4.4), Box 1
  EXPECT_EQ(air().pressure(1, 2.5), 1);
  EXPECT_NEAR(air().pressure(0.125, 2), 0.1, 1e-16);
}

/// c^2 = gamma p / rho = 1.4 for p = rho = 1.
TEST(IdealGasTest, SoundSpeed) {
  EXPECT_NEAR(air().sound_speed_squared(2.5), 1.4, 1e-15);
  EXPECT_EQ(air().sound_speed_squared(0), 0);
  EXPECT_EQ(air().sound_speed_squared(-1), 0);
}

IdealGas with_viscosity(double coef1, double coef2) {
  IdealGas gas = air();
  gas.lambda = 0.5, gas.coef1 = coef1, gas.coef2 = coef2;
  return gas;
}

/// (4.11) with rho = 2, c = 3, g = 1/2, D = -4: linear 1.5 (3)(1/2)(4) = 9, quadratic 1/4 (1/4)(16) = 1.
TEST(ArtificialViscosity, ValueUnderCompression) {
  EXPECT_EQ(with_viscosity(1.5, 0.25).artificial_viscosity(2, 3, 0.5, -4), 10);
  EXPECT_EQ(with_viscosity(1.5, 0).artificial_viscosity(2, 3, 0.5, -4), 9);
  EXPECT_EQ(with_viscosity(0, 0.25).artificial_viscosity(2, 3, 0.5, -4), 1);
  EXPECT_EQ(with_viscosity(0, 0.25).artificial_viscosity(2, 3, 0.5, -8), 4);  // quadratic in D
  EXPECT_EQ(with_viscosity(1.5, 0).artificial_viscosity(2, 3, 0.5, -8), 18);
}

TEST(ArtificialViscosity, IsZeroInExpansionAndAtRest) {
  const IdealGas gas = with_viscosity(1.5, 0.25);
  EXPECT_EQ(gas.artificial_viscosity(2, 3, 0.5, 4), 0);
  EXPECT_EQ(gas.artificial_viscosity(2, 3, 0.5, 0), 0);
  EXPECT_EQ(gas.artificial_viscosity(2, 3, 0.5, std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(air().artificial_viscosity(2, 3, 0.5, -4), 0);  // lambda = 0
}

TEST(GasStress, OfAGasWithoutViscosityIsThePressure) {
  const Stress s = air().stress(7, {4, 1, -2});
  EXPECT_EQ(s.xx, -7);
  EXPECT_EQ(s.yy, -7);
  EXPECT_EQ(s.xy, 0);
}

/// (4.1), mu = 3: 2 mu (4 - 5/3) = 14, 2 mu (1 - 5/3) = -4, and 2 mu (0 - 5/3) = -10 out of the plane.
TEST(GasStress, ViscousPart) {
  IdealGas gas = air();
  gas.mu = 3;
  const Stress s = gas.stress(7, {4, 1, -2});
  EXPECT_NEAR(s.xx, -7 + 14, 1e-14);
  EXPECT_NEAR(s.yy, -7 - 4, 1e-14);
  EXPECT_EQ(s.xy, -12);
}

/// Stokes condition: the mean of the three normal stresses is the pressure. That out of the plane is
/// sigma_zz = -(p + q) - 2 mu tr(eps') / 3 by (4.1), as eps'_zz = 0.
TEST(GasStress, MeanOfTheThreeNormalStressesIsThePressure) {
  IdealGas gas = air();
  gas.mu = 3;
  for (const StrainRate& d : std::vector<StrainRate>{{4, 1, -2}, {-1, -1, 0}, {2, 0, 0}, {0.3, -0.3, 5}}) {
    const Stress s = gas.stress(7, d);
    const double out_of_plane = -7 - 2 * gas.mu * (d.xx + d.yy) / 3;
    EXPECT_NEAR((s.xx + s.yy + out_of_plane) / 3, -7, 1e-14);
  }
}

/// The viscous power 2 mu (eps' : eps' - tr(eps')^2 / 3) is heat, whatever the flow: 6 (25 - 25/3) = 100.
TEST(GasEnergy, ViscousPowerHeats) {
  IdealGas gas = air();
  gas.mu = 3;
  const StrainRate d{4, 1, -2};
  const Stress s = gas.stress(0, d);
  EXPECT_NEAR(power(s, d), 100, 1e-12);
  EXPECT_NEAR(IdealGas::heated(5, 0.01, s, d, 4), 5 + 0.01 * 100 / 4, 1e-14);  // (4.10)
}

TEST(GasEnergy, CompressionHeatsAndExpansionCools) {  // di = -dt p div v / rho
  const Stress s = air().stress(2, {});
  EXPECT_NEAR(IdealGas::heated(5, 0.1, s, {-1, -2, 7}, 4), 5.15, 1e-15);
  EXPECT_NEAR(IdealGas::heated(5, 0.1, s, {1, 2, 7}, 4), 4.85, 1e-15);
}

TEST(GasDensity, Continuity) {  // (4.7)
  EXPECT_EQ(IdealGas::continued_density(3, 0.25, -1), 4);
  EXPECT_EQ(IdealGas::continued_density(3, 0.25, 2), 2);
  EXPECT_EQ(IdealGas::continued_density(3, 0.25, 0), 3);
}

struct GasPoint {
  double rho, i;
};

/// A uniform motion with div v = D, from rho = 1, i = 2.5 over the time T in n steps of (4.4), (4.1), (4.10), (4.7).
GasPoint moved(const IdealGas& gas, double D, double T, int n) {
  GasPoint point{1, 2.5};
  const StrainRate d{0.75 * D, 0.25 * D, 0.3};
  const double dt = T / n;
  for (int k = 0; k < n; ++k) {
    const Stress s = gas.stress(gas.pressure(point.rho, point.i), d);
    point = {IdealGas::continued_density(point.rho, dt, D), IdealGas::heated(point.i, dt, s, d, point.rho)};
  }
  return point;
}

/// Distance from the isentrope, log(p / p0) - gamma log(rho / rho0), after n steps.
double off_isentrope(double D, double T, int n) {
  const GasPoint end = moved(air(), D, T, n);
  return std::log(air().pressure(end.rho, end.i)) - 1.4 * std::log(end.rho);
}

/// With x = D T / n the distance is n (log(1 - gm1 x) + gm1 log(1 + x)) = -gm1 gamma (D T)^2 / (2 n) + O(1/n^2).
TEST(GasPaths, UniformMotionsTendToTheIsentropeWithOrderOne) {
  for (const double D : {-1.0, 1.0}) {
    const double coarse = off_isentrope(D, 1, 200), fine = off_isentrope(D, 1, 400);
    EXPECT_NEAR(std::log2(coarse / fine), 1, 5e-3);
    EXPECT_NEAR(400 * fine, -0.4 * 1.4 / 2, 1e-3);
  }
}

TEST(GasPaths, DensityTendsToTheExponentialOfTheCompression) {  // rho = exp(-D T); e is the exact end
  const double coarse = moved(air(), -1, 1, 200).rho - std::exp(1), fine = moved(air(), -1, 1, 400).rho - std::exp(1);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 5e-3);
  EXPECT_NEAR(fine * 400, std::exp(1) / 2, 5e-3);  // (1 - 1/n)^-n = e (1 + 1/(2 n) + ...)
}

}  // namespace
}  // namespace tether
