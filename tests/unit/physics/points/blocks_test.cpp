// SPDX-License-Identifier: GPL-3.0-or-later
// Where the points of a body stand that runs by lanes.
#include <gtest/gtest.h>

#include <vector>

#include "physics/points/blocks.hpp"

namespace tether::mpm {
namespace {

/// So many points in cells of a grid of 20 by `rows` cells.
struct In {
  Blocks::Cell cell;
  std::uint32_t points;
};
Blocks laid_out(const std::vector<In>& cells, int rows = 5) {
  Blocks blocks(20, rows);
  std::vector<std::uint32_t> points(20 * static_cast<std::size_t>(rows));
  for (const In& in : cells) points[static_cast<std::size_t>(in.cell.row * 20 + in.cell.cell)] = in.points;
  blocks.lay_out(points);
  return blocks;
}

TEST(Blocks, AChainPerGroupOfCellsAndASlotPerPoint) {
  Blocks blocks = laid_out({{{1, 3}, 2}, {{1, 7}, 1}, {{1, 8}, 3}, {{4, 0}, 1}});
  ASSERT_EQ(blocks.groups().size(), 3U);
  EXPECT_EQ(blocks.groups()[0].layers, 2U);
  EXPECT_EQ(blocks.groups()[1].first, 2U);
  EXPECT_EQ(blocks.groups()[1].points[0], 3U);
  EXPECT_EQ(blocks.groups()[2].cell, 0);
  EXPECT_EQ(blocks.blocks(), 6U);
  EXPECT_FALSE(blocks.scattered());
  const auto enters = [&](Blocks::Cell cell, std::size_t slot, bool new_block) {
    const Blocks::Entered entered = blocks.enter(cell);
    EXPECT_EQ(entered.slot, slot);
    EXPECT_EQ(entered.new_block, new_block);
  };
  enters({1, 3}, 6 * 8 + 3, true);
  enters({2, 19}, 7 * 8 + 3, true);
  enters({1, 4}, 4, false);
  blocks.settle();
  ASSERT_EQ(blocks.groups().size(), 4U);
  EXPECT_EQ(blocks.groups()[2].row, 2);
  EXPECT_EQ(blocks.groups()[2].cell, 16);
  for (int k = 0; k < 20; ++k) blocks.enter({3, 1});
  EXPECT_TRUE(blocks.scattered());
}

TEST(Blocks, GiveBackWhatNobodyNeeds) {
  Blocks blocks = laid_out({{{1, 3}, 3}, {{1, 7}, 1}});
  EXPECT_EQ(blocks.leave({1, 3}), 19U);
  EXPECT_EQ(blocks.groups()[0].layers, 3U);  // until ranks are closed
  blocks.close_ranks({1, 3});
  EXPECT_EQ(blocks.groups()[0].last, 1U);
  const Blocks::Entered entered = blocks.enter({3, 0});
  EXPECT_EQ(entered.slot, 16U);  // in the block that went
  EXPECT_TRUE(entered.new_block);
  for (const Blocks::Cell cell : {Blocks::Cell{1, 3}, {1, 3}, {1, 7}, {3, 0}})
    blocks.leave(cell), blocks.close_ranks(cell);
  blocks.settle();
  EXPECT_TRUE(blocks.groups().empty());
  EXPECT_EQ(blocks.enter({1, 4}).slot % 8, 4U);
}

TEST(Blocks, ComeBackFromMemory) {
  Blocks blocks = laid_out({{{1, 3}, 2}, {{17, 7}, 1}, {{33, 8}, 1}}, 40), other(20, 40);
  blocks.enter({20, 1}), blocks.settle();
  other.remember(blocks.memory());
  EXPECT_EQ(other.memory(), blocks.memory());
  ASSERT_EQ(other.strips().size(), blocks.strips().size());
  EXPECT_EQ(other.strips().size(), 3U);  // rows 0 to 15 and 32 to 47 first, then those between
  EXPECT_EQ(other.strips()[1].begin, blocks.strips()[1].begin);
  EXPECT_EQ(blocks.groups()[other.strips()[1].begin].row, 33);
  EXPECT_EQ(other.enter({1, 3}).slot, blocks.enter({1, 3}).slot);
}

}  // namespace
}  // namespace tether::mpm
