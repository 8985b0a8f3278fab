// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/finite_elastic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tether {
namespace {

constexpr double lambda = 2, mu = 1.3;

std::vector<FiniteElastic> laws(Plane plane) {
  std::vector<FiniteElastic> all{{StVenantKirchhoff::of({.E = 3.38, .nu = 0.3, .plane = plane}), 3.38, 0.3}};
  for (const auto volumetric : {Volumetric::log, Volumetric::square, Volumetric::mixed})
    all.push_back({NeoHookean{lambda, mu, volumetric, plane}, 3.38, 0.3});
  return all;
}

DeformationGradient times(const Eigen::Matrix2d& A, const DeformationGradient& F) {
  const Eigen::Matrix2d G = A * (Eigen::Matrix2d() << F.xx, F.xy, F.yx, F.yy).finished();
  return {G(0, 0), G(0, 1), G(1, 0), G(1, 1), F.zz};
}

Eigen::Matrix2d matrix(const Stress& s) { return (Eigen::Matrix2d() << s.xx, s.xy, s.xy, s.yy).finished(); }

Eigen::Matrix2d rotation(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

/// A path of F: sheared while stretched.
DeformationGradient on_path(double t) { return {1 + 0.8 * t, 0.5 * t, -0.1 * t, 1 - 0.4 * t, 1 + 0.3 * t}; }

// sigma = (mu (b - 1) + g(J) 1) / J, g of each of the energies lambda U(J); b the left Cauchy-Green tensor.
TEST(FiniteElastic, NeoHookeanFollowsItsClosedForm) {
  for (int k = 0; k <= 10; ++k) {
    const DeformationGradient F = on_path(0.1 * k);
    const Eigen::Matrix2d f = (Eigen::Matrix2d() << F.xx, F.xy, F.yx, F.yy).finished(), b = f * f.transpose();
    for (const bool about_axis : {false, true}) {
      const double J = f.determinant() * (about_axis ? F.zz : 1);
      const std::pair<Volumetric, double> energies[] = {{Volumetric::log, lambda * std::log(J)},
                                                        {Volumetric::square, lambda * J * (J - 1)},
                                                        {Volumetric::mixed, 0.5 * lambda * (J * J - 1)}};
      for (const auto& [volumetric, g] : energies) {
        const FiniteElastic law{NeoHookean{lambda, mu, volumetric, Plane::strain}, 3.38, 0.3};
        const Stress s = about_axis ? law.respond_about_axis(F).stress : law.respond(F).stress;
        const Eigen::Matrix2d exact = (mu * (b - Eigen::Matrix2d::Identity()) + g * Eigen::Matrix2d::Identity()) / J;
        EXPECT_LT((matrix(s) - exact).cwiseAbs().maxCoeff(), 1e-12) << k;
        const double zz = about_axis ? F.zz * F.zz : 1;
        EXPECT_NEAR(s.zz, (mu * (zz - 1) + g) / J, 1e-12);
      }
    }
  }
}

// sigma = F (lambda tr(E) 1 + 2 mu E) F^T / J.
TEST(FiniteElastic, StVenantKirchhoffFollowsItsClosedForm) {
  const FiniteElastic law{StVenantKirchhoff{lambda, mu}, 0, 0};
  for (int k = 0; k <= 10; ++k) {
    const DeformationGradient F = on_path(0.1 * k);
    const Eigen::Matrix2d f = (Eigen::Matrix2d() << F.xx, F.xy, F.yx, F.yy).finished(),
                          one = Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d E = 0.5 * (f.transpose() * f - one);
    for (const bool about_axis : {false, true}) {
      const double hoop = about_axis ? 0.5 * (F.zz * F.zz - 1) : 0, J = f.determinant() * (about_axis ? F.zz : 1);
      const Stress s = about_axis ? law.respond_about_axis(F).stress : law.respond(F).stress;
      const Eigen::Matrix2d S = lambda * (E.trace() + hoop) * one + 2 * mu * E;
      EXPECT_LT((matrix(s) - f * S * f.transpose() / J).cwiseAbs().maxCoeff(), 1e-12);
      const double zz = about_axis ? F.zz * F.zz : 1;
      EXPECT_NEAR(s.zz, zz * (lambda * (E.trace() + hoop) + 2 * mu * hoop) / J, 1e-12);
    }
  }
}

TEST(FiniteElastic, ARotationTurnsTheStressAndNothingElse) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    for (const FiniteElastic& law : laws(plane)) {
      for (const double angle : {0.3, 1.0, std::numbers::pi, -2.5}) {
        const Eigen::Matrix2d R = rotation(angle);
        const FiniteResponse rest = law.respond(times(R, {}));
        EXPECT_LT(matrix(rest.stress).cwiseAbs().maxCoeff() + std::abs(rest.stress.zz), 1e-14);
        const DeformationGradient F = on_path(0.5);
        for (const bool about_axis : {false, true}) {
          const auto of = [&](const DeformationGradient& at) {
            return about_axis ? law.respond_about_axis(at) : law.respond(at);
          };
          const FiniteResponse before = of(F), after = of(times(R, F));
          EXPECT_LT((matrix(after.stress) - R * matrix(before.stress) * R.transpose()).cwiseAbs().maxCoeff(), 1e-12);
          EXPECT_NEAR(after.stress.zz, before.stress.zz, 1e-12);
          EXPECT_NEAR(after.energy, before.energy, 1e-12);
          EXPECT_NEAR(after.across, before.across, 1e-12);
        }
      }
    }
  }
}

