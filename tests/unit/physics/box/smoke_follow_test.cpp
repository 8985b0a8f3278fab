// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/smoke_follow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/alone.hpp"
#include "unit/physics/box/support.hpp"
#include "unit/total.hpp"

namespace tether::coupled {
namespace {

using namespace support;
using Cell = std::array<int, 3>;

void fill(Smoke& smoke, std::size_t c, double density, double temperature = 0) {
  smoke.smoke[c] = density * smoke.volume[c], smoke.heat[c] = temperature * smoke.volume[c];
}

// A row of six cells of volume 1 with walls around.
FlowDomain row() {
  StaggeredGrid grid;
  grid.n = {6, 1, 1};
  return box(grid);
}

TEST(SmokeFollow, ASolidPushesContentsOnAndLetsTheCellBehindFill) {
  FlowDomain before = row(), now = row();
  fill_cell(before, {2, 0, 0});
  fill_cell(now, {3, 0, 0});
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, static_cast<double>(c + 1), 10);
  smoke.volume[3] = 0.5, fill(smoke, 3, 4, 10);
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 0.5, 0.5, 0, 1.5, 1}));
  EXPECT_EQ(smoke.smoke, (std::vector<double>{1, 1, 1, 0, 5 + 0.5 * 4, 6}));
  EXPECT_EQ(smoke.heat, (std::vector<double>{10, 5, 5, 0, 15, 10}));
  const Smoke same = smoke;
  follow_domain(now, now, smoke);
  EXPECT_EQ(smoke.smoke, same.smoke);
}

// Two cells at once: contents go over the other that goes, and fluid comes over the other that is new.
TEST(SmokeFollow, MoreThanOneCellAtOnce) {
  FlowDomain before = row(), now = row();
  for (const int i : {1, 2}) fill_cell(before, {i, 0, 0});
  for (const int i : {3, 4}) fill_cell(now, {i, 0, 0});
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, static_cast<double>(c + 1));
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{0.5, 0.25, 0.25, 0, 0, 3}));
  EXPECT_EQ(smoke.smoke, (std::vector<double>{0.5, 0.25, 0.25, 0, 0, 4 + 5 + 6}));
}

// A plate without thickness goes over a cell: what was before it stays before it.
TEST(SmokeFollow, APlateSweeps) {
  FlowDomain before = row(), now = row();
  close_face(before, 0, {2, 0, 0});
  close_face(now, 0, {3, 0, 0});
  Smoke smoke = clean_smoke(before);
  smoke.volume = {1, 1.5, 0.5, 1, 1, 1};
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, c < 2 ? 1 : 0);
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 0.75, 0.75, 1.5, 1, 1}));
  EXPECT_EQ(smoke.smoke, (std::vector<double>{1, 0.75, 0.75, 0, 0, 0}));
}

TEST(SmokeFollow, AFastPlateSweepsCellsInARow) {
  FlowDomain before = row(), now = row();
  close_face(before, 0, {2, 0, 0});
  close_face(now, 0, {4, 0, 0});
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, c < 2 ? 1 : 0);
  Smoke back = smoke;
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 0.5, 0.25, 0.25, 3, 1}));
  EXPECT_EQ(smoke.smoke, (std::vector<double>{1, 0.5, 0.25, 0.25, 0, 0}));
  follow_domain(now, before, back);
  EXPECT_EQ(back.volume, (std::vector<double>{1, 3, 0.25, 0.25, 0.5, 1}));
  EXPECT_EQ(back.smoke, (std::vector<double>{1, 1, 0, 0, 0, 0}));
}

// Beside the end of a plate nothing goes around it; between two that meet it stays.
TEST(SmokeFollow, PlatesThatEndOrMeet) {
  StaggeredGrid grid;
  grid.n = {6, 2, 1};
  FlowDomain before = box(grid), now = before;
  close_face(before, 0, {2, 0, 0});
  close_face(now, 0, {3, 0, 0});
  Smoke smoke = clean_smoke(before);
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 0.75, 0.25 + 0.25, 2, 1, 1, 1, 1, 0.75, 1, 1, 1}));

  FlowDomain apart = row(), met = row();
  close_face(apart, 0, {2, 0, 0}), close_face(apart, 0, {4, 0, 0});
  close_face(met, 0, {3, 0, 0});
  smoke = clean_smoke(apart);
  fill(smoke, 2, 1), fill(smoke, 3, 2);
  follow_domain(apart, met, smoke);
  EXPECT_EQ(smoke.smoke, (std::vector<double>{0, 0, 1, 2, 0, 0}));
}

// Of two ways to fluid that stays the shorter, by the faces that were open.
TEST(SmokeFollow, ContentsGoTheShorterWay) {
  const FlowDomain before = row();
  FlowDomain now = row(), apart = row();
  for (const int i : {2, 3, 4}) fill_cell(now, {i, 0, 0});
  Smoke smoke = clean_smoke(before);
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 2.5, 0, 0, 0, 2.5}));
  close_face(apart, 0, {2, 0, 0});
  smoke = clean_smoke(before);
  follow_domain(apart, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 1, 0, 0, 0, 4}));
}

