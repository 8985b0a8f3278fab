// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/size.hpp"

namespace tether {
namespace {

TEST(MemoryRefusal, IsEmptyForWhatCanBeHeld) {
  EXPECT_EQ(memory_refusal(BackgroundGrid(2, 2, 0, 1, 0, 1), 0), "");
  EXPECT_EQ(memory_refusal(BackgroundGrid(101, 101, 0, 1, 0, 1), 10000), "");
}

TEST(MemoryRefusal, NamesTheNodesAndTheirMemory) {
  const std::string refusal = memory_refusal(BackgroundGrid(1000000, 1000000, 0, 1, 0, 1), 0);
  EXPECT_TRUE(refusal.starts_with(
      fmt::format("1000000 x 1000000 nodes and 0 points would need {:.4g} GB of memory, and ", 1e3 * bytes_per_node)));
  EXPECT_TRUE(refusal.ends_with(" GB can be used"));
}

TEST(MemoryRefusal, NamesThePointsAndTheirMemory) {
  const std::string refusal = memory_refusal(BackgroundGrid(2, 2, 0, 1, 0, 1), 1e15);
  EXPECT_TRUE(refusal.starts_with(
      fmt::format("2 x 2 nodes and 1e+15 points would need {:.4g} GB of memory, and ", 1e6 * bytes_per_point)));
}

/// Whatever the memory, node and point numbers are of the range of int.
TEST(MemoryRefusal, NumbersBeyondTheRangeOfInt) {
  EXPECT_NE(memory_refusal(BackgroundGrid(46342, 46342, 0, 1, 0, 1), 0), "");
  EXPECT_NE(memory_refusal(BackgroundGrid(2, 2, 0, 1, 0, 1), 2147483648.0), "");
  EXPECT_NE(memory_refusal(BackgroundGrid(2, 2, 0, 1, 0, 1), 1e300), "");
}

}  // namespace
}  // namespace tether
