// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

TEST(SignalWatch, HoldsSignalsBackUntilAskedFor) {
  SignalWatch watch;
  EXPECT_EQ(watch.take(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(watch.take(), SIGTERM);
  EXPECT_EQ(watch.take(), 0);
}

TEST(SignalWatch, WaitEndsWithTheSignal) {
  SignalWatch watch({SIGUSR1});
  std::raise(SIGUSR1);
  EXPECT_EQ(watch.wait(60), SIGUSR1);
  EXPECT_EQ(watch.wait(0.001), 0);
}

TEST(SignalWatch, LeavesTheMaskAsItWas) {
  sigset_t before, after;
  sigprocmask(SIG_BLOCK, nullptr, &before);
  { SignalWatch watch; }
  sigprocmask(SIG_BLOCK, nullptr, &after);
  EXPECT_EQ(sigismember(&before, SIGTERM), 0);
  EXPECT_EQ(sigismember(&after, SIGTERM), 0);
}

}  // namespace
}  // namespace tether