TEST(SmokeFollow, FluidThatCannotGoOnGoesToTheNearestOrWaits) {
  FlowDomain before = box(unit_box(2, 5)), now = before, none = before;
  for (int j = 1; j < 4; ++j) {
    for (int i = 1; i < 4; ++i) {
      if (i != 2 || j != 2) fill_cell(before, {i, j, 0});
      fill_cell(now, {i, j, 0});
    }
  }
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) fill_cell(none, {i, j, 0});
  }
  const StaggeredGrid& grid = now.grid;
  Smoke smoke = clean_smoke(before);
  fill(smoke, grid.cell(2, 2, 0), 8);
  const double all = total(smoke.smoke), volume = total(smoke.volume);
  follow_domain(before, now, smoke);
  for (const Cell& to : {Cell{2, 0, 0}, Cell{2, 4, 0}, Cell{0, 2, 0}, Cell{4, 2, 0}})
    EXPECT_NEAR(smoke.smoke[grid.cell(to)], all / 4, 1e-15);
  follow_domain(now, none, smoke);
  EXPECT_NEAR(total(smoke.smoke), all, 1e-15);
  // Fluid again, at a corner: it gets all that waited.
  FlowDomain corner = none;
  corner.kind[0] = CellKind::fluid;
  follow_domain(none, corner, smoke);
  EXPECT_NEAR(smoke.smoke[0], all, 1e-15);
  EXPECT_NEAR(smoke.volume[0], volume, 1e-14);
}

TEST(SmokeFollow, NewFluidOfItsOwnIsClean) {
  FlowDomain before = row(), now = row();
  for (const int i : {0, 1, 2}) fill_cell(before, {i, 0, 0});
  fill_cell(now, {2, 0, 0});
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 3; c < 6; ++c) fill(smoke, c, 2);
  follow_domain(before, now, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 1, 0, 1, 1, 1}));
  EXPECT_EQ(smoke.smoke, (std::vector<double>{0, 0, 0, 2, 2, 2}));
}

// A new cell between two that have fluid, one of which has another new one beside it.
TEST(SmokeFollow, NeighboursGiveEqualParts) {
  FlowDomain before = row(), now = row();
  for (const int i : {1, 3}) fill_cell(before, {i, 0, 0});
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, 1);
  follow_domain(before, now, smoke);
  const std::vector<double> expected{1 - 1.0 / 4, 1.0 / 4 + 1.0 / 6, 1 - 2.0 / 6, 1.0 / 6 + 1.0 / 4, 1 - 1.0 / 4, 1};
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_NEAR(smoke.volume[c], expected[c], 1e-15);
    EXPECT_NEAR(smoke.density(c), 1, 1e-14);
  }
}

TEST(SmokeSettle, VolumesTendToTheirOwnAndSumsStay) {
  FlowDomain domain = box(unit_box(3, 4));
  close_face(domain, 1, {1, 2, 2});
  fill_cell(domain, {3, 3, 3});
  Smoke smoke = clean_smoke(domain);
  std::vector<double> own = smoke.volume;
  own[5] *= 0.3;
  for (std::size_t c = 0; c < own.size(); ++c) {
    smoke.volume[c] *= 1 + 0.9 * std::sin(3.0 * static_cast<double>(c));
    fill(smoke, c, c % 3 == 0 ? 1 : 0, 5);
  }
  const double all = total(smoke.smoke), heat = total(smoke.heat), volume = total(smoke.volume);
  for (int i = 0; i < 800; ++i) settle_smoke(domain, own, smoke);
  EXPECT_NEAR(total(smoke.smoke), all, 1e-13);
  EXPECT_NEAR(total(smoke.heat), heat, 1e-13);
  for (std::size_t c = 0; c < own.size(); ++c) {
    EXPECT_NEAR(smoke.volume[c], own[c] * volume / total(own), 1e-9);
    if (own[c] == 0) continue;
    EXPECT_NEAR(smoke.temperature(c), 5, 1e-12);
    EXPECT_TRUE(smoke.density(c) >= 0 && smoke.density(c) <= 1);
  }
}

TEST(SmokeSettle, NothingThroughAPlateAndOneStepIsGentle) {
  FlowDomain domain = row();
  close_face(domain, 0, {3, 0, 0});
  const std::vector<double> own(6, 1.0);
  Smoke smoke = clean_smoke(domain);
  smoke.volume = {1, 1, 0.5, 2, 1, 1};
  for (std::size_t c = 0; c < 6; ++c) fill(smoke, c, c < 3 ? 0 : 1);
  settle_smoke(domain, own, smoke);
  EXPECT_EQ(smoke.volume, (std::vector<double>{1, 1 - 1.0 / 32, 0.5 + 1.0 / 32, 2 - 1.0 / 16, 1 + 1.0 / 16, 1}));
  EXPECT_EQ(smoke.smoke[2], 0);
}

