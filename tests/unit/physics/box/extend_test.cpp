// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/cut_faces.hpp"

#include <gtest/gtest.h>

#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

// A block of 4 x 4 cells in the middle of 8 x 8: across x it closes 5 x 4 faces.
FlowDomain box_with_block() {
  FlowDomain domain = box(unit_box(2, 8));
  for (int j = 2; j < 6; ++j) {
    for (int i = 2; i < 6; ++i) fill_cell(domain, {i, j, 0});
  }
  return domain;
}

TEST(Extension, LayerByLayerTheMeanOfNeighbours) {
  const FlowDomain domain = box_with_block();
  const StaggeredGrid& grid = domain.grid;
  const auto start = faces_of(grid, [](const auto& x) { return std::array<double, 3>{x[0], x[1], 0}; });
  FaceValues v = start;
  extend_velocity(domain, v, 1);
  // A corner has a neighbour beside it (x = 1/8) and one below (its own x, 1/4); a lower face only that below.
  EXPECT_DOUBLE_EQ(v[0][grid.face(0, 2, 2, 0)], (0.125 + 0.25) / 2);
  EXPECT_DOUBLE_EQ(v[0][grid.face(0, 4, 2, 0)], 0.5);
  EXPECT_DOUBLE_EQ(v[0][grid.face(0, 2, 3, 0)], 0.125);
  EXPECT_EQ(v[0][grid.face(0, 4, 3, 0)], 0);  // the second layer
  extend_velocity(domain, v = start, 2);
  EXPECT_DOUBLE_EQ(v[0][grid.face(0, 4, 3, 0)], 0.5);
  EXPECT_DOUBLE_EQ(v[0][grid.face(0, 3, 3, 0)], (0.375 + 0.125) / 2);
  EXPECT_DOUBLE_EQ(v[1][grid.face(1, 3, 3, 0)], (0.375 + 0.125) / 2);
}

TEST(Extension, OpenAndPrescribedFacesKeepTheirs) {
  const FlowDomain domain = box_with_block();
  FaceValues start = faces_of(domain.grid, [](const auto& x) { return std::array<double, 3>{x[0] + 1, x[1] - 3, 0}; });
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t f = 0; f < start[a].size(); ++f) {
      if (domain.face[a][f] == FaceKind::closed) start[a][f] = 99;
    }
  }
  FaceValues v = start;
  extend_velocity(domain, v, 9);
  int closed = 0;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) {
      const bool shut = domain.face[a][f] == FaceKind::closed;
      EXPECT_EQ(v[a][f] == start[a][f], !shut);
      closed += shut;
    }
  }
  EXPECT_EQ(closed, 40);
}

TEST(Extension, ItsOrderOfFacesDoesNotMatter) {
  FlowDomain domain = box(unit_box(3, 6));
  for (const auto& cell : {std::array{2, 2, 2}, {2, 3, 2}, {3, 2, 3}, {3, 3, 3}}) fill_cell(domain, cell);
  // The same turned by half a turn about the middle: what is extended turns, too.
  FlowDomain turned = box(unit_box(3, 6));
  for (const auto& cell : {std::array{3, 3, 3}, {3, 2, 3}, {2, 3, 2}, {2, 2, 2}}) fill_cell(turned, cell);
  const auto wave = [](const auto& x) {
    return std::array{std::sin(x[0] + 2 * x[1]), x[2] * x[0], std::cos(x[1]) + x[2]};
  };
  FaceValues v = faces_of(domain.grid, wave), w = faces_of(domain.grid, [&](const auto&x) {
                                                return wave(std::array{1 - x[0], 1 - x[1], 1 - x[2]});
                                              });
  extend_velocity(domain, v, 3);
  extend_velocity(turned, w, 3);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) EXPECT_NEAR(v[a][f], w[a][v[a].size() - 1 - f], 1e-14);
  }
}

TEST(Extension, WhatNothingReachesIsZero) {
  FlowDomain domain = box(unit_box(2, 4));
  for (auto& kinds : domain.face) kinds.assign(kinds.size(), FaceKind::closed);
  FaceValues v = face_values(domain.grid, 7);
  extend_velocity(domain, v, 100);
  for (std::size_t a = 0; a < 2; ++a) {
    for (const double u : v[a]) EXPECT_EQ(u, 0);
  }
}

}  // namespace
}  // namespace tether::coupled
