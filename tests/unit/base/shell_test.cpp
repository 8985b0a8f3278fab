// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shell.hpp"

#include <gtest/gtest.h>
#include <stdio.h>

namespace tether {
namespace {

/// What a shell takes words for: each on a line of its own between brackets.
std::string taken_by_a_shell(const std::vector<std::string>& words) {
  const std::string command = "printf '[%s]\\n' " + shell_command(words);
  FILE* output = popen(command.c_str(), "r");
  std::string text;
  for (int c = fgetc(output); c != EOF; c = fgetc(output)) text += static_cast<char>(c);
  EXPECT_EQ(pclose(output), 0);
  return text;
}

TEST(Shell, TakesEveryWordForItself) {
  const std::vector<std::string> words{"plain-1.in",   "",   "a b", "it's", "\"$HOME\" `date` $(date)",
                                       "two\nlines\n", "\\", "*",   "~",    ";#&|<>!{}[]?",
                                       "\xc3\xa4"};
  std::string expected;
  for (const std::string& word : words) expected += "[" + word + "]\n";
  EXPECT_EQ(taken_by_a_shell(words), expected);
}

TEST(Shell, LeavesHarmlessWordsAsTheyAre) {
  EXPECT_EQ(shell_command({"tether", "out/a_1.in", "--set", "in.nx=3"}), "tether out/a_1.in --set in.nx=3");
  EXPECT_EQ(shell_word("a b"), "'a b'");
}

}  // namespace
}  // namespace tether
