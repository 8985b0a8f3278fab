// SPDX-License-Identifier: GPL-3.0-or-later
// Which instructions points by lanes take, by what is asked for in the environment.
#include "loops/instruction_set.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/diagnostics.hpp"

namespace tether {
namespace {

class InstructionSets : public testing::Test {
 protected:
  void TearDown() override { ::unsetenv("TETHER_TARGET"); }

  static InstructionSet asked(const char* word) {
    ::setenv("TETHER_TARGET", word, 1);
    return instruction_set();
  }
  static std::string refusal(const char* word) {
    try {
      asked(word);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(InstructionSets, TheBestIsTakenUnlessAnotherIsAskedFor) {
  EXPECT_TRUE(has(instruction_set()));
  EXPECT_EQ(asked(""), instruction_set());
  EXPECT_EQ(asked("one"), InstructionSet::one);
}

TEST_F(InstructionSets, AWordThatIsNoneIsRefused) {
  EXPECT_NE(refusal("neon").find("TETHER_TARGET=neon is no set of instructions"), std::string::npos) << refusal("neon");
}

TEST_F(InstructionSets, TwoLanesAreThereWhereTheyWereBuilt) {
#ifdef TETHER_SSE
  EXPECT_EQ(refusal("sse2"), "");
#else
  EXPECT_FALSE(has(InstructionSet::sse2));
  EXPECT_NE(refusal("sse2").find("this program was built without these instructions"), std::string::npos);
#endif
}

}  // namespace
}  // namespace tether
