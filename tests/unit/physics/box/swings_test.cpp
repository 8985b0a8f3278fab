// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/swings.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

// Bodies that swing from step to step about the velocity that a viscous fluid lets them have.

namespace tether::coupled {
namespace {

constexpr double step = 0.1, mean = 2;

/// A block whose nodes all go at the mean velocity w, plus what they differ from it by.
class SwingsOfABlock : public ::testing::Test {
 protected:
  SwingsOfABlock()
      : solids_(fem::support::skew_block(fem::support::Element{ElementKind::quad4, Dilatation::point},
                                         fem::support::neo_hookean())),
        system_(solids_, 0, alone()),
        w_(solids_.mesh.x.size(), mean),
        drag_(w_.size(), 0.0) {}

  /// Begins the step with u0 = w - now, after one that ended with `before` more than its mean.
  [[nodiscard]] CoupledState state(double before, double now) const {
    CoupledState state;
    state.u.assign(w_.size(), mean - now), state.swing.assign(w_.size(), before);
    return state;
  }
  [[nodiscard]] int found(const CoupledState& state, double heat) const {
    return Swings(system_).found(state, {w_, drag_, heat, step});
  }
  /// Of all nodes that have the velocity r in every direction.
  [[nodiscard]] double energy(double r) const {
    double sum = 0;
    for (const double m : system_.lumped) sum += 0.5 * m * r * r * system_.dim();
    return sum;
  }

  Solids solids_;
  fem::SolidSystem system_;
  std::vector<double> w_, drag_;
};

TEST_F(SwingsOfABlock, AreFoundWhereTheyTurn) {
  EXPECT_EQ(found(state(-0.5, 0.5), 1.01 * energy(0.5)), 0);
  EXPECT_EQ(found(state(-0.26, 0.5), 1.01 * energy(0.5)), 0) << "has grown";
  EXPECT_EQ(found(state(0.5, 0.5), 1.01 * energy(0.5)), -1) << "speeds up still";
  EXPECT_EQ(found(state(-0.24, 0.5), 1.01 * energy(0.5)), -1) << "is another motion";
}

/// What friction does not rule is a vibration of the body's own.
TEST_F(SwingsOfABlock, AreThoseThatFrictionRules) { EXPECT_EQ(found(state(-0.5, 0.5), 0.99 * energy(0.5)), -1); }

TEST_F(SwingsOfABlock, AreLeftWhereTheyAreSmall) {
  EXPECT_EQ(found(state(-0.021 * mean, 0.021 * mean), 100), 0);
  EXPECT_EQ(found(state(-0.019 * mean, 0.019 * mean), 100), -1);
}

/// Friction stops a body by at most its momentum: h F = -m u0, h the step.
TEST_F(SwingsOfABlock, AreFoundWhereFrictionTakesMoreThanTheMomentum) {
  for (const double part : {0.99, 1.01}) {
    const CoupledState begun = state(0, 0);
    for (std::size_t k = 0; k < drag_.size(); ++k) drag_[k] = -part * system_.lumped[k / 2] * begun.u[k] / step;
    EXPECT_EQ(found(begun, 0), part > 1 ? 0 : -1);
  }
}

TEST_F(SwingsOfABlock, AreNotThoseOfHeldNodes) {
  CoupledState begun = state(0, 0);
  begun.swing[0] = -100, begun.u[0] = mean - 100;
  EXPECT_EQ(found(begun, 1e6), 0);
  system_.held[0] = 1;
  EXPECT_EQ(found(begun, 1e6), -1);
}

TEST_F(SwingsOfABlock, CalmTheStepAndTenMore) {
  CoupledState begun = state(0, 0.5);
  begun.calm_steps = 0;
  Swings::keep(true, w_, begun);
  for (const double r : begun.swing) EXPECT_EQ(r, -0.5);
  int calm = 1;
  for (; begun.calm_steps > 0; ++calm) Swings::keep(false, w_, begun);
  EXPECT_EQ(calm, 11);
  EXPECT_EQ(begun.calmed, 11);
  Swings::keep(false, w_, begun);
  EXPECT_EQ(begun.calmed, 11);
}

}  // namespace
}  // namespace tether::coupled
