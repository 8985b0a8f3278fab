// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/pair_force.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace tether::contact {
namespace {

/// Random vectors of pairs that are near enough to press each other, in regions of every kind.
template <PairKind kind, int dim>
struct RandomPair {
  static constexpr int count = vector_count(kind);
  PairVectors<dim, count> r0, r1;
  PairScale scale{.strength = 3, .gap2 = 0.16, .parallel = 0.3};

  RandomPair(std::mt19937& random, double way) {
    std::uniform_real_distribution<double> side(-1, 1), along(-0.4, 1.4);
    do {
      for (int j = 1; j < count; ++j) {
        for (int i = 0; i < dim; ++i) r0(i, j) = side(random);
      }
      r0.col(0) = SmallMatrix<dim, 1>::Zero();
      for (int j = 1; j < count; ++j)
        r0.col(0) += (kind == PairKind::edges && j == 2 ? -1 : 1) * along(random) * r0.col(j);
      for (int i = 0; i < dim; ++i) r0(i, 0) += 0.2 * side(random);
      r1 = r0;
      for (int j = 0; j < count; ++j) {
        for (int i = 0; i < dim; ++i) r1(i, j) += way * side(random);
      }
    } while (distance(r0) < 0.01 || distance(r1) < 0.01);
  }
  static double distance(const PairVectors<dim, count>& r) {
    return squared_distance<dim, count>(r, nearest<kind>(products_of<dim, count>(r)));
  }
  double energy(const PairVectors<dim, count>& r) const { return pair_energy<kind, dim>(scale, r, distance(r)); }
  PairForce<dim, count> force(const PairRule& rule, const PairVectors<dim, count>& end) const {
    return pair_force<kind, dim>(rule, scale, r0, end, distance(r0), distance(end));
  }
};

/// The work of a pair's forces is what its energy loses, whatever the step, and they give no momentum and turn nothing.
template <PairKind kind, int dim>
void keeps_energy_and_turns_nothing() {
  std::mt19937 random(7);
  int pressing = 0;
  for (const double way : {1e-7, 1e-4, 1e-2, 0.3}) {
    for (int k = 0; k < 400; ++k) {
      const RandomPair<kind, dim> pair(random, way);
      const auto force = pair.force({}, pair.r1).force;
      double work = 0;
      for (int j = 0; j < vector_count(kind); ++j) work += force.col(j).dot(pair.r1.col(j) - pair.r0.col(j));
      const double stored = pair.energy(pair.r1) - pair.energy(pair.r0);
      const double size = force.norm() * (1 + way);
      EXPECT_NEAR(work, stored, 1e-12 * (size + pair.energy(pair.r0) + pair.energy(pair.r1))) << way;
      const PairVectors<dim, vector_count(kind)> middle = 0.5 * (pair.r0 + pair.r1);
      double turning = 0;
      for (int j = 0; j < vector_count(kind); ++j) turning += middle(0, j) * force(1, j) - middle(1, j) * force(0, j);
      EXPECT_NEAR(turning, 0, 1e-12 * (1 + size));
      pressing += size > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(pressing, 200);
}

TEST(PairForce, KeepsEnergyAndTurnsNothing) {
  keeps_energy_and_turns_nothing<PairKind::corner, 2>();
  keeps_energy_and_turns_nothing<PairKind::edge, 2>();
  keeps_energy_and_turns_nothing<PairKind::edge, 3>();
  keeps_energy_and_turns_nothing<PairKind::triangle, 3>();
  keeps_energy_and_turns_nothing<PairKind::edges, 3>();
}

/// The derivative by the end against central differences, with friction's direction across held.
template <PairKind kind, int dim>
void has_its_derivative(const PairRule& given) {
  constexpr int count = vector_count(kind), unknowns = dim * count;
  std::mt19937 random(11);
  int wrong = 0, pressing = 0;
  for (const double way : {1e-5, 1e-3, 0.1}) {
    for (int k = 0; k < 200; ++k) {
      const RandomPair<kind, dim> pair(random, way);
      PairRule rule = given;
      rule.with_slopes = true;
      const auto at = pair.force(rule, pair.r1);
      if (at.pressing == 0) continue;
      ++pressing;
      rule.with_slopes = false;
      SmallMatrix<unknowns, unknowns> slope;
      constexpr double h = 1e-6;
      for (int j = 0; j < unknowns; ++j) {
        PairVectors<dim, count> more = pair.r1, less = pair.r1;
        more(j % dim, j / dim) += h, less(j % dim, j / dim) -= h;
        const PairVectors<dim, count> change = (pair.force(rule, more).force - pair.force(rule, less).force) / (2 * h);
        slope.col(j) = column_at<unknowns>(change.data());
      }
      wrong += (slope - at.slope).norm() > 2e-5 * slope.norm() ? 1 : 0;
    }
  }
  EXPECT_GT(pressing, 100);
  EXPECT_LE(wrong, pressing / 50) << "of " << pressing;  // where a region begins derivatives leap
}

TEST(PairForce, HasItsDerivative) {
  for (const bool damped : {false, true}) {
    const PairRule rule{.damped = damped};
    has_its_derivative<PairKind::corner, 2>(rule);
    has_its_derivative<PairKind::edge, 2>(rule);
    has_its_derivative<PairKind::edge, 3>(rule);
    has_its_derivative<PairKind::triangle, 3>(rule);
    has_its_derivative<PairKind::edges, 3>(rule);
  }
}

}  // namespace
}  // namespace tether::contact
