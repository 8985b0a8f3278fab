// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/diagnostics.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

Diagnostic at(Place place, std::string line) {
  return {Severity::error, std::move(place), std::move(line), "what is wrong", "what is right"};
}

TEST(DiagnosticText, HasThePlaceTheLineACaretAndTheHint) {
  EXPECT_EQ(to_text(at({"a.in", 3, 4}, "nx=ten")),
            "a.in:3:4: error: what is wrong\n"
            "  nx=ten\n"
            "     ^\n"
            "  what is right\n");
}

TEST(DiagnosticText, CaretUnderTheFirstAndBehindTheLastLetter) {
  EXPECT_EQ(to_text(at({"a", 1, 1}, "nx")), "a:1:1: error: what is wrong\n  nx\n  ^\n  what is right\n");
  EXPECT_EQ(to_text(at({"a", 1, 3}, "nx")), "a:1:3: error: what is wrong\n  nx\n    ^\n  what is right\n");
  EXPECT_EQ(to_text(at({"a", 1, 5}, "\tx")), "a:1:5: error: what is wrong\n  \tx\n  \t   ^\n  what is right\n");
}

TEST(DiagnosticText, TabsBeforeTheCaretStayTabs) {
  EXPECT_EQ(to_text(at({"a.in", 2, 6}, "\ta\t =b")),
            "a.in:2:6: error: what is wrong\n"
            "  \ta\t =b\n"
            "  \t \t  ^\n"
            "  what is right\n");
}

TEST(DiagnosticText, LeavesOutWhatThePlaceDoesNotName) {
  EXPECT_EQ(to_text(at({"a.in", 3, 0}, "nx=ten")), "a.in:3: error: what is wrong\n  nx=ten\n  what is right\n");
  EXPECT_EQ(to_text(at({"a.in", 0, 0}, "")), "a.in: error: what is wrong\n  what is right\n");
  EXPECT_EQ(to_text(at({}, "")), "error: what is wrong\n  what is right\n");
}

TEST(DiagnosticText, ControlCharactersAreQuestionMarks) {
  using namespace std::string_literals;
  EXPECT_EQ(to_text(at({"a\x1b[1m", 3, 5}, "nx=\0 \x7f\t\r"s)),
            "a?[1m:3:5: error: what is wrong\n  nx=? ?\t?\n      ^\n  what is right\n");
}

TEST(DiagnosticText, WithoutAHintAndAsAWarning) {
  EXPECT_EQ(to_text({Severity::warning, {"a.in", 1, 2}, "xy", "slip", ""}), "a.in:1:2: warning: slip\n  xy\n   ^\n");
}

Diagnostics two_errors_and_a_warning() {
  Diagnostics diagnostics;
  diagnostics.error({"a", 1, 1}, "one", "first");
  diagnostics.warn({"a", 2, 1}, "two", "second", "hint");
  diagnostics.error({"a", 3, 1}, "three", "third", "hint");
  return diagnostics;
}

TEST(DiagnosticsTest, KeepsTheOrderAndTellsTheKindsApart) {
  const Diagnostics diagnostics = two_errors_and_a_warning();
  ASSERT_EQ(diagnostics.all().size(), 3u);
  EXPECT_EQ(diagnostics.all()[1].message, "second");
  ASSERT_EQ(diagnostics.errors().size(), 2u);
  EXPECT_EQ(diagnostics.errors()[0].message, "first");
  EXPECT_EQ(diagnostics.errors()[1].message, "third");
  ASSERT_EQ(diagnostics.warnings().size(), 1u);
  EXPECT_EQ(diagnostics.warnings()[0].hint, "hint");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(DiagnosticsTest, AWarningAloneThrowsNothing) {
  Diagnostics diagnostics;
  EXPECT_NO_THROW(diagnostics.throw_if_errors());
  diagnostics.warn({}, "", "slip");
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_NO_THROW(diagnostics.throw_if_errors());
}

TEST(DiagnosticsTest, ThrowsAllRemarksAtOnceInTheirOrder) {
  try {
    two_errors_and_a_warning().throw_if_errors();
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 3u);
    EXPECT_EQ(error.diagnostics()[1].severity, Severity::warning);
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("a:1:1: error: first\n  one\n  ^\n")) << text;
    EXPECT_TRUE(text.ends_with("a:3:1: error: third\n  three\n  ^\n  hint\n")) << text;
  }
}

TEST(InputErrorTest, OfAMessageAloneIsOneErrorWithoutAPlace) {
  const InputError error("no deck is given", "write tether DECK");
  ASSERT_EQ(error.diagnostics().size(), 1u);
  EXPECT_EQ(error.diagnostics()[0].severity, Severity::error);
  EXPECT_STREQ(error.what(), "error: no deck is given\n  write tether DECK\n");
}

}  // namespace
}  // namespace tether