// A plate goes along a channel with the fluid, which a jet brings: D v + B u = 0, the cell before the plate loses what
// the one behind it gains. Even smoke stays even; smoke behind it stays behind, and volumes are those there are.
TEST(SmokeFollow, APlateInAFlow) {
  StaggeredGrid grid;
  grid.n = {12, 3, 1};
  FlowDomain open = box(grid);
  FaceValues v = face_values(grid);
  std::vector<SmokeJet> jets;
  for (int j = 0; j < 3; ++j) {
    open.face[0][grid.face(0, 12, j, 0)] = FaceKind::open;
    jets.push_back({0, grid.face(0, 0, j, 0), 1, 7});
  }
  const auto plate_at = [&](double x) {
    FlowDomain domain = open;
    for (int j = 0; j < 3; ++j) close_face(domain, 0, {static_cast<int>(std::lround(x)), j, 0});
    return domain;
  };
  v[0].assign(v[0].size(), 1);
  double x = 3;
  FlowDomain before = plate_at(x);
  Smoke smoke = clean_smoke(before);
  for (std::size_t c = 0; c < smoke.volume.size(); ++c) fill(smoke, c, grid.place_of_cell(c)[0] < 3 ? 1 : 0, 7);
  const double start = total(smoke.smoke);
  for (int i = 1; i <= 40; ++i) {
    x += 0.15;
    const FlowDomain now = plate_at(x);
    follow_domain(before, now, smoke);
    const SmokeFlow flow = carry_smoke(alone(), now, v, 0.15, jets, smoke);
    EXPECT_NEAR(total(smoke.smoke), start + 3 * 0.15 * i, 1e-12);
    EXPECT_NEAR(flow.smoke_out, 0, 1e-15);
    double behind = 0;
    for (std::size_t c = 0; c < smoke.volume.size(); ++c) {
      const bool left = grid.place_of_cell(c)[0] < std::lround(x);
      EXPECT_NEAR(smoke.density(c), left ? 1 : 0, 1e-13);
      EXPECT_NEAR(smoke.temperature(c), 7, 1e-12);
      behind += left ? smoke.volume[c] : 0;
    }
    EXPECT_NEAR(behind, 3 * x, 1e-12);
    EXPECT_NEAR(total(smoke.volume), 36, 1e-12);
    before = now;
  }
}

// A block goes through a box, a cell in each step, with any flow around it.
TEST(SmokeFollow, ABlockLosesNothing) {
  for (const int dim : {2, 3}) {
    const StaggeredGrid grid = unit_box(dim, 8);
    FaceValues v = faces_of(grid, [](const auto& x) {
      return std::array{std::sin(20 * x[1] + x[0]), std::cos(15 * x[0]), std::sin(9 * x[0] + 7 * x[2])};
    });
    for (int axis = 0; axis < dim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      for (std::size_t f = 0; f < v[a].size(); ++f) v[a][f] *= !on_side(grid, axis, f);
    }
    FlowDomain before = box(grid);
    Smoke smoke = clean_smoke(before);
    const std::vector<double> own = smoke.volume;
    for (std::size_t c = 0; c < own.size(); ++c) fill(smoke, c, c % 5 < 2 ? 1 : 0, 3);
    const double all = total(smoke.smoke), heat = total(smoke.heat), volume = total(smoke.volume);
    for (int step = 0; step < 7; ++step) {
      FlowDomain now = box(grid);
      for (int k = 0; k < (dim == 3 ? 3 : 1); ++k) {
        for (int j = 2; j < 5; ++j) fill_cell(now, {step, j, k}), fill_cell(now, {step + 1, j, k});
      }
      follow_domain(before, now, smoke);
      for (std::size_t c = 0; c < own.size(); ++c) EXPECT_EQ(smoke.volume[c] > 0, now.kind[c] == CellKind::fluid);
      carry_smoke(alone(), now, v, 0.1, {}, smoke);
      settle_smoke(now, own, smoke);
      EXPECT_NEAR(total(smoke.smoke), all, 1e-12);
      EXPECT_NEAR(total(smoke.heat), heat, 1e-12);
      EXPECT_NEAR(total(smoke.volume), volume, 1e-12);
      for (std::size_t c = 0; c < own.size(); ++c) {
        if (now.kind[c] != CellKind::fluid) continue;
        EXPECT_NEAR(smoke.temperature(c), 3, 1e-12);
        EXPECT_TRUE(smoke.density(c) > -1e-12 && smoke.density(c) < 1 + 1e-12);
      }
      before = now;
    }
  }
}

}  // namespace
}  // namespace tether::coupled
