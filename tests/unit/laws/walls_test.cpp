// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/walls.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

TEST(WallsTest, NumbersOfTheDeck) {
  EXPECT_EQ(static_cast<Wall>(0), Wall::fixed);
  EXPECT_EQ(static_cast<Wall>(1), Wall::open);
  EXPECT_EQ(static_cast<Wall>(4), Wall::symmetry);
  EXPECT_EQ(static_cast<Wall>(5), Wall::axis);
  EXPECT_EQ(static_cast<Wall>(6), Wall::free_slip);
}

TEST(WallsTest, AFixedWallHoldsBothComponents) {
  EXPECT_EQ(held_by(Wall::fixed, holds_x), 3);
  EXPECT_EQ(held_by(Wall::fixed, holds_y), 3);
}

TEST(WallsTest, AnOpenWallHoldsNone) {
  EXPECT_EQ(held_by(Wall::open, holds_x), 0);
  EXPECT_EQ(held_by(Wall::open, holds_y), 0);
}

TEST(WallsTest, TheOthersHoldTheComponentAcross) {
  for (const Wall wall : {Wall::symmetry, Wall::axis, Wall::free_slip}) {
    EXPECT_EQ(held_by(wall, holds_x), 1);
    EXPECT_EQ(held_by(wall, holds_y), 2);
  }
}

TEST(WallsTest, OnlyTheOthersMirror) {
  EXPECT_FALSE(mirrors(Wall::fixed));
  EXPECT_FALSE(mirrors(Wall::open));
  EXPECT_TRUE(mirrors(Wall::symmetry));
  EXPECT_TRUE(mirrors(Wall::axis));
  EXPECT_TRUE(mirrors(Wall::free_slip));
}

TEST(WallsTest, FreeSlipWhereTheDeckSaysNothing) {
  const Walls walls;
  for (const Wall wall : {walls.left, walls.right, walls.bottom, walls.top}) EXPECT_EQ(wall, Wall::free_slip);
}

}  // namespace
}  // namespace tether
