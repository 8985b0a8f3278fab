// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/flow_paths.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

std::array<double, 3> linear(const std::array<double, 3>& x) {
  return {1 + x[0] + 2 * x[1] - x[2], 3 * x[0] - x[1] + x[2], 2 * x[2] + x[1] - x[0]};
}

template <int dim>
void expect_linear_is_exact() {
  const FlowDomain domain = box(unit_box(dim, 4));
  const StaggeredGrid& grid = domain.grid;
  const FlowPaths<dim> paths(domain);
  const FaceValues v = faces_of(grid, linear);
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    FlowPlace place{grid.place_of_cell(c), {0.3, 0.9, 0.6}};
    std::array<double, 3> x{};
    bool inside = true;  // not nearer to a side than half a cell, where it is constant
    for (std::size_t b = 0; b < dim; ++b) {
      x[b] = (place.cell[b] + place.at[b]) * grid.d[b];
      inside = inside && x[b] > grid.d[b] / 2 && x[b] < 1 - grid.d[b] / 2;
    }
    const auto u = paths.velocity(v, place);
    for (std::size_t a = 0; a < dim && inside; ++a) EXPECT_NEAR(u[a], linear(x)[a], 1e-14);
  }
}

TEST(FlowPaths, ALinearFieldIsExact) {
  expect_linear_is_exact<2>();
  expect_linear_is_exact<3>();
}

// A plate beside a place hides what is behind it in the plane; in space the cell beyond its edge is reached around it.
TEST(FlowPaths, OnlyWhatCanBeReachedCounts) {
  FlowDomain plane = box(unit_box(2, 4));
  close_face(plane, 1, {1, 2, 0});
  FaceValues v = faces_of(plane.grid, [](const auto& x) {
    return std::array<double, 3>{x[1] > 0.5 ? 1000 : x[0], 0, 0};
  });
  const FlowPlace corner{{1, 1, 0}, {0.5, 0.75, 0.5}};
  FlowValue found = FlowPaths<2>(plane).value(v, 0, corner);
  EXPECT_DOUBLE_EQ(found.value, 0.375);
  EXPECT_FALSE(found.whole);
  EXPECT_DOUBLE_EQ(found.low, 0.25);
  EXPECT_DOUBLE_EQ(found.high, 0.5);

  FlowDomain space = box(unit_box(3, 4));
  close_face(space, 1, {1, 2, 1});
  v = faces_of(space.grid, [](const auto& x) {
    return std::array<double, 3>{x[1] < 0.5 ? 0.0 : x[2] < 0.5 ? 1000.0 : 1.0, 0, 0};
  });
  // Weights 9, 3, 3 and 1 sixteenths; that of 3 behind the plate does not count, that of 1 does by the way around.
  found = FlowPaths<3>(space).value(v, 0, {{1, 1, 1}, {0.5, 0.75, 0.75}});
  EXPECT_FALSE(found.whole);
  EXPECT_NEAR(found.value, 1.0 / 13, 1e-15);
}

TEST(FlowPaths, WaysEndAtSolidsAndGoAlongTheBox) {
  FlowDomain domain = box(unit_box(2, 8));
  close_face(domain, 0, {3, 4, 0});
  fill_cell(domain, {6, 6, 0}, CellKind::wall);
  const FlowPaths<2> paths(domain);
  FlowPlace place{{5, 4, 0}, {0.5, 0.25, 0.5}};
  EXPECT_FALSE(paths.follow(place, {-5, 0.5}));  // to the plate, half way
  EXPECT_EQ(place.cell, (std::array<int, 3>{3, 4, 0}));
  EXPECT_NEAR(place.at[0], 0, 1e-15);
  EXPECT_NEAR(place.at[1], 0.5, 1e-15);
  place = {{6, 3, 0}, {0.5, 0.5, 0.5}};
  EXPECT_FALSE(paths.follow(place, {0, 9}));  // to the obstacle
  EXPECT_EQ(place.cell, (std::array<int, 3>{6, 5, 0}));
  EXPECT_EQ(place.at[1], 1);
  place = {{1, 1, 0}, {0.5, 0.5, 0.5}};
  EXPECT_FALSE(paths.follow(place, {-3, 4}));  // to the box's side, and along it
  EXPECT_EQ(place.cell, (std::array<int, 3>{0, 5, 0}));
  EXPECT_EQ(place.at[0], 0);
  EXPECT_NEAR(place.at[1], 0.5, 1e-14);
  place = {{1, 1, 0}, {0.5, 0.5, 0.5}};
  EXPECT_TRUE(paths.follow(place, {5.75, 1.25}));
  EXPECT_EQ(place.cell, (std::array<int, 3>{7, 2, 0}));
  EXPECT_NEAR(place.at[0], 0.25, 1e-14);
  EXPECT_NEAR(place.at[1], 0.75, 1e-14);
}

}  // namespace
}  // namespace tether::coupled
