// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/carry_velocity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/alone.hpp"
#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using std::numbers::pi;
using Place = std::array<double, 3>;

Place waves(const Place& x) {
  return {std::cos(2 * x[0] + 3 * x[1]), std::sin(3 * x[0] - x[1]) + x[0], std::cos(x[0] + 2 * x[1])};
}

double error_of_whirl(int dim, int n, Advection advection) {
  const FlowDomain domain = box(unit_box(dim, n));
  const FaceValues v = faces_of(domain.grid, whirl);
  FaceValues now = faces_of(domain.grid, waves), next = now;
  const double time = 0.25;
  const int steps = n / 4;
  for (int i = 0; i < steps; ++i) {
    carry(alone(), domain, v, now, time / steps, advection, next);
    now.swap(next);
  }
  return mean_distance(domain, now, faces_of(domain.grid, [&](const Place& x) { return waves(origin(x, time, 20)); }));
}

TEST(Carry, AWhirlToSecondOrder) {
  const auto error = [](int dim, int n) { return error_of_whirl(dim, n, Advection::maccormack); };
  EXPECT_LT(error(2, 64), 4e-4);
  EXPECT_GT(std::log2(error(2, 32) / error(2, 64)), 1.9);
  EXPECT_LT(error(3, 24), 3e-3);
  EXPECT_GT(std::log2(error(3, 12) / error(3, 24)), 1.8);
}

TEST(Carry, AWhirlToFirstOrderWithoutTheCorrection) {
  const auto error = [](int n) { return error_of_whirl(2, n, Advection::semi_lagrangian); };
  EXPECT_LT(error(64), 4e-3);
  EXPECT_GT(std::log2(error(32) / error(64)), 0.95);
  EXPECT_GT(error(64), 5 * error_of_whirl(2, 64, Advection::maccormack));
}

// By as many cells as the fluid moves, whatever is carried; and what comes in has the side's value.
TEST(Carry, WholeCellsAreExact) {
  for (const int dim : {2, 3}) {
    const FlowDomain domain = box(unit_box(dim, 8), FaceKind::open);
    const FaceValues v = faces_of(domain.grid,
                                  [](const Place&) {
                                    return Place{1, 2, 0};
                                  }),
                     carried = faces_of(domain.grid, waves);
    for (const auto advection : {Advection::semi_lagrangian, Advection::maccormack}) {
      FaceValues out = face_values(domain.grid);
      carry(alone(), domain, v, carried, 0.125, advection, out);
      for (int axis = 0; axis < dim; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        for (std::size_t f = 0; f < out[a].size(); ++f) {
          const auto to = domain.grid.place_of_face(axis, f);
          if (to[0] < 1 || to[1] < 2) continue;
          EXPECT_NEAR(out[a][f], carried[a][domain.grid.face(axis, to[0] - 1, to[1] - 2, to[2])], 1e-13);
        }
      }
    }
  }
}

TEST(Carry, AParallelFlowStaysAndSoDoesWhatComesIn) {
  const FlowDomain domain = box(unit_box(2, 16), FaceKind::open);
  const FaceValues v = faces_of(domain.grid, [](const Place& x) { return Place{1 + x[1] * x[1], 0, 0}; });
  for (const auto advection : {Advection::semi_lagrangian, Advection::maccormack}) {
    FaceValues out = face_values(domain.grid);
    carry_velocity(alone(), domain, v, 0.3, advection, out);
    EXPECT_LT(largest_distance(domain, v, out), 1e-14);
  }
}

TEST(Carry, PrescribedAndClosedFacesKeepTheirs) {
  FlowDomain domain = box(unit_box(2, 8));
  close_face(domain, 0, {4, 4, 0});
  const FaceValues v = faces_of(domain.grid, waves);
  FaceValues out = face_values(domain.grid);
  carry_velocity(alone(), domain, v, 0.1, Advection::maccormack, out);
  for (int axis = 0; axis < 2; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    int kept = 0;
    for (std::size_t f = 0; f < out[a].size(); ++f) {
      if (domain.face[a][f] == FaceKind::open) continue;
      EXPECT_EQ(out[a][f], v[a][f]);
      ++kept;
    }
    EXPECT_EQ(kept, axis == 0 ? 17 : 16);
  }
}

