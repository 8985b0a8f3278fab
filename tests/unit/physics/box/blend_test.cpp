// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/box/cut_faces.hpp"

#include <gtest/gtest.h>

#include "physics/box/projection.hpp"
#include "unit/physics/box/bodies_support.hpp"
#include "unit/physics/box/support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

/// Leaves a part of the fluid about a face.
void cut_face(FlowDomain& domain, int axis, const Cell& place, double part) {
  const std::size_t f = domain.grid.face(axis, place);
  domain.volume[at(axis)][f] *= part, domain.area[at(axis)][f] *= part;
}

constexpr double long_enough = 1e6;  // for all that can be given

/// At once, and in the time in which the fastest crosses a cell.
TEST(Blend, ACutFaceTakesForWhatItLacksTheMeanByVolume) {
  FlowDomain domain = box(unit_box(2, 8));
  cut_face(domain, 0, {4, 4, 0}, 0.25), cut_face(domain, 0, {4, 5, 0}, 0.75);
  const auto start = faces_of(domain.grid, [](const auto& x) { return std::array<double, 3>{x[0] * x[1], x[1], 0}; });
  FaceValues v = start;
  const auto u = [&](int i, int j) { return start[0][domain.grid.face(0, i, j, 0)]; };
  blend_cut_faces(domain, long_enough, v);
  const double mean = (0.25 * u(4, 4) + u(3, 4) + u(5, 4) + u(4, 3) + 0.75 * u(4, 5)) / 4;
  EXPECT_DOUBLE_EQ(v[0][domain.grid.face(0, 4, 4, 0)], 0.25 * u(4, 4) + 0.75 * mean);
  FaceValues soon = start;
  blend_cut_faces(domain, 0.125 / u(5, 4), soon);
  const double share = (1 - std::exp(-1)) * 0.75;
  EXPECT_NEAR(soon[0][domain.grid.face(0, 4, 4, 0)], u(4, 4) + share * (mean - u(4, 4)), 1e-15);
  int changed = 0;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) changed += v[a][f] != start[a][f] ? 1 : 0;
  }
  EXPECT_EQ(changed, 2);
}

/// Of the faces about a cut one, those above lie behind a solid, and one ahead is closed.
TEST(Blend, NothingFromBehindASolid) {
  FlowDomain domain = box(unit_box(2, 8));
  cut_face(domain, 0, {4, 4, 0}, 1e-6);
  close_face(domain, 1, {3, 5, 0}), close_face(domain, 1, {4, 5, 0}), close_face(domain, 0, {5, 4, 0});
  FaceValues v = face_values(domain.grid, 1);
  v[0][domain.grid.face(0, 4, 5, 0)] = v[0][domain.grid.face(0, 5, 4, 0)] = 99;
  blend_cut_faces(domain, long_enough, v);
  EXPECT_DOUBLE_EQ(v[0][domain.grid.face(0, 4, 4, 0)], 1);
}

/// A jet that a pressure drives, step after step, where a solid leaves next to nothing: as fast as sqrt(dp/rho).
TEST(Blend, AJetIsAsFastAsItsPressureAtStepsOfAnyLength) {
  const double speed = 3, d = 0.125;
  FlowDomain domain = box(unit_box(2, 8));
  cut_face(domain, 0, {4, 4, 0}, 1e-6);
  const std::size_t jet = domain.grid.face(0, 4, 4, 0);
  for (const double h : {1e-4, 1e-3}) {
    FaceValues v = face_values(domain.grid);
    for (int k = 0; k * h < 1; ++k) {
      v[0][jet] += h * speed * speed / d;
      blend_cut_faces(domain, h, v);
    }
    EXPECT_NEAR(v[0][jet] / speed, 1, 0.02) << h;
  }
}

class Blended : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Coupled, Blended, testing::Values(2, 3));

/// About a turned block, of velocities that are the larger the less fluid has them.
TEST_P(Blended, SpeedsOfLittleFluidAreNotSeen) {
  const int dim = GetParam();
  Coupled coupled = fluid_in_box(dim, 12);
  coupled.coupling = coupling_of(CouplingMode::cut_cell);
  const Surroundings about(coupled, solid_block(dim, 3, {0.47, 0.52, 0.5}, 0.45, 0.4));
  const FlowDomain& domain = about.domain;
  FaceValues v = face_values(domain.grid, 1), even = v;
  for (std::size_t a = 0; a < at(dim); ++a) {
    for (std::size_t f = 0; f < v[a].size(); ++f) {
      const double part = domain.volume[a][f] / domain.grid.volume();
      if (domain.face[a][f] == FaceKind::open && part < 0.02) v[a][f] = 100;
    }
  }
  ASSERT_EQ(largest_distance(domain, v, even), 99);
  blend_cut_faces(domain, long_enough, v);
  EXPECT_LT(largest_distance(domain, v, even), 6);
  blend_cut_faces(domain, long_enough, even);
  EXPECT_LT(largest_distance(domain, even, face_values(domain.grid, 1)), 1e-14);
}

}  // namespace
}  // namespace tether::coupled
