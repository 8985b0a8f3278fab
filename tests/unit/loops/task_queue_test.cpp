// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/task_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <vector>

namespace tether {
namespace {

TEST(TaskQueue, DoesTasksAtOnceWithoutAThread) {
  TaskQueue queue(10);
  int done = 0;
  queue.give([&] { ++done; }, 100);
  EXPECT_FALSE(queue.has_thread());
  EXPECT_EQ(done, 1);
  EXPECT_THROW(queue.give([] { throw std::runtime_error("full"); }, 0), std::runtime_error);
  queue.wait();
}

TEST(TaskQueue, DoesAllTasksInTheirOrder) {
  std::vector<int> done;
  {
    TaskQueue queue(10);
    queue.start_thread();
    for (int k = 0; k < 1000; ++k) queue.give([&, k] { done.push_back(k); }, static_cast<std::size_t>(k % 14));
    queue.wait();
    EXPECT_EQ(done.size(), 1000U);
    for (int k = 1000; k < 1100; ++k) queue.give([&, k] { done.push_back(k); }, 0);
  }  // its end waits for what has been given
  ASSERT_EQ(done.size(), 1100U);
  for (int k = 0; k < 1100; ++k) EXPECT_EQ(done[static_cast<std::size_t>(k)], k);
}

/// Of what waits and of what is being done.
TEST(TaskQueue, HoldsNoMoreThanItsBound) {
  std::atomic<int> held{0}, most{0};
  TaskQueue queue(100);
  queue.start_thread();
  for (int k = 0; k < 200; ++k) {
    const int bytes = 10 + k % 50;
    queue.make_room(static_cast<std::size_t>(bytes));
    most = std::max(most.load(), held += bytes);
    queue.give([&held, bytes] { held -= bytes; }, static_cast<std::size_t>(bytes));
  }
  queue.wait();
  EXPECT_EQ(held, 0);
  EXPECT_LE(most, 100);
  EXPECT_GT(most, 10);
}

TEST(TaskQueue, TellsOfAFailureAndDoesNothingAfterIt) {
  TaskQueue queue(100);
  queue.start_thread();
  int done = 0;
  std::atomic<bool> go{false};
  queue.give([&] { go.wait(false); }, 0);
  queue.give([] { throw std::runtime_error("full"); }, 0);
  queue.give([&] { ++done; }, 0);
  go = true, go.notify_one();
  EXPECT_THROW(queue.wait(), std::runtime_error);
  queue.wait();  // the error is reported once
  EXPECT_EQ(done, 0);
}

TEST(TaskQueue, LetsGoOfWhatATaskHolds) {
  TaskQueue queue(100);
  queue.start_thread();
  auto held = std::make_shared<int>(1);
  const std::weak_ptr<int> seen = held;
  queue.give([held = std::move(held)] {}, 50);
  queue.wait();
  EXPECT_TRUE(seen.expired());
}

}  // namespace
}  // namespace tether
