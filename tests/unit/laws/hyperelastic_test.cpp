// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/hyperelastic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace tether {
namespace {

/// Some strain that is neither small nor along the axes.
template <int dim>
Symmetric<dim> strained() {
  Symmetric<dim> C = Symmetric<dim>::Zero();
  C.template head<dim>().setConstant(1.1);
  for (int k = 0; k < component_count<dim>(); ++k) C[k] += 0.03 * (k + 1) * (k % 2 == 0 ? 1 : -1);
  return C;
}

/// S = 2 dPsi/dC and D = 2 dS/dC against central differences.
template <int dim, class Law>
void expect_derivatives(const Law& law) {
  constexpr double h = 1e-6;
  const Symmetric<dim> C = strained<dim>(), w = contraction_weights<dim>();
  const Response<dim> r = law.template respond<dim>(C);
  for (int k = 0; k < component_count<dim>(); ++k) {
    Symmetric<dim> up = C, down = C;
    up[k] += h, down[k] -= h;
    const auto high = law.template respond<dim>(up), low = law.template respond<dim>(down);
    EXPECT_NEAR((high.energy - low.energy) / (2 * h), 0.5 * r.S[k] * w[k], 1e-9);
    EXPECT_LT(((high.S - low.S) / (2 * h) - 0.5 * r.D.col(k) * w[k]).norm(), 2e-9);
  }
}

TEST(Hyperelastic, StressAndModuliAreDerivativesOfTheEnergy) {
  expect_derivatives<2>(StVenantKirchhoff{2, 1.3});
  expect_derivatives<3>(StVenantKirchhoff{2, 1.3});
  for (const auto volumetric : {Volumetric::log, Volumetric::square, Volumetric::mixed}) {
    for (const auto plane : {Plane::strain, Plane::stress})
      expect_derivatives<2>(NeoHookean{2, 1.3, volumetric, plane});
    expect_derivatives<3>(NeoHookean{2, 1.3, volumetric, Plane::strain});
  }
}

TEST(Hyperelastic, PlaneBodiesAreSpaceWithTheThirdDirectionHeldOrFree) {
  const Symmetric<2> C = strained<2>();
  Symmetric<3> C3;
  C3 << C[0], C[1], 1, C[2], 0, 0;
  for (const auto volumetric : {Volumetric::log, Volumetric::square, Volumetric::mixed}) {
    const NeoHookean strain{2, 1.3, volumetric, Plane::strain}, stress{2, 1.3, volumetric, Plane::stress};
    C3[2] = 1;
    const auto held = strain.respond<2>(C);
    const auto space = strain.respond<3>(C3);
    EXPECT_NEAR(held.energy, space.energy, 1e-15);
    EXPECT_LT((held.S - Symmetric<2>(space.S[0], space.S[1], space.S[3])).norm(), 1e-14);
    // by bisection, the thickness at which a free surface carries nothing
    double low = 0.2, high = 3;
    for (int k = 0; k < 200; ++k) {
      C3[2] = 0.5 * (low + high);
      (strain.respond<3>(C3).S[2] < 0 ? low : high) = C3[2];
    }
    const auto free = strain.respond<3>(C3);
    EXPECT_NEAR(stress.respond<2>(C).energy, free.energy, 1e-14);
    EXPECT_LT((stress.respond<2>(C).S - Symmetric<2>(free.S[0], free.S[1], free.S[3])).norm(), 1e-13);
  }
}

TEST(Hyperelastic, SmallStrainsFollowHooke) {
  const Lame l = lame(3, 0.3);
  constexpr double e = 1e-7;
  Symmetric<3> C;
  C << 1 + 2 * e, 1 - e, 1 + 0.5 * e, 0.3 * e, -0.2 * e, 0.1 * e;
  Symmetric<3> hooke = l.mu * (C - (Symmetric<3>() << 1, 1, 1, 0, 0, 0).finished());
  hooke.head<3>().array() += 0.75 * e * l.lambda;
  for (const auto volumetric : {Volumetric::log, Volumetric::square, Volumetric::mixed}) {
    EXPECT_LT((NeoHookean{l.lambda, l.mu, volumetric, Plane::strain}.respond<3>(C).S - hooke).norm(), 100 * e * e);
  }
  EXPECT_LT((StVenantKirchhoff{l.lambda, l.mu}.respond<3>(C).S - hooke).norm(), 1e-15);
}

/// Near C = 1 the energy is a small difference of large numbers, unless it is written so that it is not.
TEST(Hyperelastic, EnergiesOfSmallStrainsKeepTheirDigits) {
  constexpr double e = 1e-6;
  const NeoHookean law{2, 1.3, Volumetric::log, Plane::strain};
  const Symmetric<3> C = (Symmetric<3>() << 1 + 2 * e, 1, 1, 0, 0, 0).finished();
  const double ln = 0.5 * std::log1p(2 * e);
  const double exact = 1.3 * (2 * e * e / 2 - 4 * e * e * e / 3) + ln * ln;  // mu (e - ln(1 + 2 e)/2) by its series
  EXPECT_NEAR(law.respond<3>(C).energy / exact, 1, 1e-9);
}

TEST(HoopFibre, PullsAlongCirclesAlone) {
  const HoopFibre fibre{4, 1, 2};
  const auto r = fibre.respond<2>({1.21, 1, 0}, {1, 5});  // above the centre the circle runs along x
  EXPECT_DOUBLE_EQ(r.S[0], 4);
  EXPECT_DOUBLE_EQ(r.S[1], 0);
  EXPECT_DOUBLE_EQ(r.S[2], 0);
  EXPECT_NEAR(r.energy, 2 * 0.21, 1e-15);
}

}  // namespace
}  // namespace tether
