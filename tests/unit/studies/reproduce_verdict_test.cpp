// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce_verdict.hpp"

#include <cmath>

#include "unit/studies/reproduce_support.hpp"

namespace tether::published {
namespace {

Measured measured(Numbers values, std::size_t runs = 0, std::string failure = {}) {
  const std::size_t count = std::max(values.size(), runs);
  return {std::move(values), count, std::move(failure)};
}

Quantity of(std::vector<Printed> printed) { return {.published = std::move(printed)}; }

Verdict judge(const Quantity& quantity, double value, Tolerance tolerance) {
  return verdict_on(quantity, measured({value}), tolerance);
}

TEST(Median, IsTheMiddleOrTheMeanOfTwo) {
  EXPECT_EQ(measured({3}).median(), 3);
  EXPECT_EQ(measured({9, 1, 3}).median(), 3);
  EXPECT_EQ(measured({9, 1, 3, 4}).median(), 3.5);
}

TEST(Median, IsNoneWhereHalfOfTheRunsOrMoreDoNotShowIt) {
  EXPECT_TRUE(std::isnan(measured({}, 1).median()));
  EXPECT_TRUE(std::isnan(measured({1, 2, 3, 4, 5}, 10).median()));
  EXPECT_EQ(measured({1, 2, 3, 4, 5, 6}, 10).median(), 3.5);
}

TEST(Spread, IsTheStandardDeviation) {
  EXPECT_DOUBLE_EQ(measured({1, 2, 3, 4}).spread(), std::sqrt(5.0 / 3));
  EXPECT_TRUE(std::isnan(measured({1}).spread()));
}

TEST(Judging, ComparesWithTheExactValueFirst) {
  Quantity quantity = of({{2.0, "Table"}});
  EXPECT_EQ(judge(quantity, 2.02, within_part(0.02)).text, "agrees within 2 %");
  quantity.exact = constant(1.0);
  const Verdict verdict = judge(quantity, 2.02, within_part(0.02));
  EXPECT_EQ(verdict.text, "differs by 102 % (2 % allowed)");
  EXPECT_TRUE(verdict.fails);
  EXPECT_FALSE(judge(quantity, 0.981, within_part(0.02)).fails);
  EXPECT_TRUE(judge(quantity, 0.979, within_part(0.02)).fails);
}

TEST(Judging, MayBeInTheQuantitysOwnUnit) {
  const Quantity quantity{.exact = constant(0)};
  EXPECT_EQ(judge(quantity, 0.01, within(0.015)).text, "agrees within 0.015");
  EXPECT_EQ(judge(quantity, -0.02, within(0.015)).text, "differs by 0.02 (0.015 allowed)");
  EXPECT_TRUE(judge(quantity, -0.02, within(0.015)).fails);
}

TEST(Judging, OfASignedTargetIsOverItsSize) {
  EXPECT_EQ(judge(of({{-0.7, "Fig."}}), -0.77, within_part(0.05)).text, "differs by 10 % (5 % allowed)");
}

TEST(Judging, NamesWhichOfSeveralPrintedValuesItIs) {
  const Quantity quantity = of({{19.8, "Table 1"}, {18.44, "Box 7"}});
  EXPECT_EQ(judge(quantity, 18.437, within_part(0.001)).text, "agrees with Box 7 within 0.1 %");
  EXPECT_EQ(judge(quantity, 19.79, within_part(0.001)).text, "agrees with Table 1 within 0.1 %");
  EXPECT_TRUE(judge(quantity, 19.2, within_part(0.001)).fails);
}

TEST(Judging, OfABoundIsOneSided) {
  const Quantity quantity{.upper_bound = 0.005};
  EXPECT_EQ(judge(quantity, 0.004, within(0)).text, "agrees, below 0.005");
  EXPECT_TRUE(judge(quantity, 0.005, within(0)).fails);
}

TEST(Reporting, TellsHowFarItIsOffAndNeverFails) {
  const auto reported = [](const Quantity& quantity, double value) {
    const Verdict verdict = verdict_on(quantity, measured({value}), std::nullopt);
    EXPECT_FALSE(verdict.fails);
    return verdict.text;
  };
  EXPECT_EQ(reported({}, 5), "reported");
  EXPECT_EQ(reported(of({{2, "Table"}}), 1.5), "reported, -25 %");
  EXPECT_EQ(reported({.exact = constant(0)}, 0.98), "reported, +0.98");
  EXPECT_EQ(reported(of({{2.8, "5.9"}, {0.8, "A.1.6"}}), 2.8), "reported");
  EXPECT_EQ(reported({.upper_bound = 0.005}, 1), "reported");
}

TEST(NoValue, FailsWhereItIsJudged) {
  const Measured lost = measured({}, 10, "it diverged");
  EXPECT_EQ(verdict_on(of({{1, ""}}), lost, within(1)).text, "no value: it diverged");
  EXPECT_TRUE(verdict_on(of({{1, ""}}), lost, within(1)).fails);
  EXPECT_FALSE(verdict_on(of({{1, ""}}), lost, std::nullopt).fails);
}

using Measuring = test::TemporaryFolder;

TEST_F(Measuring, TakesAFileThatIsNotThereForAMissingValue) {
  const Quantity quantity{.reading = [](const RunFiles& run) { return run.summary("steps"); }};
  const RunFiles whole = MadeUpRun{.summary = {{"steps", "7"}}}.write(folder / "whole");
  const Measured seen = measure(quantity, {{whole, RunFiles(folder / "none")}, 3, ""});
  EXPECT_EQ(seen.values, Numbers{7});
  EXPECT_EQ(seen.runs, 3u);
  EXPECT_NE(seen.failure.find("none/summary.txt"), std::string::npos) << seen.failure;
}

TEST_F(Measuring, TellsOfAReadingThatFindsNothing) {
  const Quantity quantity{.reading = [](const RunFiles&) { return std::nan(""); }};
  const Measured seen = measure(quantity, {{RunFiles(folder)}, 1, ""});
  EXPECT_TRUE(seen.values.empty());
  EXPECT_EQ(seen.failure, "the run does not show it");
}

TEST(ReportRow, JudgesEachMethodByItself) {
  const Quantity quantity{.name = "q", .reading = {}, .published = {{1, "Table 5"}}, .thesis = within_part(0.1)};
  Problem problem{.name = "p"};
  const ReportRow row = report_row(problem, quantity, {{}, 10, "it diverged"}, {});
  EXPECT_EQ(row.thesis, "-");
  EXPECT_EQ(row.published, "1 (Table 5)");
  EXPECT_EQ(row.exact, "-");
  EXPECT_EQ(row.verdict, "thesis: no value: it diverged");
  EXPECT_TRUE(row.fails);
}

TEST(ValueText, HasSpreadAndCountOfSeveralRuns) {
  EXPECT_EQ(value_text(measured({1.2345678})), "1.2346");
  EXPECT_EQ(value_text(measured({123034})), "123034");
  EXPECT_EQ(value_text(measured({1, 2, 3}, 4)), "2 +- 1 (3 of 4)");
  EXPECT_EQ(value_text(measured({1, 2, 3})), "2 +- 1 (3)");
  EXPECT_EQ(value_text(measured({2, 2}, 3)), "2 (2 of 3)");
  EXPECT_EQ(value_text(measured({}, 1)), "-");
}

TEST(PublishedText, JoinsWhatContradictsItself) {
  EXPECT_EQ(published_text({}), "-");
  EXPECT_EQ(published_text(of({{0.05, "Box 2"}, {0.025, "4.2"}})), "0.05 (Box 2) or 0.025 (4.2)");
  EXPECT_EQ(published_text({.upper_bound = 0.005}), "< 0.005");
}

TEST(MarkdownText, NamesDeckAndOverrides) {
  const Problem problem{.name = "p", .place = "6.2", .deck = "d", .thesis = {{"in.tmax=1"}, true}};
  const std::string text = markdown_text({{"p", "q | r", "1", "2", "3", "4", "both: reported"}}, {problem}, "tether");
  EXPECT_NE(text.find("| p | q \\| r | 1 | 2 | 3 | 4 | both: reported |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| p | 6.2 | d.in | in.tmax=1, the step varied by up to 0.5 % in 10 runs | as it is |\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace tether::published
