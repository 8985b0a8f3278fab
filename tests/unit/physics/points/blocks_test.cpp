// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of a body stand that runs by lanes.
#include <gtest/gtest.h>

#include <vector>

#include "physics/points/blocks.hpp"

namespace tether::mpm {
namespace {

TEST(Blocks, AChainPerGroupOfCellsAndASlotPerPoint) {
  Blocks blocks(20, 5);
  // Two points in cell 3, one in cell 7 of row 1; three in cell 8 of row 1; one in cell 0 of row 4.
  const auto slots = blocks.lay_out({{1, 3}, {1, 3}, {1, 7}, {1, 8}, {1, 8}, {1, 8}, {4, 0}});
  EXPECT_EQ(slots, (std::vector<std::size_t>{3, 11, 7, 16, 24, 32, 40}));
  ASSERT_EQ(blocks.groups().size(), 3U);
  EXPECT_EQ(blocks.blocks(), 6U);
  EXPECT_FALSE(blocks.scattered());
  const auto none_is_free = [](std::size_t) { return false; };
  EXPECT_EQ(blocks.find_free({1, 3}, none_is_free).slot, 6 * 8 + 3U);
  EXPECT_EQ(blocks.find_free({2, 19}, none_is_free).slot, 7 * 8 + 3U);
  EXPECT_EQ(blocks.find_free({1, 4}, [](std::size_t slot) { return slot == 12; }).slot, 12U);
  blocks.settle();
  ASSERT_EQ(blocks.groups().size(), 4U);
  EXPECT_EQ(blocks.groups()[2].row, 2);
  EXPECT_EQ(blocks.groups()[2].cell, 16);
  while (blocks.find_free({3, 1}, none_is_free).slot != Blocks::no_slot) continue;
  EXPECT_EQ(blocks.blocks(), blocks.capacity());
  EXPECT_TRUE(blocks.scattered());
}

// Of cell 3's three points the first leaves: the last takes its slot, and the block that nobody needs any more goes.
TEST(Blocks, GiveBackWhatNobodyNeeds) {
  Blocks blocks(20, 5);
  const auto slots = blocks.lay_out({{1, 3}, {1, 3}, {1, 3}, {1, 7}});
  EXPECT_EQ(slots, (std::vector<std::size_t>{3, 11, 19, 7}));
  std::vector<bool> holds(blocks.capacity() * Blocks::lanes);
  for (const std::size_t slot : {7, 11, 19}) holds[slot] = true;
  const auto is_free = [&](std::size_t slot) { return !holds[slot]; };
  const Blocks::Gap gap = blocks.gap({1, 3}, is_free);
  EXPECT_EQ(gap.free, 3U);
  EXPECT_EQ(gap.last, 19U);
  holds[3] = true, holds[19] = false;
  EXPECT_FALSE(blocks.gap({1, 3}, is_free).is_there());
  blocks.drop_empty({1, 3}, is_free);
  EXPECT_EQ(blocks.groups()[0].last, 1U);
  const Blocks::Found found = blocks.find_free({3, 0}, is_free);
  EXPECT_EQ(found.slot, 16U);  // in the block that went
  EXPECT_TRUE(found.new_block);
  holds.assign(holds.size(), false);
  blocks.drop_empty({1, 3}, is_free), blocks.drop_empty({3, 0}, is_free), blocks.settle();
  EXPECT_TRUE(blocks.groups().empty());
}

TEST(Blocks, ComeBackFromMemory) {
  Blocks blocks(20, 40), other(20, 40);
  blocks.lay_out({{1, 3}, {1, 3}, {17, 7}, {33, 8}});
  blocks.find_free({20, 1}, [](std::size_t) { return false; }), blocks.settle();
  other.remember(blocks.memory());
  EXPECT_EQ(other.memory(), blocks.memory());
  ASSERT_EQ(other.strips().size(), blocks.strips().size());
  EXPECT_EQ(other.strips().size(), 3U);  // rows 0 to 15 and 32 to 47 first, then those between
  EXPECT_EQ(other.strips()[1].begin, blocks.strips()[1].begin);
  EXPECT_EQ(blocks.groups()[other.strips()[1].begin].row, 33);
}

}  // namespace
}  // namespace tether::mpm
