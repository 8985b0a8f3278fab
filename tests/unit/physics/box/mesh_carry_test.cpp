// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "unit/physics/box/mesh_support.hpp"

// How velocities are carried from one mesh to the next.

namespace tether::coupled {
namespace {

using std::numbers::pi;
using support::Flowing, support::box_of;

/// In a step in which nothing goes anywhere velocities stay, whatever they are: else the error of many short steps
/// would grow with their number.
TEST(MeshFlow, WhatDoesNotMoveStays) {
  for (const int dim : {2, 3}) {
    Flowing at(box_of(dim == 2 ? 0.1 : 0.3, dim),
               support::hollow_block(dim, 2, {0.52, 0.47, dim == 3 ? 0.5 : 0.0}, 0.4, 0.3));
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
      for (std::size_t cell = 0; cell < at.mesh().cells(); ++cell)
        at.state.v[a][cell] = std::sin(static_cast<double>(17 * cell * cell + a));
    }
    const FaceValues before = at.state.v;
    at.flow.begin(at.state, 1e-9);
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
      for (std::size_t cell = 0; cell < at.mesh().cells(); ++cell)
        EXPECT_NEAR(at.state.v[a][cell], before[a][cell], 1e-6) << dim;
    }
  }
}

Vec<3> vortex(const Vec<3>& x) {
  return {std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1]), 0};
}

/// On few cells about a block that stands in a vortex, short steps would make energy of their errors.
TEST(MeshFlow, AVortexAboutABlockGainsNothing) {
  constexpr int n = 12;
  constexpr double cfl = 0.05;
  Flowing at(box_of(1.316 / n), support::hollow_block(2, 2, {0.3, 0.6, 0}, 0.2, 0.1));
  at.set(vortex);
  at.project();
  const double first = at.energy();
  for (int step = 0; step < 8 * n / cfl; ++step) {  // four turns
    at.flow.begin(at.state, cfl / n);
    const double carried = at.energy();
    at.project();
    at.state.books.projected += carried - at.energy();
    ASSERT_LT(at.energy(), 1.01 * first);
  }
  EXPECT_GT(at.energy(), 0.8 * first);
}

/// A vortex in the unit square loses some of its energy by being carried along to a new mesh in each step, and gains
/// none.
TEST(MeshFlow, AVortexTurns) {
  constexpr int n = 32;  // of a grid with as many velocities
  auto flowing = std::make_unique<Flowing>(box_of(1.316 / n), Mesh{});
  flowing->set(vortex);
  flowing->project();
  const double first = flowing->energy();
  double before = first;
  for (int step = 0; step < 2 * n; ++step) {  // one turn of its middle
    auto next = std::make_unique<Flowing>(box_of(1.316 / n * (1 + 0.1 * std::sin(2.3 * (step + 1)))), Mesh{});
    EXPECT_NE(next->mesh().x, flowing->mesh().x);
    const auto as_it_is = [](const MeshVelocity::Origin&, const Vec<3>& v) { return v; };
    next->set([](const Vec<3>&) { return Vec<3>{}; });
    Carried carried{next->state.v, next->state.v};
    carry_to(next->mesh(), MeshVelocity(flowing->mesh(), flowing->state.v), 1.0 / n, as_it_is, carried);
    next->state.v = std::move(carried.v);
    next->project();
    EXPECT_LT(next->energy(), before);
    before = next->energy();
    flowing = std::move(next);
  }
  EXPECT_GT(before / first, 1 - 0.28);
}

}  // namespace
}  // namespace tether::coupled
