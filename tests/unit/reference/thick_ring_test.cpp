// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/thick_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tether {
namespace {

/// Small strains: Lame's ring.
TEST(ThickRing, OfSmallStrainsIsLames) {
  const double young = 3, nu = 0.3, p = 1, A = p / 3;  // radii 1 and 2
  const ElasticConstants constants{.E = young, .nu = nu};
  const ThickRing ring{1, 2, LinearElastic::of(constants)};
  const double u = (1 + nu) / young * A * ((1 - 2 * nu) + 4);
  const BlownRing blown = blown_ring(ring, 1 + u);
  EXPECT_NEAR(blown.pressure, p, 1e-9);
  EXPECT_NEAR(blown.outer, 2 + (1 + nu) / young * A * ((1 - 2 * nu) * 2 + 2), 1e-9);
  EXPECT_NEAR(blown.energy, 0.5 * p * 2 * std::numbers::pi * u, 1e-9);
}

/// Neo-Hookean and nearly incompressible: areas stay, and p = mu/2 [ln(b_i^2/b_o^2) + 1/b_o^2 - 1/b_i^2] with the hoop
/// stretches b inside and outside, after R. S. Rivlin, Phil. Trans. R. Soc. A 242 (1949) 173-195.
TEST(ThickRing, ThatKeepsItsAreaIsRivlins) {
  const double mu = 2;
  for (const double lambda : {2e5, 2e6}) {
    const ThickRing ring{1, 1.5, NeoHookean{lambda, mu, Volumetric::log, Plane::strain}};
    const double inner = 1.6, outer = std::sqrt(1.5 * 1.5 + inner * inner - 1);
    const double in = std::pow(inner, 2), out = std::pow(outer / 1.5, 2);
    const double p = 0.5 * mu * (std::log(in / out) + 1 / out - 1 / in);
    const BlownRing blown = blown_ring(ring, inner);
    EXPECT_NEAR(blown.pressure, p, 4 * mu / lambda);
    EXPECT_NEAR(blown.outer, outer, 4 * mu / lambda);
  }
}

/// What the pressure does while the hole grows is the strain energy.
TEST(ThickRing, WorksOnItsStrainEnergy) {
  const ThickRing ring{1, 1.3, NeoHookean{5, 1, Volumetric::square, Plane::strain}};
  const double r = 1.4, h = 1e-3;
  const double work = blown_ring(ring, r).pressure * 2 * std::numbers::pi * r;
  EXPECT_NEAR((blown_ring(ring, r + h).energy - blown_ring(ring, r - h).energy) / (2 * h), work, 1e-5 * work);
}

TEST(ThickRing, RefusesWhatIsNoRing) {
  const ElasticLaw law = NeoHookean{5, 1, Volumetric::log, Plane::strain};
  EXPECT_THROW(blown_ring({1, 1, law}, 1.1), std::domain_error);
  EXPECT_THROW(blown_ring({0, 1, law}, 1.1), std::domain_error);
  EXPECT_THROW(blown_ring({1, 2, law}, 0), std::domain_error);
}

}  // namespace
}  // namespace tether
