// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/child.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace tether {
namespace {

TEST(FromAChild, ComesAllThatItMakes) {
  std::string bytes;
  for (int k = 0; k < 1000000; ++k) bytes.push_back(static_cast<char>(k * k));
  int here = 1;
  EXPECT_EQ(from_a_child([&] {
              here = 2;  // in the child alone
              return bytes;
            }),
            bytes);
  EXPECT_EQ(here, 1);
  EXPECT_EQ(from_a_child([] { return std::string(); }), "");
}

TEST(FromAChild, ComesNothingWhereItFails) {
  EXPECT_EQ(from_a_child([]() -> std::string { throw std::runtime_error("no"); }), std::nullopt);
  EXPECT_EQ(from_a_child([]() -> std::string {
              raise(SIGKILL);
              return "never";
            }),
            std::nullopt);
}

TEST(SaidBy, ComeWordsOfBothOutputsAndTheExitCode) {
  EXPECT_EQ(said_by({"sh", "-c", "echo \"$0\"; echo b >&2; exit 7", "a b'c"}), std::pair(7, std::string("a b'c\nb\n")));
  EXPECT_EQ(said_by({"no-program-has-this-name"}), std::pair(127, std::string()));
  EXPECT_EQ(said_by({"sh", "-c", "kill -9 $$"}), std::pair(-1, std::string()));
}

}  // namespace
}  // namespace tether
