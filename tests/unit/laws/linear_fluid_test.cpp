// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/fluids.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

const LinearFluid water{1.58e6};

TEST(LinearFluidTest, PressureAddsUpStrain) {  // (6.1): p = -beta div U
  double p = 0;
  for (int k = 0; k < 5; ++k) p = water.updated_pressure(p, -0.01, 0.2);
  EXPECT_NEAR(p, 1.58e6 * 0.01, 1e-9);
  for (int k = 0; k < 5; ++k) p = water.updated_pressure(p, 0.01, 0.2);
  EXPECT_NEAR(p, 0, 1e-9);
  EXPECT_NEAR(water.updated_pressure(100, 1e-3, 0.5), 100 - 790, 1e-12);  // tension is carried
}

/// As a function of the strain the energy has the slope -p; it is quadratic, so the difference is exact.
TEST(LinearFluidTest, MinusPressureIsTheDerivativeOfTheEnergy) {
  const double h = 1e-3;
  for (const double strain : {-0.02, 0.0, 0.01}) {
    const auto W = [](double e) { return water.energy_density(water.updated_pressure(0, e, 1)); };
    EXPECT_NEAR((W(strain + h) - W(strain - h)) / (2 * h), -water.updated_pressure(0, strain, 1), 1e-8);
  }
}

TEST(LinearFluidTest, EnergyOfAPressure) {
  EXPECT_EQ(LinearFluid{8}.energy_density(4), 1);
  EXPECT_EQ(LinearFluid{8}.energy_density(-4), 1);
  EXPECT_EQ(LinearFluid{8}.energy_density(0), 0);
}

TEST(LinearFluidTest, SoundSpeed) { EXPECT_NEAR(water.sound_speed(1e-4), 125698.05, 5e-3); }  // sqrt(1.58e10)

}  // namespace
}  // namespace tether
