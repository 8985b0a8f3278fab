// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/thin_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tether {
namespace {

using std::numbers::pi;

/// Thesis 6.2: the membrane of Tables 4 to 6 and the gas that fills the two polygons of Box 9 at the density 1.
constexpr double gas_mass = 0.426 * (0.90 + 0.95) / 2 + 0.474 * (0.25 + 0.09) / 2;
constexpr ThinRing thesis_ring{2.199, 0.1, 1e6, 0.3, 0.4, 250 * gas_mass};

TEST(ThinRing, membrane_expansion_of_the_thesis) {
  const RingAtRest rest = ring_at_rest(thesis_ring);
  EXPECT_NEAR(gas_mass, 0.47463, 1e-8);
  EXPECT_NEAR(rest.radius, 1.4005, 5e-5);
  EXPECT_NEAR(rest.pressure, 30.807, 5e-4);
  EXPECT_NEAR(rest.hoop_stress, 431.61, 5e-3);
}

/// Each of the three equations by itself, soft rings that stretch by a tenth included.
TEST(ThinRing, balances_force_and_energy) {
  for (const double young : {1e9, 1e6, 1e4, 3e3}) {
    ThinRing ring = thesis_ring;
    ring.young = young;
    const RingAtRest rest = ring_at_rest(ring);
    const double stretch = rest.radius * pi / 2 / ring.length;
    EXPECT_NEAR(rest.hoop_stress, young * std::log(stretch) / 0.91, 1e-9 * young) << young;
    EXPECT_NEAR(rest.strain_energy, rest.hoop_stress * std::log(stretch) * 2.199 * 0.1 / 2, 1e-9) << young;
    EXPECT_NEAR(rest.pressure * rest.radius / (rest.hoop_stress * 0.1 / stretch), 1, 1e-9) << young;
    const double internal = rest.pressure * pi * rest.radius * rest.radius / 4 / 0.4;
    EXPECT_NEAR((internal + rest.strain_energy) / ring.internal_energy, 1, 1e-12) << young;
  }
  ThinRing soft = thesis_ring;
  soft.young = 3e3;
  EXPECT_GT(ring_at_rest(soft).radius, 1.1 * 2 * 2.199 / pi);
}

/// E to infinity: the circle of the unstretched length, p = (gamma - 1) U / A, and p r / t; how far off is of order
/// 1/E.
TEST(ThinRing, stiff_ring_keeps_its_length) {
  const double radius = 2 * 2.199 / pi, pressure = 0.4 * thesis_ring.internal_energy / (pi * radius * radius / 4);
  double off[2];
  for (int k = 0; k < 2; ++k) {
    ThinRing ring = thesis_ring;
    ring.young = k == 0 ? 1e8 : 2e8;
    const RingAtRest rest = ring_at_rest(ring);
    off[k] = rest.radius / radius - 1;
    EXPECT_NEAR(rest.pressure / pressure, 1, 3 * off[k]);
    EXPECT_NEAR(rest.hoop_stress / (pressure * radius / 0.1), 1, 3 * off[k]);
  }
  EXPECT_LT(off[0], 1e-5);
  EXPECT_NEAR(off[0] / off[1], 2, 1e-4);
}

TEST(ThinRing, poisson_stiffens_it) {
  ThinRing uniaxial = thesis_ring, stiffer = thesis_ring;
  uniaxial.poisson = 0;
  stiffer.young /= 1 - 0.3 * 0.3, stiffer.poisson = 0;
  EXPECT_NEAR(ring_at_rest(stiffer).radius, ring_at_rest(thesis_ring).radius, 1e-12);
  EXPECT_GT(ring_at_rest(uniaxial).radius, ring_at_rest(thesis_ring).radius);
}

TEST(ThinRing, refuses_what_comes_to_no_rest) {
  for (double ThinRing::*number :
       {&ThinRing::length, &ThinRing::thickness, &ThinRing::young, &ThinRing::gm1, &ThinRing::internal_energy}) {
    for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      ThinRing ring = thesis_ring;
      ring.*number = wrong;
      EXPECT_THROW(ring_at_rest(ring), std::domain_error);
    }
  }
  for (const double poisson : {-1.0, 0.51, std::nan("")}) {
    ThinRing ring = thesis_ring;
    ring.poisson = poisson;
    EXPECT_THROW(ring_at_rest(ring), std::domain_error);
  }
  ThinRing weak = thesis_ring;
  weak.young = 100;
  EXPECT_THROW(ring_at_rest(weak), std::domain_error);
}

}  // namespace
}  // namespace tether
