// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/solids/step.hpp"
#include "unit/alone.hpp"
#include "unit/physics/solids/blocks_support.hpp"

// Steps of backward Euler, which bodies that meet take where nothing else leads on.

namespace tether::fem {
namespace {

using namespace support;

constexpr double gravity = -10;

/// A skew block above the plane y = `floor`.
Solids block_above(double floor, const Element& element) {
  Solids solids = skew_block(element, neo_hookean());
  solids.contact.emplace();
  solids.contact->gap = 0.05;
  solids.contact->planes = {{{0, floor, 0}, {0, 1, 0}}};
  return solids;
}

SolidState moving(const Solids& solids, double vx, double vy) {
  SolidState state;
  state.q = solids.mesh.x, state.v.assign(state.q.size(), 0.0);
  const auto dim = static_cast<std::size_t>(solids.mesh.dim());
  for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) state.v[n * dim] = vx, state.v[n * dim + 1] = vy;
  return state;
}

double mass_of(const SolidSystem& system) {
  double mass = 0;
  for (const double part : system.weights) mass += part;
  return mass;
}

/// v1 = v0 + g h, q1 = q0 + h v1, and the step takes m |v1 - v0|^2/2 besides what it falls; so does a calm step.
TEST(Euler, FallsByTheVelocityAtTheEnd) {
  constexpr double h = 0.02, vx = 0.3, vy = 1.5, v1 = vy + h * gravity;
  for (const Element& element : all_elements()) {
    SCOPED_TRACE(element);
    for (const bool calm : {false, true}) {
      const Solids solids = block_above(-50, element);
      const SolidSystem system(solids, gravity, alone());
      SolidStep step(system);
      SolidState state = moving(solids, vx, vy);
      ASSERT_TRUE((calm ? step.advance_calmly(state, h) : step.advance_by_euler(state, h)).converged);
      const auto dim = static_cast<std::size_t>(solids.mesh.dim());
      for (std::size_t n = 0; n < solids.mesh.node_count(); ++n) {
        EXPECT_NEAR(state.v[n * dim], vx, 1e-9);
        EXPECT_NEAR(state.v[n * dim + 1], v1, 1e-9);
        EXPECT_NEAR(state.q[n * dim + 1], solids.mesh.x[n * dim + 1] + h * v1, 1e-11);
      }
      EXPECT_NEAR(state.damped, 0.5 * mass_of(system) * (v1 - vy) * (v1 - vy), 1e-9);
      EXPECT_EQ(state.contact.doubts.euler_steps, calm ? 0 : 1);
    }
  }
}

double energy_of(const SolidSystem& system, const SolidState& state) {
  std::vector<double> momentum(state.v.size());
  system.multiply_mass(state.v, momentum);
  double energy = system.elements->strain_energy(state.q) + system.gravity_energy(state.q) + state.contact.last.energy;
  for (std::size_t k = 0; k < momentum.size(); ++k) energy += 0.5 * momentum[k] * state.v[k];
  return energy;
}

/// A soft block that hits a plane: its energy falls in every step by what is booked, long as the steps are, and no node
/// goes through.
TEST(Euler, BooksWhatItTakesOfABlockThatHitsAPlane) {
  for (const auto& [h, friction] : {std::pair(0.01, 0.0), {0.1, 0.0}, {0.01, 0.3}}) {
    SCOPED_TRACE(testing::Message() << "h " << h << " friction " << friction);
    Solids solids = block_above(-0.1, {ElementKind::quad9, Dilatation::mean});
    solids.contact->friction = friction;
    const SolidSystem system(solids, gravity, alone());
    SolidStep step(system);
    SolidState state = moving(solids, 0.2, -1);
    step.look_at_contact(state);
    const double first = energy_of(system, state);
    double last = first, most_pressing = 0;
    for (int k = 0; k < 20; ++k, state.time += h) {
      ASSERT_TRUE(step.advance_by_euler(state, h).converged) << k;
      const double now = energy_of(system, state), booked = state.damped + state.contact.damped + state.contact.rubbed;
      EXPECT_LT(now, last);
      EXPECT_NEAR(now + booked, first, 1e-8 * std::abs(first)) << k;
      last = now, most_pressing = std::max(most_pressing, state.contact.last.pressing);
      for (std::size_t y = 1; y < state.q.size(); y += 2) EXPECT_GT(state.q[y], -0.1);
    }
    EXPECT_GT(most_pressing, 0);
  }
}

}  // namespace
}  // namespace tether::fem
