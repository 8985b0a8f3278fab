// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/elastic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tether {
namespace {

constexpr double stiffness = 1e6;
const Membrane one_way{stiffness, 0.3, true}, two_way{stiffness, 0.3, false};

TEST(MembraneTest, TensionHasYoungsModulus) {  // (5.5), whatever Poisson's ratio
  EXPECT_EQ(one_way.stress(0.125), 125000);
  EXPECT_EQ(two_way.stress(0.125), 125000);
}

TEST(MembraneTest, AOneWayStringCarriesNoCompression) {
  EXPECT_EQ(one_way.stress(-0.125), 0);
  EXPECT_EQ(one_way.stress(-1e-300), 0);
  EXPECT_GT(one_way.stress(1e-300), 0);
  EXPECT_EQ(one_way.energy_density(-0.125), 0);
  EXPECT_EQ(two_way.stress(-0.125), -125000);
  EXPECT_EQ(two_way.energy_density(-0.125), 7812.5);
}

TEST(MembraneTest, NothingAtZeroStrain) {
  EXPECT_EQ(one_way.stress(0), 0);
  EXPECT_EQ(one_way.energy_density(0), 0);
}

/// The energy is quadratic in the strain, so a central difference has no error but rounding.
TEST(MembraneTest, StressIsTheDerivativeOfTheEnergy) {
  const double h = 1e-3;
  for (const double strain : {0.01, 0.1, 0.7}) {
    EXPECT_NEAR((one_way.energy_density(strain + h) - one_way.energy_density(strain - h)) / (2 * h),
                one_way.stress(strain), 1e-7);
  }
  EXPECT_NEAR((two_way.energy_density(-0.1 + h) - two_way.energy_density(-0.1 - h)) / (2 * h), -1e5, 1e-7);
}

/// An initial stress of -1e5 stands for the strain -0.1 of Box 5: slack, until that much was pulled out.
TEST(MembraneTest, SlackIsTakenUpBeforeItPulls) {
  EXPECT_EQ(one_way.stress(-0.1 + 0.0625), 0);
  EXPECT_NEAR(one_way.stress(-0.1 + 0.125), 0.025 * stiffness, 1e-9);
}

TEST(MembraneTest, SoundSpeed) { EXPECT_EQ((Membrane{4, 0, true}.sound_speed(0.25)), 4); }

// Plane stress: tangent and hoop carry together.

using std::numbers::pi;

Membrane sheet(double nu, bool wrinkle = true) { return {stiffness, nu, wrinkle, Membrane::Kind::plane_stress}; }

TEST(PlaneStressMembrane, InThePlaneTheHoopIsHeld) {  // (5.12)-(5.15): eps_2' = 0
  EXPECT_NEAR(sheet(0.3).stress(0.01), stiffness * 0.01 / 0.91, 1e-9);
  EXPECT_NEAR(sheet(0.3).stress(0.01, 0).hoop, 0.3 * stiffness * 0.01 / 0.91, 1e-9);
  EXPECT_NEAR(sheet(0.3).energy_density(0.01), 0.5 * stiffness * 1e-4 / 0.91, 1e-9);
  EXPECT_EQ(sheet(0.3).stress(-0.01), 0);
  EXPECT_NEAR(sheet(0.3, false).stress(-0.01), -stiffness * 0.01 / 0.91, 1e-9);
}

TEST(PlaneStressMembrane, ASphereStretchesAlikeBothWays) {  // sigma = E eps / (1 - nu)
  const MembraneStress s = sheet(0.3).stress(0.01, 0.01);
  EXPECT_NEAR(s.tangent, stiffness * 0.01 / 0.7, 1e-9);
  EXPECT_NEAR(s.hoop, stiffness * 0.01 / 0.7, 1e-9);
  EXPECT_NEAR(sheet(0.3).energy_density(0.01, 0.01), stiffness * 1e-4 / 0.7, 1e-9);
}

TEST(PlaneStressMembrane, FreeToContractItIsUniaxial) {  // eps_2' = -nu eps_1': sigma_1' = E eps_1', sigma_2' = 0
  const MembraneStress s = sheet(0.3, false).stress(0.01, -0.003);
  EXPECT_NEAR(s.tangent, stiffness * 0.01, 1e-9);
  EXPECT_NEAR(s.hoop, 0, 1e-9);
}

TEST(PlaneStressMembrane, AWrinkledDirectionCarriesNothingAndTheOtherAlone) {
  const MembraneStress along = sheet(0.3).stress(0.01, -0.5), round = sheet(0.3).stress(-0.5, 0.01);
  EXPECT_EQ(along.tangent, stiffness * 0.01);
  EXPECT_EQ(along.hoop, 0);
  EXPECT_EQ(round.tangent, 0);
  EXPECT_EQ(round.hoop, stiffness * 0.01);
  EXPECT_NEAR(sheet(0.3).energy_density(0.01, -0.5), 0.5 * stiffness * 1e-4, 1e-9);
  for (const double hoop : {-0.2, -0.01, 0.0}) {
    EXPECT_EQ(sheet(0.3).stress(-0.01, hoop).tangent, 0);
    EXPECT_EQ(sheet(0.3).stress(-0.01, hoop).hoop, 0);
    EXPECT_EQ(sheet(0.3).energy_density(-0.01, hoop), 0);
  }
}

TEST(PlaneStressMembrane, OfTheUniaxialLawTheHoopIsNothing) {
  for (const double hoop : {-0.2, 0.0, 0.2}) {
    EXPECT_EQ(one_way.stress(0.125, hoop).tangent, 125000);
    EXPECT_EQ(one_way.stress(0.125, hoop).hoop, 0);
    EXPECT_EQ(one_way.energy_density(0.125, hoop), 7812.5);
  }
}

class SheetOfPoisson : public testing::TestWithParam<double> {};

/// Strains of .1 in every direction, half a degree beside the borders that could stand at whole ones; within a region
/// the energy is quadratic, so that central differences have no error but rounding.
TEST_P(SheetOfPoisson, StressIsTheDerivativeOfTheEnergyInBothStrains) {
  const double h = 1e-5, tolerance = 1e-10 * stiffness;
  int taut = 0, wrinkled = 0, slack = 0;
  for (const bool wrinkle : {true, false}) {
    const Membrane law = sheet(GetParam(), wrinkle);
    for (int degree = 0; degree < 360; ++degree) {
      const double t = 0.1 * std::cos(pi / 180 * (degree + 0.5)), r = 0.1 * std::sin(pi / 180 * (degree + 0.5));
      const MembraneStress s = law.stress(t, r);
      EXPECT_NEAR((law.energy_density(t + h, r) - law.energy_density(t - h, r)) / (2 * h), s.tangent, tolerance);
      EXPECT_NEAR((law.energy_density(t, r + h) - law.energy_density(t, r - h)) / (2 * h), s.hoop, tolerance);
      if (wrinkle) ++(s.tangent > 0 && s.hoop > 0 ? taut : s.tangent > 0 || s.hoop > 0 ? wrinkled : slack);
    }
  }
  EXPECT_GT(std::min({taut, wrinkled, slack}), 40);  // every region was there
}

/// Between states dt apart the stress differs by no more than the stiffest state's stiffness: it jumps over no border.
TEST_P(SheetOfPoisson, StressIsContinuousOverAllBorders) {
  const double nu = GetParam(), stiffest = stiffness / (1 - std::abs(nu)), step = 2 * pi / 100000;
  const Membrane law = sheet(nu);
  MembraneStress before = law.stress(0.1, 0);
  for (int k = 1; k <= 100000; ++k) {
    const MembraneStress s = law.stress(0.1 * std::cos(k * step), 0.1 * std::sin(k * step));
    ASSERT_LE(std::hypot(s.tangent - before.tangent, s.hoop - before.hoop), stiffest * 0.1 * step * (1 + 1e-6)) << k;
    before = s;
  }
}

/// A one-way sheet pulls and never pushes, and holds no more energy than the sheet that does both.
TEST_P(SheetOfPoisson, WrinklingOnlyRelaxes) {
  const Membrane law = sheet(GetParam()), both = sheet(GetParam(), false);
  for (int k = 0; k < 1000; ++k) {
    const double t = std::cos(2 * pi * k / 1000), r = std::sin(2 * pi * k / 1000);
    EXPECT_GE(law.stress(t, r).tangent, 0);
    EXPECT_GE(law.stress(t, r).hoop, 0);
    EXPECT_GE(law.energy_density(t, r), 0);
    EXPECT_LE(law.energy_density(t, r), both.energy_density(t, r) * (1 + 1e-12));
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, SheetOfPoisson, testing::Values(-0.4, 0.0, 0.3, 0.5));

TEST(MembraneTurned, AlongTheAxes) {
  const Stress x = Membrane::turned(5, {1, 0}), y = Membrane::turned(5, {0, 1});
  EXPECT_EQ(x.xx, 5);
  EXPECT_EQ(x.yy, 0);
  EXPECT_EQ(x.xy, 0);
  EXPECT_EQ(y.xx, 0);
  EXPECT_EQ(y.yy, 5);
  EXPECT_EQ(y.xy, 0);
}

TEST(MembraneTurned, AlongASlantAndAlongItsOpposite) {
  for (const double sign : {1.0, -1.0}) {
    const Stress s = Membrane::turned(100, {0.6 * sign, 0.8 * sign});
    EXPECT_NEAR(s.xx, 36, 1e-13);
    EXPECT_NEAR(s.yy, 64, 1e-13);
    EXPECT_NEAR(s.xy, 48, 1e-13);
  }
}

/// In global axes the stress works as it does along the tangent, and across it there is none.
TEST(MembraneTurned, WorksOnTheStretchAlongTheTangentOnly) {
  const StrainRate d{0.3, -0.7, 0.2};
  for (const double angle : {0.0, 0.4, 1.9, -2.5}) {
    const Vec<2> t{std::cos(angle), std::sin(angle)};
    const Stress s = Membrane::turned(100, t);
    EXPECT_NEAR(power(s, d), 100 * along(d, t), 1e-13);
    EXPECT_NEAR(s.xx * -t[1] + s.xy * t[0], 0, 1e-13);
    EXPECT_NEAR(s.xy * -t[1] + s.yy * t[0], 0, 1e-13);
  }
}

}  // namespace
}  // namespace tether
