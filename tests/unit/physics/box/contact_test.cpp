// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes touch walls and obstacles, and which of them slide.
#include "physics/box/contact.hpp"

#include <gtest/gtest.h>

#include "unit/physics/box/bodies_support.hpp"

namespace tether::coupled {
namespace {

using namespace support;

constexpr double h = 0.1;

/// One triangle whose first node is watched; the others are far from all walls, in a box of 10 x 10 cells from 0 to 1.
class Touching : public testing::Test {
 protected:
  Coupled coupled = fluid_in_box(2, 10);
  Mesh mesh;
  std::vector<Touch> touches = std::vector<Touch>(6, Touch::away);
  std::vector<double> q{0, 0, 0.5, 0.5, 0.5, 0.6}, u0 = std::vector<double>(6, 0.0), u1 = u0, reactions = u0,
                                                   inertia = u0, chosen = u0;

  Contact at_place(double x, double y, double vx = 0, double vy = 0) {
    mesh.kind = ElementKind::tri3;
    mesh.nodes = {0, 1, 2}, mesh.region = {0};
    q[0] = x, q[1] = y;
    mesh.x = q;
    u0[0] = u1[0] = vx, u0[1] = u1[1] = vy;
    Contact contact(coupled, surface_of(mesh));
    contact.begin(q, u0, h, touches);
    return contact;
  }
  /// As the step does: what contact holds has the velocity that it says.
  bool solved(Contact& contact, const std::vector<double>& free, double rx, double ry) {
    const auto held = held_by(contact);
    for (std::size_t k = 0; k < 2; ++k) u1[k] = held[k] != 0 ? chosen[k] : free[k];
    reactions[0] = held[0] != 0 ? rx : 0, reactions[1] = held[1] != 0 ? ry : 0;
    return contact.changed(u1, reactions, inertia, touches);
  }
  std::vector<int> held_by(const Contact& contact) {
    std::vector<std::uint8_t> held(6, 0);
    contact.hold(touches, held, chosen);
    return {held.begin(), held.begin() + 2};
  }
  Vec<3> friction_of(const Contact& contact) const {
    std::vector<double> forces(6, 0.0);
    contact.add_friction(forces);
    return {forces[0], forces[1], 0};
  }
};

TEST_F(Touching, BeginsWhereTheWayLeadsThroughTheWall) {
  Contact before = at_place(0.3, 0.05, 2, -0.49);
  EXPECT_FALSE(solved(before, {2, -0.49}, 0, 0));
  Contact through = at_place(0.3, 0.05, 2, -0.51);
  EXPECT_TRUE(solved(through, {2, -0.51}, 0, 0));
  EXPECT_EQ(touches[1], Touch::slides);
  EXPECT_EQ(held_by(through), (std::vector{0, 1}));
  EXPECT_FALSE(solved(through, {2, 0}, 0, 5));
}

/// Halted from above or from behind it; others are put there only where they went through.
TEST_F(Touching, EndsOnTheWall) {
  for (const double vy : {-0.51, -1.3}) {
    touches[1] = Touch::away;
    Contact contact = at_place(0.3, 0.05, 2, vy);
    EXPECT_TRUE(solved(contact, {2, vy}, 0, 0));
    EXPECT_NEAR(q[1] + 0.5 * h * vy + contact.lifts(touches, 6)[1], 0, 1e-16);
    q[1] += 0.5 * h * vy;
    contact.place(q);
    EXPECT_EQ(q[1], 0);
  }
  touches[1] = Touch::away;
  Contact away = at_place(0.3, 0.05);
  away.place(q);
  EXPECT_EQ(q[1], 0.05);
  q[1] = -0.001;
  away.place(q);
  EXPECT_EQ(q[1], 0);
}

TEST_F(Touching, IsWithWallsNotWithOpenSidesAndCanBeSwitchedOff) {
  coupled.sides[side_bottom] = BoxSide::open;
  Contact open = at_place(0.3, 0.05, 0, -1);
  EXPECT_FALSE(solved(open, {0, -1}, 0, 0));
  coupled.sides[side_bottom] = BoxSide::wall, coupled.contact = false;
  Contact none = at_place(0.3, 0.05, 0, -1);
  EXPECT_FALSE(solved(none, {0, -1}, 0, 0));
}

/// From all four sides.
TEST_F(Touching, KeepsNodesInTheBox) {
  const std::array<std::array<double, 4>, 4> ways{
      {{0.05, 0.3, -1, 0}, {0.95, 0.3, 1, 0}, {0.3, 0.05, 0, -1}, {0.3, 0.95, 0, 1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    touches.assign(6, Touch::away);
    Contact contact = at_place(ways[k][0], ways[k][1], ways[k][2], ways[k][3]);
    EXPECT_TRUE(solved(contact, {ways[k][2], ways[k][3]}, 0, 0)) << k;
    EXPECT_EQ(touches[k / 2], Touch::slides) << k;
    EXPECT_EQ(touches[1 - k / 2], Touch::away) << k;
  }
}

TEST_F(Touching, EndsWhereTheWallWouldHaveToPull) {
  touches[1] = Touch::slides;
  Contact contact = at_place(0.3, 0);
  EXPECT_FALSE(solved(contact, {0, 0}, 0, 1));
  EXPECT_TRUE(solved(contact, {0, 0}, 0, -1));
  EXPECT_EQ(touches[1], Touch::away);
  EXPECT_TRUE(solved(contact, {0, -1}, 0, 0));  // it comes back,
  EXPECT_EQ(touches[1], Touch::rebounds);
  EXPECT_TRUE(solved(contact, {0, 0}, 0, -1));  // and is pulled again, by what others do:
  EXPECT_EQ(touches[1], Touch::away);
  EXPECT_FALSE(solved(contact, {0, 1}, 0, 0));
}

/// Two nodes each of which is wrong as long as the other does the same: changed together they would go round for ever.
TEST_F(Touching, ChangesOneAtATimeWhereAllGoRound) {
  q[2] = 0.6, q[3] = 0;
  u0[3] = -1;
  touches[1] = touches[3] = Touch::slides;
  Contact contact = at_place(0.3, 0, 0, -1);
  int solutions = 0;
  for (bool again = true; again && solutions < 20; ++solutions) {
    const bool same = (touches[1] == Touch::away) == (touches[3] == Touch::away);
    for (const std::size_t k : {1, 3}) {
      u1[k] = touches[k] == Touch::away ? (same ? -1 : 2) : 1;
      reactions[k] = touches[k] == Touch::away ? 0 : (same ? -1 : 1);
    }
    again = contact.changed(u1, reactions, inertia, touches);
  }
  EXPECT_LT(solutions, 10);
  EXPECT_EQ(touches[1], Touch::away);
  EXPECT_EQ(touches[3], Touch::rebounds);
}

/// One that would have to be pulled to a halt, and let go would go through: it ends on the wall by (5), and is free in
/// the next step.
TEST_F(Touching, ReboundsWhereItCannotBeHalted) {
  Contact contact = at_place(0.3, 0.01, 0, -1);
  EXPECT_TRUE(solved(contact, {0, -1}, 0, 0));
  EXPECT_EQ(contact.lifts(touches, 6)[1], h / 2 - 0.01);
  EXPECT_TRUE(solved(contact, {0, 0}, 0, -1));
  EXPECT_TRUE(solved(contact, {0, -1}, 0, 0));
  EXPECT_EQ(touches[1], Touch::rebounds);
  EXPECT_EQ(contact.lifts(touches, 6), std::vector<double>(6, 0.0));
  EXPECT_FALSE(solved(contact, {0, 0}, 0, 1));
  EXPECT_DOUBLE_EQ(u1[1], 1 - 2 * 0.01 / h);
  EXPECT_NEAR(0.01 + h / 2 * (u0[1] + u1[1]), 0, 1e-16);
  Contact then = at_place(0.3, 0);
  EXPECT_EQ(touches[1], Touch::away);
}

/// The same where the nodes around it have the wall push a node that it halts with less than nothing: what it gives is
/// R times the node's way, down to the wall, less the inertia times what that is longer than by (5).
TEST_F(Touching, ReboundsWhereAHaltWouldGiveEnergy) {
  for (const double gap : {0.0, 0.01, 0.09}) {
    touches[1] = Touch::away;
    Contact contact = at_place(0.3, gap, 0, -1);
    EXPECT_TRUE(solved(contact, {0, -1}, 0, 0));
    const double lift = h / 2 - gap, reaction = 2, balance = -reaction * gap / lift * h;
    inertia[1] = balance + (lift > 0 ? 1e-9 : -1e-9);
    EXPECT_FALSE(solved(contact, {0, 0}, 0, reaction)) << gap;
    inertia[1] = balance - (lift > 0 ? 1e-9 : -1e-9);
    EXPECT_TRUE(solved(contact, {0, 0}, 0, reaction)) << gap;
    EXPECT_TRUE(solved(contact, {0, -1}, 0, 0)) << gap;
    EXPECT_EQ(touches[1], Touch::rebounds) << gap;
  }
}

TEST_F(Touching, IsForgottenWhereTheNodeIsAway) {
  touches[1] = Touch::sticks;
  at_place(0.3, 0.01);
  EXPECT_EQ(touches[1], Touch::away);
  touches[1] = Touch::sticks;
  at_place(0.3, 0);
  EXPECT_EQ(touches[1], Touch::sticks);
}

/// Coulomb: a node that comes sticks, where that takes no more than mu N; else it slides, and is rubbed by mu N as N
/// comes out; where that would drive it back it sticks for the rest of the step.
TEST_F(Touching, RubsByFrictionTimesWhatPresses) {
  coupled.friction = 0.5;
  Contact contact = at_place(0.3, 0.001, 1, -1);
  EXPECT_TRUE(solved(contact, {1, -1}, 0, 0));
  EXPECT_EQ(touches[1], Touch::sticks);
  EXPECT_EQ(held_by(contact), (std::vector{1, 1}));
  EXPECT_TRUE(solved(contact, {0, 0}, -7, 2));
  EXPECT_EQ(held_by(contact), (std::vector{0, 1}));
  EXPECT_EQ(friction_of(contact), (Vec<3>{-1, 0, 0}));
  EXPECT_TRUE(solved(contact, {0.4, 0}, 0, 3));
  EXPECT_EQ(friction_of(contact), (Vec<3>{-1.5, 0, 0}));
  EXPECT_FALSE(solved(contact, {0.3, 0}, 0, 3));
  EXPECT_TRUE(solved(contact, {-0.3, 0}, 0, 3));
  EXPECT_EQ(touches[1], Touch::sticks);
  EXPECT_EQ(friction_of(contact), (Vec<3>{0, 0, 0}));
  EXPECT_EQ(held_by(contact), (std::vector{1, 1}));
  EXPECT_FALSE(solved(contact, {0, 0}, -9, 3));
}

/// By (5) a node that sticks still goes h u0/2: a wall that has to push it along that way gives it energy. It is rubbed
/// against it, and where that drives it back, held so that it does not move at all.
TEST_F(Touching, IsNotPushedAlongTheWall) {
  coupled.friction = 0.5;
  Contact contact = at_place(0.3, 0.001, 1, -1);
  EXPECT_TRUE(solved(contact, {1, -1}, 0, 0));
  EXPECT_TRUE(solved(contact, {0, 0}, 0.1, 2));
  EXPECT_EQ(touches[1], Touch::slides);
  EXPECT_EQ(friction_of(contact), (Vec<3>{-1, 0, 0}));
  EXPECT_FALSE(solved(contact, {-0.9, 0}, 0, 2));
  EXPECT_TRUE(solved(contact, {-1.1, 0}, 0, 2));
  EXPECT_EQ(touches[1], Touch::grips);
  EXPECT_EQ(friction_of(contact), (Vec<3>{0, 0, 0}));
  EXPECT_EQ(held_by(contact), (std::vector{1, 1}));
  EXPECT_EQ(chosen[0], -u0[0]);
  Contact then = at_place(0.3, 0);
  EXPECT_EQ(touches[1], Touch::sticks);
}

/// One that sticks goes on to where holding it takes more.
TEST_F(Touching, SticksUpToFrictionTimesWhatPresses) {
  coupled.friction = 0.5;
  touches[1] = Touch::sticks;
  Contact contact = at_place(0.3, 0);
  EXPECT_EQ(held_by(contact), (std::vector{1, 1}));
  EXPECT_FALSE(solved(contact, {0, 0}, -0.99, 2));
  EXPECT_EQ(friction_of(contact), (Vec<3>{0, 0, 0}));
  EXPECT_TRUE(solved(contact, {0, 0}, -1.5, 2));
  EXPECT_EQ(touches[1], Touch::slides);
  EXPECT_EQ(friction_of(contact), (Vec<3>{-1, 0, 0}));
}

/// An obstacle just above the floor: one of them holds the node, and rubs it once.
TEST_F(Touching, IsWithOneOfTwoWallsAcrossAnAxis) {
  coupled.friction = 0.5;
  coupled.obstacles.push_back({{0, 0, 0}, {1, 0.05, 1}});
  Contact contact = at_place(0.3, 0.051, 1, -1);
  EXPECT_TRUE(solved(contact, {1, -1}, 0, 0));
  EXPECT_TRUE(solved(contact, {0, 0}, -7, 2));
  EXPECT_EQ(friction_of(contact), (Vec<3>{-1, 0, 0}));
}

/// In a slot narrower than two cells the node that lies on the floor is not pulled by the ceiling.
TEST_F(Touching, OfTheFloorIsNotEndedByTheCeiling) {
  coupled.obstacles.push_back({{0, 0.05, 0}, {1, 0.2, 1}});
  Contact contact = at_place(0.3, 0.01, 0, -1);
  EXPECT_TRUE(solved(contact, {0, -1}, 0, 0));
  EXPECT_FALSE(solved(contact, {0, 0}, 0, 1));
  EXPECT_EQ(touches[1], Touch::slides);
}

/// The planes of an obstacle's faces are walls along it alone.
TEST_F(Touching, DoesNotHappenBesideAnObstacle) {
  coupled.obstacles.push_back({{0.4, 0.2, 0}, {0.6, 0.4, 1}});
  Contact above = at_place(0.38, 0.41, 1, 0);
  EXPECT_FALSE(solved(above, {1, 0}, 0, 0));
  q[0] = 0.48;
  above.place(q);
  EXPECT_EQ(q[0], 0.48);
  Contact into = at_place(0.38, 0.39, 1, 0);
  EXPECT_TRUE(solved(into, {1, 0}, 0, 0));
  EXPECT_EQ(touches[0], Touch::slides);
  Contact from_above = at_place(0.41, 0.41, 0.2, -1);
  touches.assign(6, Touch::away);
  EXPECT_TRUE(solved(from_above, {0.2, -1}, 0, 0));
  EXPECT_EQ(touches[1], Touch::slides);
  q[1] = 0.31;
  from_above.place(q);
  EXPECT_EQ(q[1], 0.4);
}

/// A floor of two obstacles side by side has no step where they meet.
TEST_F(Touching, DoesNotHappenWhereObstaclesMeet) {
  coupled.obstacles = {{{0.5, 0, 0}, {1, 0.2, 1}}, {{0, 0, 0}, {0.5, 0.2, 1}}};
  touches[1] = Touch::slides;
  Contact contact = at_place(0.48, 0.2, 1, 0);
  EXPECT_FALSE(solved(contact, {1, 0}, 0, 1));
  EXPECT_EQ(held_by(contact), (std::vector{0, 1}));
  q[0] = 0.58;
  contact.place(q);
  EXPECT_EQ(q[0], 0.58);
}

/// Nor for a node that sinks as it goes: the face between is no wall, nor is any of an obstacle in another.
TEST_F(Touching, IsNotWithFacesThatObstaclesCover) {
  coupled.obstacles = {{{0.5, 0, 0}, {1, 0.2, 1}}, {{0, 0, 0}, {0.5, 0.2, 1}}, {{0.6, 0.05, 0}, {0.7, 0.15, 1}}};
  Contact contact = at_place(0.499, 0.201, 1, -1);
  EXPECT_TRUE(solved(contact, {1, -1}, 0, 0));
  EXPECT_EQ(held_by(contact), (std::vector{0, 1}));
  coupled.obstacles[1].high[1] = 0.1;  // now there is a step
  touches.assign(6, Touch::away);
  Contact step = at_place(0.499, 0.15, 1, 0);
  EXPECT_TRUE(solved(step, {1, 0}, 0, 0));
  EXPECT_EQ(held_by(step), (std::vector{1, 0}));
}

}  // namespace
}  // namespace tether::coupled
