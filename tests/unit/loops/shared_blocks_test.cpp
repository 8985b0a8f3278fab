// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "loops/thread_team.hpp"

namespace tether {
namespace {

class Blocks : public testing::TestWithParam<int> {};

TEST_P(Blocks, MakeUpAllOfTheNumbersOnce) {
  ThreadTeam team(GetParam());
  for (const std::size_t count : {0U, 1U, 2047U, 2048U, 2049U, 100000U}) {
    std::vector<int> seen(count, 0);
    each_block(team, count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++seen[k];
    });
    EXPECT_EQ(seen, std::vector<int>(count, 1));
  }
}

TEST_P(Blocks, HaveSumsThatDoNotDependOnThreads) {
  ThreadTeam one(1), team(GetParam());
  for (const std::size_t count : {0U, 3000U, 5000000U}) {  // the last: more blocks of the least size than there are
    const auto part = [](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t k = begin; k < end; ++k) sum += std::sin(static_cast<double>(k));
      return sum;
    };
    const double exact = count == 0 ? 0
                                    : std::sin(0.5 * static_cast<double>(count - 1)) *
                                          std::sin(0.5 * static_cast<double>(count)) / std::sin(0.5);
    EXPECT_EQ(sum_of_blocks(team, count, part), sum_of_blocks(one, count, part));
    EXPECT_NEAR(sum_of_blocks(team, count, part), exact, 1e-9);
  }
}

TEST_P(Blocks, AddWhatIsComputedInOrder) {
  ThreadTeam team(GetParam());
  for (const std::size_t count : {0U, 1U, 7U, 1000U}) {
    std::string added, in_order;
    compute_then_add<std::size_t>(
        team, count, [](std::size_t k, std::size_t& value) { value = k * k; },
        [&](std::size_t k, std::size_t value) { added += std::to_string(k) + ':' + std::to_string(value) + ' '; });
    for (std::size_t k = 0; k < count; ++k) in_order += std::to_string(k) + ':' + std::to_string(k * k) + ' ';
    EXPECT_EQ(added, in_order);
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, Blocks, testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace tether
