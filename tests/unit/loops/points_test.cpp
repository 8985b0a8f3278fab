// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/points.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tether {
namespace {

TEST(LoopsOverPoints, VisitEachSlotInOrder) {
  std::vector<std::size_t> visited;
  for_points({3, 6}, [&](std::size_t p) { visited.push_back(p); });
  EXPECT_EQ(visited, (std::vector<std::size_t>{3, 4, 5}));
  for_points({3, 3}, [&](std::size_t) { FAIL(); });
}

TEST(LoopsOverPoints, AddWhatIsFoundToWhatWasFoundBeforeInTheOrderOfSlots) {
  const std::vector<double> terms{1e-17, 1, -1, 1e-17};
  const auto add = [&](std::size_t p, double& sum) { sum += terms[p]; };
  EXPECT_EQ(find_at_points({0, 4}, 0.0, add), ((1e-17 + 1) - 1) + 1e-17);
  EXPECT_EQ(find_at_points({2, 4}, find_at_points({0, 2}, 0.0, add), add), find_at_points({0, 4}, 0.0, add));
}

}  // namespace
}  // namespace tether
