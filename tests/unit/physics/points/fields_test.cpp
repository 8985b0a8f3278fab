// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/points/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run/make.hpp"
#include "unit/physics/scenes.hpp"

namespace tether::mpm {
namespace {

using scenes::add_block;
using scenes::field;
using scenes::open_scene;

/// Two bodies of one point each, the gas listed before the solid that lies left of it.
Scene gas_and_solid() {
  Scene scene = open_scene(6, 6);
  add_block(scene, IdealGas{.rule = DensityRule::continuity}, 3, 4, 2, 3, 1, 2.0, 5.0);
  add_block(scene, plane_strain(4, 0.25), 1, 2, 2, 3, 1, 3.0);
  scene.points.vx = {0.5, -1}, scene.points.vy = {0, 2};
  scene.points.sxx[1] = 1.6;  // uniaxial stress of a strain eps_xx = .375, eps_yy = -.125
  scene.gravity = -10;
  scene.tracked = {1, 0};
  return scene;
}

TEST(Record, HasANumberForEveryColumnAndTheyAreRight) {
  Scene scene = gas_and_solid();
  scene.outputs.tracked_angle = true;
  const State state = start(scene);
  const auto columns = history_columns(scene);
  const History history{columns.layout(), {columns.record(sums_of(state, scene))}};
  ASSERT_EQ(history.layout.column_names().size(), history.records[0].size());
  const auto value = [&](const char* name) { return history.column(name).front(); };
  EXPECT_NEAR(value("mass"), 5, 1e-15);
  EXPECT_NEAR(value("momentum_x"), 1 - 3, 1e-15);
  EXPECT_NEAR(value("momentum_y"), 6, 1e-15);
  EXPECT_NEAR(value("angular_momentum_z"), 2 * (-2.5 * 0.5) + 3 * (1.5 * 2 + 2.5 * 1), 1e-14);
  EXPECT_NEAR(value("energy_kinetic"), 0.5 * 2 * 0.25 + 0.5 * 3 * 5, 1e-15);
  EXPECT_NEAR(value("energy_internal"), 2 * 5, 1e-15);
  EXPECT_NEAR(value("energy_strain"), 0.5 * 1.6 * 0.375, 1e-15);
  EXPECT_NEAR(value("energy_potential"), 5 * 10 * 2.5, 1e-13);
  EXPECT_NEAR(value("body_x_1"), 3.5, 1e-15);
  EXPECT_NEAR(value("body_vy_2"), 2, 1e-15);
  EXPECT_EQ(value("point_x_1"), 1.5);  // tracked in the order asked for
  EXPECT_EQ(value("point_vx_2"), 0.5);
  EXPECT_NEAR(value("tracked_angle"), 90, 1e-12);
}

TEST(PointFields, ComeInTheOrderOfTheSceneWhateverTheSlots) {
  Scene scene = open_scene(6, 6);
  add_block(scene, plane_strain(1, 0), 1, 4, 1, 4, 2);
  std::reverse(scene.points.x.begin(), scene.points.x.end());
  const State state = start(scene);
  EXPECT_NE(state.points.x.front(), scene.points.x.front());  // sorted by cell
  const Snapshot snapshot = point_fields(state, scene).snapshot();
  EXPECT_EQ(field(snapshot, "x"), scene.points.x);
  EXPECT_EQ(field(snapshot, "id").front(), 1);
  EXPECT_EQ(field(snapshot, "id").back(), static_cast<double>(scene.points.size()));
}

TEST(PointFields, FollowFromTheLaws) {
  const Scene scene = gas_and_solid();
  const Snapshot snapshot = point_fields(start(scene), scene).snapshot();
  EXPECT_EQ(field(snapshot, "body"), (std::vector<double>{1, 2}));
  EXPECT_EQ(field(snapshot, "density"), (std::vector<double>{2, 3}));
  EXPECT_NEAR(field(snapshot, "pressure")[0], 0.4 * 2 * 5, 1e-15);
  EXPECT_NEAR(field(snapshot, "pressure")[1], -(1.6 + 0.25 * 1.6) / 3, 1e-15);
  EXPECT_NEAR(field(snapshot, "szz")[0], -4, 1e-15);
  EXPECT_NEAR(field(snapshot, "szz")[1], 0.25 * 1.6, 1e-15);
  EXPECT_NEAR(field(snapshot, "strain_xx")[1], 0.375, 1e-15);
  EXPECT_NEAR(field(snapshot, "strain_yy")[1], -0.125, 1e-15);
  EXPECT_EQ(field(snapshot, "strain_xx")[0], 0);
}

// About an axis the hoop's stress is one of its own, whatever its value: 0 is one, too.
TEST(PointFields, AboutAnAxisTheHoopsStressCounts) {
  Scene scene = gas_and_solid();
  scene.geometry = Geometry::axisymmetric;
  State state = start(scene);
  for (const double hoop : {0.0, 0.8}) {
    for (std::size_t p = 0; p < 2; ++p) state.points.szz[p] = hoop;
    const Snapshot snapshot = point_fields(state, scene).snapshot();
    EXPECT_NEAR(field(snapshot, "pressure")[1], -(1.6 + hoop) / 3, 1e-15);
    EXPECT_NEAR(field(snapshot, "strain_xx")[1], (1.6 - 0.25 * hoop) / 4, 1e-15);
    EXPECT_NEAR(field(snapshot, "strain_yy")[1], -0.25 * (1.6 + hoop) / 4, 1e-15);
  }
}

TEST(PointFields, NormalsStandOnTheTangentsOfStrings) {
  Scene scene = open_scene(6, 6);
  add_block(scene, plane_strain(1, 0), 1, 4, 2, 3, 1);  // three places in a row along x, taken as a string
  scene.bodies[0].material = Membrane{1, 0, true};
  const Snapshot snapshot = point_fields(start(scene), scene).snapshot();
  EXPECT_EQ(field(snapshot, "normal_x"), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(field(snapshot, "normal_y"), (std::vector<double>{1, 1, 1}));
}

TEST(GridFields, AreMeansByMassAtTheNodes) {
  Scene scene = gas_and_solid();
  scene.points.x[1] = 2.5;  // side by side: the nodes at x = 3 have half of either
  const Snapshot snapshot = grid_fields(start(scene), scene, step_set(scene));
  const std::size_t shared = 2 * 6 + 3, gas_only = 2 * 6 + 4, empty = 0;
  EXPECT_NEAR(field(snapshot, "mass")[shared], 0.25 * (2 + 3), 1e-15);
  EXPECT_NEAR(field(snapshot, "vx")[shared], (2 * 0.5 + 3 * -1) / 5.0, 1e-15);
  EXPECT_NEAR(field(snapshot, "density")[shared], (2 * 2 + 3 * 3) / 5.0, 1e-15);
  EXPECT_NEAR(field(snapshot, "specific_energy")[shared], 2 * 5 / 5.0, 1e-15);
  EXPECT_NEAR(field(snapshot, "pressure")[gas_only], 4, 1e-15);
  EXPECT_EQ(field(snapshot, "density")[empty], 0);
  EXPECT_NEAR(field(snapshot, "force_y")[gas_only], 0.5 * -10 - 2.0, 1e-14);  // gravity, and half of p over the edge
}

}  // namespace
}  // namespace tether::mpm
