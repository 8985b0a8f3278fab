// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of messages: quoted texts, lines, guesses, ranges.
#include <gtest/gtest.h>

#include <limits>

#include "base/diagnostics.hpp"
#include "deck/spelling.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

TEST(QuotedTexts, AreCutAndShowNoOddBytes) {
  EXPECT_EQ(in_quotes(""), "''");
  EXPECT_EQ(in_quotes(" ~a"), "' ~a'");
  EXPECT_EQ(in_quotes("a\tb\x7f \xc3 "), "'a?b? ? '");
  EXPECT_EQ(in_quotes(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(in_quotes(std::string(61, 'x')), "'" + std::string(29, 'x') + "..." + std::string(28, 'x') + "'");
}

TEST(Remarks, ShowTheLineByTheNumberingOfItsFile) {
  const Texts lines{"one", "two"};
  Diagnostics diagnostics;
  Remarks remarks("a.par", lines, 10, diagnostics);
  for (const int line : {0, 9, 10, 11, 12}) remarks.warn(line, 1, "odd");
  Texts shown;
  for (const auto& d : diagnostics.all()) shown.push_back(d.line_text);
  EXPECT_EQ(shown, (Texts{"", "", "one", "two", ""}));
  EXPECT_EQ(to_text(diagnostics.all()[3]), "a.par:11:1: warning: odd\n  two\n  ^\n");
}

TEST(Guesses, OfVariables) {
  EXPECT_EQ(suggest_variable("in", "gm1"), "'gm1' belongs to group $fluid.");
  EXPECT_EQ(suggest_variable("in", "tsteep"), "Did you mean 'tstep' (group $in)?");
  EXPECT_EQ(suggest_variable("in", "xcentre"), "Did you mean 'xcenter' (group $reg)?");
  EXPECT_EQ(suggest_variable("", "xcentre"), "Did you mean 'xcenter' (group $reg)?");
  EXPECT_EQ(suggest_variable("in", "nothinglike"), "");
  EXPECT_EQ(suggest_variable("in", std::string(41, 'x')), "");
}

TEST(Guesses, AShortNameMayDifferInOneLetterOnly) {
  EXPECT_EQ(suggest_variable("in", "ww"), "Did you mean 'wl' (group $in)?");
  EXPECT_EQ(suggest_variable("in", "qqq"), "");
}

TEST(Guesses, OfGroups) {
  EXPECT_EQ(suggest_group("pionts"), "Did you mean '$points'?");
  EXPECT_TRUE(suggest_group("geometry").starts_with("The groups are $in, $fluid, "));
  EXPECT_EQ(suggest_group(std::string(41, 'x')), suggest_group("geometry"));
}

Variable ranged(ValueType type, double low, double high, std::string_view choices = "") {
  return {"in", "x", type, 0, 1, 1, "", low, high, choices, "", "A test."};
}

TEST(Ranges, AreToldAsTheyAre) {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr double above_zero = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(range_text(ranged(ValueType::real, -none, none)), "");
  EXPECT_EQ(range_text(ranged(ValueType::real, above_zero, none)), "> 0");
  EXPECT_EQ(range_text(ranged(ValueType::real, -1.5, none)), ">= -1.5");
  EXPECT_EQ(range_text(ranged(ValueType::real, 1e-12, 0.5)), "1e-12 to 0.5");
  EXPECT_EQ(range_text(ranged(ValueType::integer, -2147483648.0, 2147483647)), "");
  EXPECT_EQ(range_text(ranged(ValueType::integer, 2, 2147483647)), ">= 2");
  EXPECT_EQ(range_text(ranged(ValueType::integer, -2147483648.0, 5)), "-2147483648 to 5");
  EXPECT_EQ(range_text(ranged(ValueType::logical, 0, 1)), "");
  EXPECT_EQ(range_text(ranged(ValueType::text, -none, none, "a")), "a");
  EXPECT_EQ(range_text(ranged(ValueType::integer, 0, 6, "0|4|6")), "0, 4 or 6");
}

TEST(Types, HintsSayHowEachIsWritten) {
  const auto hint = [](const char* items) { return read_in(items).diagnostics.errors().at(0).hint; };
  EXPECT_EQ(hint("gravc=down"), "Numbers are written as 1.5, 1.5e-3 or 1.5d-3.");
  EXPECT_EQ(hint("wl=left"), "Integers are digits with or without a sign.");
  EXPECT_EQ(hint("large=yes"), "");
  EXPECT_EQ(hint("particles=a.par"), "Write 'a.par'.");
}

}  // namespace
}  // namespace tether::test
