// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "physics/points/state.hpp"
#include "unit/physics/points/robust_support.hpp"

namespace tether::scenes {

constexpr Membrane both_ways{30, 0.3, true, Membrane::Kind::plane_stress};
constexpr Membrane two_way{30, 0.3, false, Membrane::Kind::plane_stress};
constexpr Membrane string{30, 0, true};

/// A state whose points have moved, and its first membrane's elements.
struct Chain {
  Scene scene;
  mpm::State state;
  explicit Chain(Scene s) : scene(std::move(s)), state(mpm::start(scene)) {}
  mpm::Elements& elements() { return *state.elements_of[0]; }
  mpm::Points& points() { return state.points; }
  void update() {
    std::size_t bad = 0;
    EXPECT_TRUE(elements().update(points(), bad));
  }
  double energy() { return elements().strain_energy(points()) + elements().ambient_energy(points()); }
  Pair total_force() {
    Pair sum{};
    for (std::size_t p = 0; p < points().size(); ++p) sum += elements().force(p);
    return sum;
  }
};

}  // namespace tether::scenes
