// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops/channel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tether {
namespace {

Channel::Numbers one(double value) {
  auto numbers = std::make_unique_for_overwrite<double[]>(1);
  numbers[0] = value;
  return numbers;
}

TEST(Channel, HandsOverInOrderNoMoreThanMayWait) {
  Channel channel(3);
  std::atomic<int> put{0}, taken{0}, most{0};
  std::thread giver([&] {
    for (int k = 0; k < 1000; ++k) {
      channel.put(one(k));
      most = std::max(most.load(), ++put - taken);
    }
  });
  for (int k = 0; k < 1000; ++k) {
    const auto numbers = channel.take();
    ++taken;
    ASSERT_EQ(numbers[0], k);
  }
  giver.join();
  EXPECT_LE(most, 4);  // the taker counts after it has taken one
}

TEST(Channel, LetsGoOfWhatNobodyTakes) {
  Channel channel(1);
  channel.put(one(1));
  std::thread giver([&] { channel.put(one(2)), channel.put(one(3)); });
  channel.close();
  giver.join();  // it does not wait
}

}  // namespace
}  // namespace tether
