// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/letters.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <limits>
#include <memory>
#include <thread>

#include "base/diagnostics.hpp"
#include "unit/waiting.hpp"

namespace tether {
namespace {

/// Two boxes that lead to each other.
struct Pair {
  Pair() {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) throw FileError("no sockets");
    here = std::make_unique<LetterBox>(ends[0]), there = std::make_unique<LetterBox>(ends[1]);
  }
  std::unique_ptr<LetterBox> here, there;
};

TEST(Letters, ComeInTheirOrderAndWhole) {
  Pair pair;
  EXPECT_FALSE(pair.there->take());
  pair.here->send({7, "one"});
  pair.here->send({-1, std::string("\0two\n", 5)});
  pair.here->send({0, ""});
  const auto first = pair.there->take(), second = pair.there->take(), third = pair.there->take();
  ASSERT_TRUE(first && second && third);
  EXPECT_EQ(first->who, 7);
  EXPECT_EQ(first->text, "one");
  EXPECT_EQ(second->who, -1);
  EXPECT_EQ(second->text, std::string("\0two\n", 5));
  EXPECT_EQ(third->text, "");
  EXPECT_FALSE(pair.there->take());
}

TEST(Letters, OfAnyLengthNeedNobodyWhoWaits) {
  Pair pair;
  const std::string text(5'000'000, 'x');
  EXPECT_FALSE(pair.here->send_without_waiting({1, text}));  // no socket takes that at once
  std::optional<Letter> letter;
  while (!letter) {
    letter = pair.there->take();
    pair.here->send_rest_without_waiting();
  }
  EXPECT_EQ(letter->text, text);
}

TEST(Letters, ThatCameBeforeTheEndAreRead) {
  Pair pair;
  pair.here->send({1, "last words"});
  pair.here.reset();
  const auto letter = pair.there->take();
  ASSERT_TRUE(letter);
  EXPECT_EQ(letter->text, "last words");
  EXPECT_FALSE(pair.there->take());
  EXPECT_TRUE(pair.there->is_closed());
  pair.there->send({1, "to nobody"});  // does no harm
}

TEST(Letters, AreWaitedForUntilTheOtherEndCloses) {
  Pair pair;
  std::thread sender([&pair, reader = test::this_thread()] {
    EXPECT_TRUE(test::wait_until([&reader] { return test::sleeps(reader); }));
    pair.here->send({3, "late"});
    pair.here.reset();
  });
  const auto letter = pair.there->wait();
  ASSERT_TRUE(letter);
  EXPECT_EQ(letter->text, "late");
  EXPECT_FALSE(pair.there->wait());
  sender.join();
}

TEST(Packed, GivesBackItsPartsInTheirOrder) {
  const double infinite = std::numeric_limits<double>::infinity();
  Packed parts(Packed().add("a:b\n").add(1. / 3).add(std::vector<std::string>{"", "3:x"}).add(infinite).text());
  EXPECT_EQ(parts.take_text(), "a:b\n");
  EXPECT_EQ(parts.take_number(), 1. / 3);
  EXPECT_EQ(parts.take_texts(), (std::vector<std::string>{"", "3:x"}));
  EXPECT_EQ(parts.take_number(), infinite);
  EXPECT_THROW(parts.take_text(), FileError);
}

TEST(Packed, RefusesWhatIsCutShort) {
  for (const char* text : {"", "3", "3:ab", "x:abc", "-1:", ":", "1:x"})
    EXPECT_THROW(Packed(text).take_number(), FileError);
}

}  // namespace
}  // namespace tether
