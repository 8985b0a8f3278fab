// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/smoke.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/alone.hpp"
#include "unit/physics/box/support.hpp"
#include "unit/total.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using std::numbers::pi;
using Place = std::array<double, 3>;

Place middle_of(const StaggeredGrid& grid, std::size_t c) {
  const auto cell = grid.place_of_cell(c);
  return {grid.middle(0, cell[0]), grid.middle(1, cell[1]), grid.middle(2, cell[2])};
}

template <class Density>
Smoke smoke_of(const FlowDomain& domain, const Density& density) {
  Smoke smoke = clean_smoke(domain);
  for (std::size_t c = 0; c < smoke.volume.size(); ++c) {
    smoke.smoke[c] = smoke.volume[c] * density(middle_of(domain.grid, c));
    smoke.heat[c] = -2 * smoke.smoke[c];
  }
  return smoke;
}

// A whirl whose fluxes out of each cell cancel: differences of a stream function.
double stream(double x, double y) { return std::pow(std::sin(pi * x) * std::sin(pi * y), 2) / pi; }

FaceValues whirl_without_sources(const StaggeredGrid& grid) {
  return faces_of(grid, [&](const Place& x) {
    const double dx = grid.d[0] / 2, dy = grid.d[1] / 2;
    return Place{(stream(x[0], x[1] + dy) - stream(x[0], x[1] - dy)) / (2 * dy),
                 -(stream(x[0] + dx, x[1]) - stream(x[0] - dx, x[1])) / (2 * dx), 0};
  });
}

double bump(const Place& x) {
  return 1 + std::cos(pi * x[0]) * std::cos(2 * pi * x[1]) * (1 + 0.5 * std::cos(pi * x[2]));
}

double error_of_whirl(int dim, int n) {
  const FlowDomain domain = box(unit_box(dim, n));
  const FaceValues v = whirl_without_sources(domain.grid);
  Smoke smoke = smoke_of(domain, bump);
  const double time = 0.25;
  for (int i = 0; i < n / 4; ++i) carry_smoke(alone(), domain, v, 4 * time / n, {}, smoke);
  double error = 0;
  for (std::size_t c = 0; c < smoke.volume.size(); ++c)
    error += std::abs(smoke.density(c) - bump(origin(middle_of(domain.grid, c), time, 40))) * domain.grid.volume();
  return error;
}

TEST(Smoke, AWhirlToSecondOrder) {
  EXPECT_LT(error_of_whirl(2, 64), 1.2e-3);
  EXPECT_GT(std::log2(error_of_whirl(2, 32) / error_of_whirl(2, 64)), 1.9);
  EXPECT_LT(error_of_whirl(3, 24), 9e-3);
  EXPECT_GT(std::log2(error_of_whirl(3, 12) / error_of_whirl(3, 24)), 1.9);
}

// The same everywhere stays the same everywhere, nothing is lost, and what was between bounds stays so, in any flow
// whatever, with sources, and through as long a step.
TEST(Smoke, BoundsAndSumsInAnyFlow) {
  for (const int dim : {2, 3}) {
    FlowDomain domain = box(unit_box(dim, 8));
    fill_cell(domain, {2, 3, 0});
    fill_cell(domain, {5, 5, 0}, CellKind::wall);
    FaceValues v = faces_of(domain.grid, [](const Place& x) {
      return Place{std::sin(30 * x[0] + 7 * x[1]), std::cos(20 * x[1] - x[0]), std::sin(9 * x[2] + x[0])};
    });
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
      for (std::size_t f = 0; f < v[a].size(); ++f) v[a][f] *= domain.face[a][f] != FaceKind::prescribed;
    }
    for (const double h : {0.05, 5.0}) {
      Smoke even = smoke_of(domain, [](const Place&) { return 0.7; }),
            uneven = smoke_of(domain, [](const Place&x) { return std::sin(50 * x[0] * x[1]) > 0 ? 1.0 : 0.0; });
      const double before = total(uneven.smoke), volume = total(uneven.volume);
      for (int i = 0; i < 20; ++i) {
        carry_smoke(alone(), domain, v, h, {}, even);
        carry_smoke(alone(), domain, v, h, {}, uneven);
      }
      EXPECT_NEAR(total(uneven.smoke), before, 1e-13);
      EXPECT_NEAR(total(uneven.heat), -2 * before, 1e-13);
      EXPECT_NEAR(total(uneven.volume), volume, 1e-13);
      for (std::size_t c = 0; c < even.volume.size(); ++c) {
        if (domain.kind[c] != CellKind::fluid) {
          EXPECT_EQ(even.volume[c], 0);
          continue;
        }
        EXPECT_GT(even.volume[c], 0);
        EXPECT_NEAR(even.density(c), 0.7, 1e-12);
        EXPECT_TRUE(uneven.density(c) > -1e-12 && uneven.density(c) < 1 + 1e-12) << uneven.density(c);
        EXPECT_NEAR(uneven.temperature(c), -2 * uneven.density(c), 1e-12);
      }
    }
  }
}

