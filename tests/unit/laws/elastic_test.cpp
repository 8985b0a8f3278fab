// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/elastic.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tether {
namespace {

constexpr double E = 10, nu = 0.25;

/// Stress of a strain reached from the unstressed state in one step of unit time.
Stress stress_of(const PlaneElastic& law, const StrainRate& strain) { return law.updated({}, strain, 1); }

double energy_of(const PlaneElastic& law, const StrainRate& strain) {
  return law.energy_density(stress_of(law, strain));
}

/// The energy is quadratic in the strain, so a central difference has no error but rounding.
TEST(PlaneElasticTest, StressIsTheDerivativeOfTheEnergy) {
  const double h = 1e-3;
  for (const PlaneElastic& law :
       {plane_strain(E, nu), plane_stress(E, nu), plane_strain(E, -0.4), plane_stress(E, 0.5)}) {
    for (const StrainRate& e : std::vector<StrainRate>{{0.02, -0.01, 0.03}, {-0.05, -0.04, 0}, {0, 0, -0.07}}) {
      const Stress s = stress_of(law, e);
      const auto W = [&](double xx, double yy, double xy) { return energy_of(law, {e.xx + xx, e.yy + yy, e.xy + xy}); };
      EXPECT_NEAR((W(h, 0, 0) - W(-h, 0, 0)) / (2 * h), s.xx, 1e-12);
      EXPECT_NEAR((W(0, h, 0) - W(0, -h, 0)) / (2 * h), s.yy, 1e-12);
      EXPECT_NEAR((W(0, 0, h) - W(0, 0, -h)) / (2 * h), 2 * s.xy, 1e-12);  // xy and yx
    }
  }
}

/// eps_xx alone: sigma_xx = E (1 - nu) / ((1 + nu)(1 - 2 nu)) eps, sigma_yy = sigma_zz = nu / (1 - nu) sigma_xx.
TEST(PlaneElasticTest, UniaxialStrain) {
  const PlaneElastic law = plane_strain(E, nu);
  const Stress s = stress_of(law, {0.01, 0, 0});
  EXPECT_NEAR(s.xx, 0.12, 1e-15);
  EXPECT_NEAR(s.yy, 0.04, 1e-15);
  EXPECT_EQ(s.xy, 0);
  EXPECT_NEAR(law.out_of_plane_stress(s), 0.04, 1e-15);
  EXPECT_NEAR(law.energy_density(s), 0.5 * 0.12 * 0.01, 1e-16);
}

/// In simple shear v_x = gamma' y only sigma_xy = G gamma, G = E / (2 (1 + nu)) = 4.
TEST(PlaneElasticTest, SimpleShear) {
  const StrainRate d = symmetric_part({0, 0.02, 0, 0});
  for (const PlaneElastic& law : {plane_strain(E, nu), plane_stress(E, nu)}) {
    const Stress s = law.updated({}, d, 0.5);
    EXPECT_EQ(s.xx, 0);
    EXPECT_EQ(s.yy, 0);
    EXPECT_NEAR(s.xy, 4 * 0.01, 1e-16);
    EXPECT_NEAR(law.energy_density(s), 0.5 * 4 * 0.01 * 0.01, 1e-18);
  }
}

TEST(PlaneElasticTest, PlaneStressWithFreeSidesHasYoungsModulus) {
  const PlaneElastic law = plane_stress(E, nu);
  const Stress s = stress_of(law, {0.01, -nu * 0.01, 0});
  EXPECT_NEAR(s.xx, E * 0.01, 1e-15);
  EXPECT_NEAR(s.yy, 0, 1e-16);
  EXPECT_EQ(law.out_of_plane_stress(s), 0);
  EXPECT_NEAR(law.energy_density(s), 0.5 * E * 0.01 * 0.01, 1e-17);
}

/// eps_yy = -nu / (1 - nu) eps_xx: sigma_xx = E / (1 - nu^2) eps, sigma_zz = nu sigma_xx.
TEST(PlaneElasticTest, PlaneStrainWithFreeSidesIsStiffer) {
  const PlaneElastic law = plane_strain(E, nu);
  const Stress s = stress_of(law, {0.015, -0.005, 0});
  EXPECT_NEAR(s.xx, 0.16, 1e-15);
  EXPECT_NEAR(s.yy, 0, 1e-16);
  EXPECT_NEAR(law.out_of_plane_stress(s), 0.04, 1e-15);
}

TEST(PlaneElasticTest, WithoutLateralContractionBothPlanesAreOne) {
  const StrainRate e{0.02, -0.01, 0.03};
  const Stress strain = stress_of(plane_strain(E, 0), e), stress = stress_of(plane_stress(E, 0), e);
  EXPECT_EQ(strain.xx, stress.xx);
  EXPECT_EQ(strain.yy, stress.yy);
  EXPECT_EQ(strain.xy, stress.xy);
  EXPECT_NEAR(strain.xx, 0.2, 1e-15);
  EXPECT_EQ(plane_strain(E, 0).out_of_plane_stress(strain), 0);
}

/// 1/2 sigma : C^-1 : sigma: in plane strain (1 + nu)/(2 E) ((1 - nu)(xx^2 + yy^2) - 2 nu xx yy + 2 xy^2), in plane
/// stress 1/(2 E) (xx^2 + yy^2 - 2 nu xx yy + 2 (1 + nu) xy^2).
TEST(PlaneElasticTest, EnergyOfAnInitialStress) {
  const Stress s{3, -2, 1};
  EXPECT_NEAR(plane_strain(E, nu).energy_density(s), 0.921875, 1e-15);
  EXPECT_NEAR(plane_stress(E, nu).energy_density(s), 0.925, 1e-15);
  EXPECT_EQ(plane_strain(E, nu).energy_density({}), 0);
}

TEST(PlaneElasticTest, IncrementsAddToAnInitialStress) {
  const PlaneElastic law = plane_strain(E, nu);
  const StrainRate d{0.3, -0.2, 0.1};
  Stress s{3, -2, 1};
  for (int k = 0; k < 10; ++k) s = law.updated(s, d, 0.01);
  const Stress change = law.updated({}, d, 0.1);
  EXPECT_NEAR(s.xx, 3 + change.xx, 1e-14);
  EXPECT_NEAR(s.yy, -2 + change.yy, 1e-14);
  EXPECT_NEAR(s.xy, 1 + change.xy, 1e-14);
}

TEST(PlaneElasticTest, ARotationLeavesTheStressAsItIs) {
  const Stress s = plane_stress(E, nu).updated({3, -2, 1}, symmetric_part({0, -5, 5, 0}), 0.1);
  EXPECT_EQ(s.xx, 3);
  EXPECT_EQ(s.yy, -2);
  EXPECT_EQ(s.xy, 1);
}

TEST(PlaneElasticTest, SpeedOfTheStepLimitIsThatOfABar) {
  EXPECT_EQ(plane_strain(4, 0.3).sound_speed(0.25), 4);
  EXPECT_EQ(plane_stress(4, 0.3).sound_speed(0.25), 4);
}

TEST(PlaneElasticTest, StrainIsTheInverseOfTheStress) {
  for (const PlaneElastic law : {plane_strain(4, 0.25), plane_stress(4, 0.25), plane_strain(7, 0)}) {
    const Strain given{0.01, -0.02, 0.005};
    const Strain back = law.strain(law.updated({}, given, 1));
    EXPECT_NEAR(back.xx, given.xx, 1e-16);
    EXPECT_NEAR(back.yy, given.yy, 1e-16);
    EXPECT_NEAR(back.xy, given.xy, 1e-16);
  }
}

TEST(PlaneElasticTest, AboutAnAxisStrainIsTheInverseOfAllThreeStresses) {
  const PlaneElastic law = plane_strain(4, 0.25);
  const Strain given{0.01, -0.02, 0.005, 0.03};
  const Strain back = law.strain_about_axis(law.updated({}, given, 1));
  EXPECT_NEAR(back.xx, given.xx, 1e-16);
  EXPECT_NEAR(back.yy, given.yy, 1e-16);
  EXPECT_NEAR(back.xy, given.xy, 1e-16);
  EXPECT_NEAR(back.zz, given.zz, 1e-16);
}

}  // namespace
}  // namespace tether
