// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/warned.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

enum class Doubt { one, two, last = 61 };

TEST(Warned, OfEachDoubtOnce) {
  long long warned = 0;
  EXPECT_FALSE(is_warned(warned, Doubt::two));
  EXPECT_TRUE(note_warning(warned, Doubt::two));
  EXPECT_FALSE(note_warning(warned, Doubt::two));
  EXPECT_TRUE(is_warned(warned, Doubt::two));
  EXPECT_FALSE(is_warned(warned, Doubt::one));
  EXPECT_TRUE(note_warning(warned, Doubt::last));
  EXPECT_TRUE(note_warning(warned, Doubt::one));
  const long long saved = warned;
  EXPECT_FALSE(note_warning(warned, Doubt::last));
  EXPECT_EQ(warned, saved);
}

}  // namespace
}  // namespace tether
