// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/thread_team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

#include "unit/waiting.hpp"

namespace tether {
namespace {

class Teams : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Of, Teams, testing::Values(1, 2, 3, 8));

// Most loops have fewer parts than there are threads, or none: those who come late find nothing left to do.
TEST_P(Teams, DoEachPartOfEachLoopOnce) {
  ThreadTeam team(GetParam());
  EXPECT_EQ(team.threads(), GetParam());
  for (std::size_t loop = 0; loop < 3000; ++loop) {
    const std::size_t begin = loop % 3, end = begin + loop % 17;
    std::vector<int> done(begin + 17, 0);
    team.each(begin, end, [&](std::size_t k) { ++done[k]; });
    for (std::size_t k = 0; k < done.size(); ++k)
      ASSERT_EQ(done[k], k >= begin && k < end ? 1 : 0) << "part " << k << " of loop " << loop;
  }
}

// What one loop has written, the next one reads, whoever does it.
TEST_P(Teams, SeeWhatTheLoopBeforeHasWritten) {
  ThreadTeam team(GetParam());
  std::vector<long> numbers(1000, 1);
  for (long loop = 1; loop < 200; ++loop) {
    const long sum = std::accumulate(numbers.begin(), numbers.end(), 0L);
    ASSERT_EQ(sum, 1000 * loop);
    team.each(0, numbers.size(), [&](std::size_t k) { numbers[k] = sum / 1000 + 1; });
  }
}

// Between loops the others go to sleep, and the end of the team wakes them.
TEST_P(Teams, WakeAfterALongPause) {
  ThreadTeam team(GetParam());
  for (int loop = 0; loop < 3; ++loop) {
    std::atomic<int> parts = 0;
    team.each(0, 100, [&](std::size_t) { ++parts; });
    EXPECT_EQ(parts, 100);
    EXPECT_TRUE(test::wait_until([] { return test::sleeping_threads() >= GetParam() - 1; }));
  }
}

TEST(Teams, ShareTheWorkWhereItIsLong) {
  ThreadTeam team(2);
  std::atomic<int> inside = 0;
  team.each(0, 2, [&](std::size_t) {  // each waits for the other, so one thread alone would find nobody
    ++inside;
    EXPECT_TRUE(test::wait_until([&] { return inside == 2; }));
  });
}

}  // namespace
}  // namespace tether
