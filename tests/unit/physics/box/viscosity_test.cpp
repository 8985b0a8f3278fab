// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/friction/viscosity.hpp"

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

constexpr double tolerance = 1e-13;

int rub(const FlowDomain& domain, FaceValues& v, double nu, double h, const FaceValues& driven = {},
        Beyond beyond = Beyond::fluid) {
  const RubbingFluid fluid{domain, 1, nu, all_liquid, beyond, nullptr};
  return Friction(fluid, {}, h).act(alone(), {}, {}, tolerance, driven, v).iterations;
}

// A box with walls on all sides but those across x.
FlowDomain channel(const StaggeredGrid& grid) {
  FlowDomain domain = box(grid);
  for (std::size_t f = 0; f < grid.face_count(0); ++f) domain.face[0][f] = FaceKind::open;
  return domain;
}

void let_slip(FlowDomain& domain) { domain.slips.fill(true); }

// A shear wave along x: its relative error after it has lost about half, in steps of a length as the square of a cell.
double error_of_wave(int dim, int n, bool no_slip) {
  FlowDomain domain = channel(unit_box(dim, n));
  if (!no_slip) let_slip(domain);
  const auto wave = [&](const Place& x) {
    double u = 1;
    for (std::size_t b = 1; b < static_cast<std::size_t>(dim); ++b)
      u *= no_slip ? std::sin(pi * x[b]) : std::cos(pi * x[b]);
    return Place{u, 0, 0};
  };
  FaceValues v = faces_of(domain.grid, wave);
  const double nu = 0.3, time = 0.2, left = std::exp(-pi * pi * (dim - 1) * nu * time);
  const int steps = n * n / 2;
  for (int i = 0; i < steps; ++i) rub(domain, v, nu, time / steps);
  return largest_distance(domain, v, faces_of(domain.grid, [&](const Place& x) {
                            return Place{left * wave(x)[0], 0, 0};
                          }));
}

TEST(Viscosity, AShearWaveDecaysToSecondOrder) {
  for (const bool no_slip : {true, false}) {
    for (const int dim : {2, 3}) {
      const double fine = error_of_wave(dim, 16, no_slip);
      EXPECT_LT(fine, 6e-3);
      EXPECT_GT(std::log2(error_of_wave(dim, 8, no_slip) / fine), 1.9);
    }
  }
}

/// One long step ends in the flow that stays, if what drives it acts meanwhile.
double error_of_poiseuille(int n) {
  const FlowDomain domain = channel(unit_box(2, n));
  const double nu = 0.5, pull = 3, h = 1e4;
  FaceValues v = face_values(domain.grid), driven = face_values(domain.grid);
  driven[0].assign(driven[0].size(), pull);
  rub(domain, v, nu, h, driven);
  for (double& u : v[0]) u += h * pull;
  const auto parabola = [&](const Place& x) { return Place{pull / (2 * nu) * x[1] * (1 - x[1]), 0, 0}; };
  return largest_distance(domain, v, faces_of(domain.grid, parabola));
}

TEST(Viscosity, APullBetweenWallsTendsToAParabola) {
  EXPECT_LT(error_of_poiseuille(16), 4e-3);
  EXPECT_GT(std::log2(error_of_poiseuille(8) / error_of_poiseuille(16)), 1.9);
}

// A channel between obstacles is one between walls.
TEST(Viscosity, ObstaclesHoldAsWallsDo) {
  StaggeredGrid grid = unit_box(2, 8);
  grid.n[1] = 12;
  FlowDomain narrowed = channel(grid);
  for (int i = 0; i < 8; ++i) {
    for (const int j : {0, 1, 10, 11}) fill_cell(narrowed, {i, j, 0}, CellKind::wall);
  }
  const FlowDomain domain = channel(unit_box(2, 8));
  const auto wave = [](double x, double y) { return Place{std::sin(3 * x + 5 * y), std::cos(4 * x - y), 0}; };
  for (const Beyond beyond : {Beyond::fluid, Beyond::nothing}) {
    FaceValues v = faces_of(domain.grid, [&](const Place&x) { return wave(x[0], x[1]); }),
               w = faces_of(grid, [&](const Place&x) { return wave(x[0], x[1] - 0.25); });
    for (int i = 0; i < 8; ++i) {
      v[1][domain.grid.face(1, i, 0, 0)] = v[1][domain.grid.face(1, i, 8, 0)] = 0;
      w[1][grid.face(1, i, 2, 0)] = w[1][grid.face(1, i, 10, 0)] = 0;
    }
    const FaceValues start = v;
    rub(domain, v, 0.1, 0.1, {}, beyond);
    rub(narrowed, w, 0.1, 0.1, {}, beyond);
    EXPECT_GT(largest_distance(domain, start, v), 0.1);
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 9; ++i)
        EXPECT_NEAR(v[0][domain.grid.face(0, i, j, 0)], w[0][grid.face(0, i, j + 2, 0)], 1e-11);
      for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(v[1][domain.grid.face(1, i, j, 0)], w[1][grid.face(1, i, j + 2, 0)], 1e-11);
    }
  }
}

// Beside solids, and walls without friction, a flow along them stays.
TEST(Viscosity, AFlowAlongSolidsStays) {
  StaggeredGrid grid = unit_box(3, 6);
  FlowDomain domain = channel(grid);
  for (int i = 0; i < 6; ++i) fill_cell(domain, {i, 2, 3});
  close_face(domain, 0, {3, 4, 4});
  FaceValues start = faces_of(grid, [](const Place&) { return Place{2, 0, 0}; });
  for (std::size_t f = 0; f < start[0].size(); ++f) {
    if (domain.face[0][f] == FaceKind::closed) start[0][f] = 99;
  }
  FaceValues v = start;
  rub(domain, v, 1, 1);
  EXPECT_GT(largest_distance(domain, start, v), 1);
  v = start;
  let_slip(domain);
  rub(domain, v, 1, 1);
  EXPECT_LT(largest_distance(domain, start, v), 1e-12);
}

TEST(Viscosity, NothingIsExchangedThroughAPlate) {
  FlowDomain domain = channel(unit_box(2, 8));
  for (int i = 0; i < 8; ++i) close_face(domain, 1, {i, 3, 0});
  let_slip(domain);
  const auto flow = [&](double above) {
    return faces_of(domain.grid, [&](const Place& x) { return Place{x[1] < 0.375 ? 1 : above, 0, 0}; });
  };
  FaceValues v = flow(5);
  rub(domain, v, 1, 1);
  EXPECT_LT(largest_distance(domain, v, flow(5)), 1e-12);
}

// However long the step, velocities stay between those there were, and no friction leaves them alone.
TEST(Viscosity, LongStepsAreStable) {
  const FlowDomain domain = channel(unit_box(2, 16));
  const FaceValues start = faces_of(domain.grid, [](const Place& x) {
    const double s = std::sin(50 * x[0]) * std::sin(40 * x[1]) > 0;
    return Place{s, 0, 0};
  });
  FaceValues v = start;
  EXPECT_EQ(rub(domain, v, 0, 1), 0);
  EXPECT_EQ(v, start);
  for (const double nu : {1.0, 1e3, 1e6}) {
    v = start;
    rub(domain, v, nu, 0.05);
    for (const double u : v[0]) EXPECT_TRUE(u >= -1e-12 && u < 0.5) << u;
  }
}

}  // namespace
}  // namespace tether::coupled
