// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/nodes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tether {
namespace {

std::vector<std::size_t> visited(const ActiveNodes& active) {
  std::vector<std::size_t> nodes;
  for_nodes(active, [&](std::size_t n) { nodes.push_back(n); });
  return nodes;
}

TEST(ActiveNodes, AreWholeEightsOfTheRowsThatWereMarked) {
  ActiveNodes active(20, 5);
  active.begin();
  active.mark(3, 4, 1, 2), active.mark(17, 25, 2, 2);
  active.end();
  std::vector<std::size_t> expected;
  for (std::size_t n = 20; n < 28; ++n) expected.push_back(n);
  for (std::size_t n = 40; n < 48; ++n) expected.push_back(n);
  for (std::size_t n = 56; n < 60; ++n) expected.push_back(n);
  EXPECT_EQ(visited(active), expected);
  EXPECT_EQ(active.spans().size(), 3U);
  EXPECT_TRUE(active.any_around(8));
  EXPECT_FALSE(active.any_around(90));
  active.begin(), active.end();
  EXPECT_TRUE(visited(active).empty());
}

// Rows that are touched as wholes lie one after the other: lanes run over their ends.
TEST(ActiveNodes, OfWholeRowsAreOneSpan) {
  ActiveNodes active(3, 6);
  active.begin();
  active.mark(0, 1, 1, 3);
  active.end();
  ASSERT_EQ(active.spans().size(), 1U);
  EXPECT_EQ(active.spans()[0].begin, 3U);
  EXPECT_EQ(active.spans()[0].end, 12U);
}

}  // namespace
}  // namespace tether