// A plate without thickness across the box, with a step in it. What a side sees does not depend on the other's flow,
// how fast ever, nor on what the plate's own faces hold.
void expect_that_nothing_comes_through(int dim, Advection advection, bool left_sees) {
  FlowDomain domain = box(unit_box(dim, 8));
  for (int k = 0; k < domain.grid.n[2]; ++k) {
    for (int j = 0; j < 8; ++j) close_face(domain, 0, {j < 3 ? 3 : 5, j, k});
    for (int i = 3; i < 5; ++i) close_face(domain, 1, {i, 3, k});
  }
  const auto sees = [&](int axis, std::size_t f) {
    const Place x = middle_of_face(domain.grid, axis, f);
    const bool left = x[0] < (x[1] < 0.3751 ? 0.376 : 0.626);
    return left == left_sees && domain.face[static_cast<std::size_t>(axis)][f] != FaceKind::closed;
  };
  const auto flow = [&](double unseen) {
    FaceValues v = faces_of(domain.grid, [](const Place& x) {
      return Place{9 * waves(x)[0], 9 * waves(x)[1], 5 * x[0]};
    });
    for (int axis = 0; axis < dim; ++axis) {
      auto& u = v[static_cast<std::size_t>(axis)];
      for (std::size_t f = 0; f < u.size(); ++f) u[f] *= sees(axis, f) ? 1 : unseen;
    }
    return v;
  };
  FaceValues one = face_values(domain.grid), other = one;
  const FaceValues start = flow(2);
  carry_velocity(alone(), domain, start, 0.1, advection, one);
  carry_velocity(alone(), domain, flow(-1e6), 0.1, advection, other);
  int seen = 0, moved = 0;
  for (int axis = 0; axis < dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    for (std::size_t f = 0; f < one[a].size(); ++f) {
      if (!sees(axis, f)) continue;
      EXPECT_EQ(one[a][f], other[a][f]) << axis << ' ' << f;
      ++seen, moved += one[a][f] != start[a][f];
    }
  }
  EXPECT_GT(moved, seen / 2);
}

TEST(Carry, NothingComesThroughAPlate) {
  for (const int dim : {2, 3}) {
    for (const auto advection : {Advection::semi_lagrangian, Advection::maccormack}) {
      expect_that_nothing_comes_through(dim, advection, true);
      expect_that_nothing_comes_through(dim, advection, false);
    }
  }
}

// Values lie between those carried, whatever the step.
TEST(Carry, NoNewExtremaInLongSteps) {
  FlowDomain domain = box(unit_box(2, 16));
  fill_cell(domain, {7, 7, 0});
  fill_cell(domain, {9, 5, 0}, CellKind::wall);
  const FaceValues v = faces_of(domain.grid,
                                [](const Place&x) {
                                  return Place{50 * waves(x)[0], 50 * waves(x)[1], 0};
                                }),
                   steps = faces_of(domain.grid, [](const Place&x) {
                     const double s = std::sin(40 * x[0]) * std::sin(40 * x[1]) > 0;
                     return Place{s, 1 - s, 0};
                   });
  FaceValues out = face_values(domain.grid);
  carry(alone(), domain, v, steps, 1, Advection::maccormack, out);
  for (std::size_t a = 0; a < 2; ++a) {
    for (const double u : out[a]) EXPECT_TRUE(u > -1e-14 && u < 1 + 1e-14) << u;
  }
}

// What is no number stays so where it is seen, and the paths end.
TEST(Carry, VelocitiesThatAreNoNumbers) {
  const FlowDomain domain = box(unit_box(2, 8));
  for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
    FaceValues v = faces_of(domain.grid, whirl);
    v[0][domain.grid.face(0, 4, 4, 0)] = bad;
    FaceValues out = face_values(domain.grid);
    carry_velocity(alone(), domain, v, 0.1, Advection::maccormack, out);
    EXPECT_TRUE(std::isfinite(out[0][domain.grid.face(0, 1, 1, 0)]));
  }
}

}  // namespace
}  // namespace tether::coupled
