// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/materials/uniaxial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tether {
namespace {

constexpr double E = 1e6;
const Uniaxial one_way{E, 0.3, true}, two_way{E, 0.3, false};

TEST(UniaxialTest, TensionHasYoungsModulus) {  // (5.5), whatever Poisson's ratio
  EXPECT_EQ(one_way.stress(0.125), 125000);
  EXPECT_EQ(two_way.stress(0.125), 125000);
}

TEST(UniaxialTest, AOneWayStringCarriesNoCompression) {
  EXPECT_EQ(one_way.stress(-0.125), 0);
  EXPECT_EQ(one_way.stress(-1e-300), 0);
  EXPECT_GT(one_way.stress(1e-300), 0);
  EXPECT_EQ(one_way.energy_density(-0.125), 0);
  EXPECT_EQ(two_way.stress(-0.125), -125000);
  EXPECT_EQ(two_way.energy_density(-0.125), 7812.5);
}

TEST(UniaxialTest, NothingAtZeroStrain) {
  EXPECT_EQ(one_way.stress(0), 0);
  EXPECT_EQ(one_way.energy_density(0), 0);
}

/// The energy is quadratic in the strain, so a central difference has no error but rounding.
TEST(UniaxialTest, StressIsTheDerivativeOfTheEnergy) {
  const double h = 1e-3;
  for (const double strain : {0.01, 0.1, 0.7}) {
    EXPECT_NEAR((one_way.energy_density(strain + h) - one_way.energy_density(strain - h)) / (2 * h),
                one_way.stress(strain), 1e-7);
  }
  EXPECT_NEAR((two_way.energy_density(-0.1 + h) - two_way.energy_density(-0.1 - h)) / (2 * h), -1e5, 1e-7);
}

/// An initial stress of -1e5 stands for the strain -0.1 of Box 5: slack, until that much was pulled out.
TEST(UniaxialTest, SlackIsTakenUpBeforeItPulls) {
  EXPECT_EQ(one_way.stress(-0.1 + 0.0625), 0);
  EXPECT_NEAR(one_way.stress(-0.1 + 0.125), 0.025 * E, 1e-9);
}

TEST(UniaxialTest, SoundSpeed) { EXPECT_EQ((Uniaxial{4, 0, true}.sound_speed(0.25)), 4); }

TEST(UniaxialTurned, AlongTheAxes) {
  const Stress x = Uniaxial::turned(5, {1, 0}), y = Uniaxial::turned(5, {0, 1});
  EXPECT_EQ(x.xx, 5);
  EXPECT_EQ(x.yy, 0);
  EXPECT_EQ(x.xy, 0);
  EXPECT_EQ(y.xx, 0);
  EXPECT_EQ(y.yy, 5);
  EXPECT_EQ(y.xy, 0);
}

TEST(UniaxialTurned, AlongASlantAndAlongItsOpposite) {
  for (const double sign : {1.0, -1.0}) {
    const Stress s = Uniaxial::turned(100, {0.6 * sign, 0.8 * sign});
    EXPECT_NEAR(s.xx, 36, 1e-13);
    EXPECT_NEAR(s.yy, 64, 1e-13);
    EXPECT_NEAR(s.xy, 48, 1e-13);
  }
}

/// In global axes the stress works as it does along the tangent, and across it there is none.
TEST(UniaxialTurned, WorksOnTheStretchAlongTheTangentOnly) {
  const StrainRate d{0.3, -0.7, 0.2};
  for (const double angle : {0.0, 0.4, 1.9, -2.5}) {
    const Vec2 t{std::cos(angle), std::sin(angle)};
    const Stress s = Uniaxial::turned(100, t);
    EXPECT_NEAR(power(s, d), 100 * along(d, t), 1e-13);
    EXPECT_NEAR(s.xx * -t.y + s.xy * t.x, 0, 1e-13);
    EXPECT_NEAR(s.xy * -t.y + s.yy * t.x, 0, 1e-13);
  }
}

}  // namespace
}  // namespace tether