// The work J sigma : L dt of a small step is what the energy grows by.
TEST(FiniteElastic, StressDoesTheWorkThatIsStored) {
  constexpr double h = 1e-5;
  const VelocityGradient L{0.3, -0.7, 0.4, 0.9};
  constexpr double hoop = 0.5;
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    for (const FiniteElastic& law : laws(plane)) {
      for (const bool about_axis : {false, true}) {
        const auto of = [&](double dt) {
          const DeformationGradient F = after_move(on_path(0.4), L, about_axis ? hoop : 0, dt);
          return about_axis ? law.respond_about_axis(F) : law.respond(F);
        };
        const FiniteResponse at = of(0);
        DeformationGradient F = on_path(0.4);
        F.zz = at.across;
        StrainRate d = symmetric_part(L);
        d.zz = about_axis ? hoop : 0;
        EXPECT_NEAR((of(h).energy - of(-h).energy) / (2 * h), F.volume_ratio() * power(at.stress, d), 1e-8);
      }
    }
  }
}

// Turning places by x += dt W x stretches F by just what it stretches the places, from either end of the step.
TEST(FiniteElastic, BothEndsOfAStepGiveTheSameF) {
  constexpr double dt = 0.1;
  const Eigen::Matrix2d before = (Eigen::Matrix2d() << 0.2, -0.9, 0.7, -0.1).finished();
  const Eigen::Matrix2d after = before * (Eigen::Matrix2d::Identity() + dt * before).inverse();
  const DeformationGradient F = on_path(0.5);
  const auto gradient = [](const Eigen::Matrix2d& L) { return VelocityGradient{L(0, 0), L(0, 1), L(1, 0), L(1, 1)}; };
  const DeformationGradient a = after_move(F, gradient(before), 0.3, dt),
                            b = after_arrival(F, gradient(after), 0.3 / (1 + dt * 0.3), dt);
  for (const auto of : {&DeformationGradient::xx, &DeformationGradient::xy, &DeformationGradient::yx,
                        &DeformationGradient::yy, &DeformationGradient::zz})
    EXPECT_NEAR(a.*of, b.*of, 1e-15);
}

/// rho_0 c^2 of the fastest of many plane waves, from differences of the Kirchhoff stress.
double fastest(const FiniteElastic& law, const DeformationGradient& F, bool about_axis) {
  constexpr double h = 1e-6;
  const auto kirchhoff = [&](const DeformationGradient& at) -> Eigen::Matrix2d {
    const FiniteResponse r = about_axis ? law.respond_about_axis(at) : law.respond(at);
    DeformationGradient whole = at;
    whole.zz = r.across;
    return matrix(r.stress) * whole.volume_ratio();
  };
  double largest = 0;
  for (int k = 0; k < 180; ++k) {
    const double angle = std::numbers::pi * k / 180;
    const Eigen::Vector2d n(std::cos(angle), std::sin(angle));
    Eigen::Matrix2d Q;  // d(tau f^-T n) / d(a n^T), f the increment of F
    for (int i = 0; i < 2; ++i) {
      const auto force = [&](double step) -> Eigen::Vector2d {
        const Eigen::Matrix2d f = Eigen::Matrix2d::Identity() + step * Eigen::Vector2d::Unit(i) * n.transpose();
        return kirchhoff(times(f, F)) * f.inverse().transpose() * n;
      };
      Q.col(i) = (force(h) - force(-h)) / (2 * h);
    }
    largest = std::max(largest, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(Q).eigenvalues()[1]);
  }
  return largest;
}

TEST(FiniteElastic, NoPlaneWaveIsFasterThanTheBound) {
  for (const Plane plane : {Plane::strain, Plane::stress}) {
    for (const FiniteElastic& law : laws(plane)) {
      for (const double t : {0.0, 0.3, 1.0}) {
        for (const bool about_axis : {false, true}) {
          const DeformationGradient F{1 + 0.8 * t, 0.5 * t, -0.1 * t, 1 / (1 + t), 1 + 0.2 * t};
          const double bound = (about_axis ? law.respond_about_axis(F) : law.respond(F)).modulus;
          const double wave = fastest(law, F, about_axis);
          EXPECT_GT(bound, (1 - 1e-7) * wave) << t;
          EXPECT_LT(bound, 1.15 * wave) << t;
        }
      }
      EXPECT_NEAR(fastest(law, {}, false), law.sound_speed(1) * law.sound_speed(1), 1e-7);
    }
  }
}

}  // namespace
}  // namespace tether