// A channel along x with a jet on its left, an open side or void on its right.
TEST(Smoke, WhatJetsBringAndWhatLeavesIsTold) {
  StaggeredGrid grid = unit_box(2, 8);
  FlowDomain domain = box(grid);
  std::vector<SmokeJet> jets;
  FaceValues v = faces_of(grid, [](const Place&) { return Place{0.5, 0, 0}; });
  for (int j = 0; j < 8; ++j) {
    domain.face[0][grid.face(0, 8, j, 0)] = FaceKind::open;
    domain.kind[grid.cell(7, j, 0)] = j < 4 ? CellKind::fluid : CellKind::empty;
    jets.insert(jets.begin(), {0, grid.face(0, 0, j, 0), 3, j < 4 ? 5.0 : -1.0});
  }
  Smoke smoke = clean_smoke(domain);
  SmokeFlow all;
  for (int i = 0; i < 40; ++i) {
    const SmokeFlow flow = carry_smoke(alone(), domain, v, 0.1, jets, smoke);
    EXPECT_NEAR(flow.smoke_in, 0.5 * 0.1 * 3, 1e-14);
    EXPECT_NEAR(flow.heat_in, 0.5 * 0.1 * 2, 1e-14);
    all.smoke_out += flow.smoke_out, all.heat_out += flow.heat_out;
    EXPECT_NEAR(total(smoke.smoke) + all.smoke_out, 0.15 * (i + 1), 1e-12);
    EXPECT_NEAR(total(smoke.heat) + all.heat_out, 0.1 * (i + 1), 1e-12);
    EXPECT_TRUE(i > 8 || all.smoke_out < 0.01);
  }
  EXPECT_NEAR(smoke.density(grid.cell(6, 6, 0)), 3, 1e-3);
  EXPECT_NEAR(smoke.temperature(grid.cell(7, 2, 0)), 5, 1e-2);
  // The other way round clean fluid comes in.
  for (double& u : v[0]) u = -0.5;
  const SmokeFlow flow = carry_smoke(alone(), domain, v, 4, {}, smoke);
  EXPECT_EQ(flow.smoke_in, 0);
  EXPECT_NEAR(flow.smoke_out, 3, 0.3);
  EXPECT_NEAR(total(smoke.volume), 60.0 / 64, 1e-12);
}

// What is on one side of a plate in the middle does not depend on what is on the other; even if its faces had an area.
TEST(Smoke, NothingCrossesAClosedFace) {
  for (const int dim : {2, 3}) {
    FlowDomain domain = box(unit_box(dim, 8));
    for (int k = 0; k < domain.grid.n[2]; ++k) {
      for (int j = 0; j < 8; ++j) close_face(domain, 0, {4, j, k});
    }
    domain.area[0].assign(domain.area[0].size(), domain.grid.area(0));
    FaceValues v = faces_of(domain.grid, [](const Place& x) {
      return Place{std::cos(9 * x[1]), std::sin(9 * x[0]), 1};
    });
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim); ++a) {
      for (std::size_t f = 0; f < v[a].size(); ++f) v[a][f] *= domain.face[a][f] != FaceKind::prescribed;
    }
    const auto carried = [&](double left, double right) {
      Smoke smoke = smoke_of(
          domain, [&](const Place& x) { return (2 + std::sin(9 * x[0] + x[1])) * (x[0] < 0.5 ? left : right); });
      for (int i = 0; i < 10; ++i) carry_smoke(alone(), domain, v, 0.1, {}, smoke);
      return smoke;
    };
    const Smoke both = carried(1, 5), left = carried(1, 0), right = carried(0, 5);
    for (std::size_t c = 0; c < both.volume.size(); ++c) {
      const bool is_left = middle_of(domain.grid, c)[0] < 0.5;
      EXPECT_EQ(both.smoke[c], (is_left ? left : right).smoke[c]);
      EXPECT_EQ((is_left ? right : left).smoke[c], 0);
    }
  }
}

TEST(Smoke, ItRisesByWarmthAndSinksByWeight) {
  FlowDomain domain = box(unit_box(2, 4));
  fill_cell(domain, {1, 1, 0});
  const StaggeredGrid& grid = domain.grid;
  Smoke smoke = clean_smoke(domain);
  const std::size_t low = grid.cell(3, 1, 0), high = grid.cell(3, 2, 0);
  smoke.volume[low] *= 0.5;
  smoke.smoke[low] = 2 * smoke.volume[low], smoke.heat[low] = 3 * smoke.volume[low];
  smoke.heat[high] = 1 * smoke.volume[high];
  FaceValues v = face_values(grid, 1);
  add_buoyancy(domain, smoke, 10, 7, 0.1, v);
  EXPECT_NEAR(v[1][grid.face(1, 3, 2, 0)], 1 + 0.1 * (10 * 2 - 7 * 1), 1e-14);
  EXPECT_NEAR(v[1][grid.face(1, 3, 1, 0)], 1 + 0.1 * (10 * 1.5 - 7 * 1), 1e-14);
  EXPECT_EQ(v[1][grid.face(1, 2, 2, 0)], 1);
  EXPECT_EQ(v[0], face_values(grid, 1)[0]);
  // Beside the void, only the fluid counts; and closed faces are left alone.
  domain.kind[high] = CellKind::empty;
  close_face(domain, 1, {3, 1, 0});
  FaceValues u = face_values(grid);
  add_buoyancy(domain, smoke, 10, 7, 0.1, u);
  EXPECT_NEAR(u[1][grid.face(1, 3, 2, 0)], 0.1 * (30 - 14), 1e-14);
  EXPECT_EQ(u[1][grid.face(1, 3, 1, 0)], 0);
}

}  // namespace
}  // namespace tether::coupled
