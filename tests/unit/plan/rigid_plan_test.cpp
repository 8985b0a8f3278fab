// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "grid/block_mesh.hpp"
#include "model/solids.hpp"
#include "plan/make_plan.hpp"
#include "plan/plan.hpp"
#include "plan/plan_text.hpp"
#include "unit/plan/plan_support.hpp"

namespace tether {
namespace {

/// A box of 2 x 1 x 1 elements.
Scene rigid_scene(const Rigid& rigid) {
  Scene scene = test::empty_scene();
  Block block;
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  for (std::size_t k = 0; k < 4; ++k) block.edges[k] = straight(corners[k], corners[(k + 1) % 4]);
  block.cells = {2, 1, 1}, block.z_high = 1;
  std::vector<MeshFlaw> flaws;
  Solids solids;
  solids.mesh = mesh_of_blocks({block}, ElementKind::hex8, flaws);
  solids.regions = {{"region 1", {}, 2.5, {}, {}}};
  scene.physics = RigidBody{std::make_shared<const Solids>(solids), std::make_shared<const Rigid>(rigid)};
  return scene;
}

TEST(RigidPlan, SaysWhatIsModelledAndWhatIsLeftOut) {
  Rigid rigid;
  rigid.form = RigidForm::constrained;
  rigid.point = Eigen::Vector3d(1, 2, .5), rigid.pin = Eigen::Vector3d(0, 0, 0);
  rigid.directors(0, 1) = .5;
  rigid.torques.resize(2);
  rigid.forces.resize(3), rigid.forces[1].turning = true;
  const std::string text = to_text(make_plan(rigid_scene(rigid)));
  const std::string expected =
      "path: fem (rigid body)\n"
      "mesh: 2 elements q1, 12 nodes, for mass and shape\n"
      "unknowns: 21\n"
      "region 1: density 2.5\n"
      "modelled:\n"
      "  inertia: of the mesh, as it turns; mid-point rule: keeps energy and momenta\n"
      "  frame: reference point (1, 2, 0.5), directors skew\n"
      "  constraints: six and three of the pin, with a multiplier each\n"
      "  loads: 2 by torques, 2 dead at points, 1 at points that turn with the body\n"
      "  pin: at (0, 0, 0)\n"
      "  third dimension: the body moves in space\n"
      "left out:\n"
      "  gravity: gravc = 0\n"
      "  strain: the body is rigid: laws of its regions have no effect\n"
      "  damping: a rigid body has none\n"
      "  contact: bodies on a mesh do not meet, and walls do not stop them\n"
      "step: 0.125, the deck's\n"
      "cost: 8 steps, 8 point-steps";
  EXPECT_EQ(text.substr(0, expected.size()), expected);
}

TEST(RigidPlan, OfAFreeBodyHasSixUnknownsAndNoMultipliers) {
  const std::string text = to_text(make_plan(rigid_scene({})));
  for (const char* line : {"\nunknowns: 6\n", "  frame: reference point at the centre of mass, directors orthonormal\n",
                           "  constraints: in their null space: 6 unknowns, no multipliers\n",
                           "  pin: none given: the body is free\n", "  loads: none given\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(RigidPlan, WarnsOfStepsInWhichTheBodyTurnsFar) {
  Rigid rigid;
  rigid.omega = Eigen::Vector3d(0, 3.9, 0);
  EXPECT_EQ(make_plan(rigid_scene(rigid)).warnings, std::vector<std::string>{});
  rigid.omega = Eigen::Vector3d(0, 4.8, 0);
  EXPECT_EQ(make_plan(rigid_scene(rigid)).warnings,
            std::vector<std::string>{"the body turns by 0.6 rad in a step: its phase will be off by 0.03 of itself"});
}

}  // namespace
}  // namespace tether
