// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/words.hpp"

#include <gtest/gtest.h>

namespace tether {

enum class Colour { red, dark_blue, nameless };
template <>
inline constexpr std::array<Word<Colour>, 2> words<Colour>{{{Colour::red, "red"}, {Colour::dark_blue, "dark-blue"}}};

namespace {

TEST(Words, AreTheChoicesOfTheDecksTable) { EXPECT_EQ(choices<Colour>, "red|dark-blue"); }

TEST(Words, LeadToTheirEnumeratorsAndBack) {
  EXPECT_EQ(find_word<Colour>("dark-blue"), Colour::dark_blue);
  EXPECT_EQ(find_word<Colour>("dark_blue"), std::nullopt);
  EXPECT_EQ(word_of(Colour::red), "red");
}

TEST(Words, AreNoneForAnEnumeratorThatDecksDoNotName) { EXPECT_THROW(word_of(Colour::nameless), std::logic_error); }

}  // namespace
}  // namespace tether
