// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process.hpp"

#include <gtest/gtest.h>

#include <new>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

TEST(Ending, OfWorkThatGoesWellIsSilent) {
  const Ending ending = end_of("x.in", [] {});
  EXPECT_EQ(ending.exit_code, 0);
  EXPECT_EQ(ending.message, "");
}

TEST(Ending, HasTheExitCodeOfTheContract) {
  EXPECT_EQ(end_of("x", [] { throw InputError("wrong", "right"); }).exit_code, 2);
  EXPECT_EQ(end_of("x", [] { throw std::bad_alloc(); }).exit_code, 2);
  EXPECT_EQ(end_of("x", [] { throw RunError("lost"); }).exit_code, 3);
  EXPECT_EQ(end_of("x", [] { throw FileError("full"); }).exit_code, 4);
  EXPECT_EQ(end_of("x", [] { throw Interrupted(2, "stopped"); }).exit_code, 130);
  EXPECT_EQ(end_of("x", [] { throw Interrupted(15, "stopped"); }).exit_code, 143);
}

TEST(Ending, NamesTheWork) {
  EXPECT_EQ(end_of("x.in", [] { throw RunError("point 3 is lost"); }).message, "x.in: error: point 3 is lost\n");
  EXPECT_EQ(end_of("x.in", [] { throw Interrupted(2, "stopped at t = 1"); }).message, "x.in: stopped at t = 1\n");
}

}  // namespace
}  // namespace tether
