// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/verdict.hpp"

#include <cmath>

#include "unit/studies/reproduce/support.hpp"

namespace tether::published {
namespace {

Measured measured(Numbers values, std::size_t runs = 0, std::string failure = {}) {
  const std::size_t count = std::max(values.size(), runs);
  return {std::move(values), count, std::move(failure)};
}

PublishedQuantity of(std::vector<Printed> values) { return {.published = std::move(values)}; }

/// A run that shows a value, as a method's only one.
MethodResult shows(double value, const std::filesystem::path& folder) {
  return {{MadeUpRun{.summary = {{"q", std::to_string(value)}}}.write(folder)}, 1, "", {}};
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

TEST(PrintedDigits, AreTheBand) {
  EXPECT_DOUBLE_EQ(printed("0.0071").band, 0.00005);
  EXPECT_DOUBLE_EQ(printed("3.0").band, 0.05);
  EXPECT_DOUBLE_EQ(printed("-3940").band, 0.5);
  EXPECT_DOUBLE_EQ(printed("1.0e6").band, 5e4);
  EXPECT_DOUBLE_EQ(printed("1.0e6").value, 1e6);
  EXPECT_DOUBLE_EQ(printed("-250 +- 0.1 %").band, 0.25);
}

TEST(Judging, IsWithinHalfAUnitOfTheLastDigit) {
  const Printed period = printed("0.022 (Table 3)");
  const auto verdict = [&](double value) { return compare_with(measured({value}), period, true, true); };
  EXPECT_EQ(verdict(0.02233).text, "agrees with Table 3 within 2.3 %");
  EXPECT_EQ(verdict(0.02233).standing, Standing::agrees);
  EXPECT_EQ(verdict(0.0213).text, "differs from Table 3 by 3.2 % (2.3 % allowed)");
  EXPECT_EQ(verdict(0.0213).standing, Standing::differs);
  EXPECT_EQ(verdict(0.0215).standing, Standing::agrees);  // the edge of what rounds to it
}

/// What was told before: an ensemble of .329 +- .16 agrees with .3 within .05.
TEST(Judging, RunsThatSpreadByMoreThanTheDigitsDecideNothing) {
  const Printed velocity = printed("0.3 (A.1.5)");
  const auto verdict = [&](Numbers values) { return compare_with(measured(std::move(values)), velocity, true, true); };
  EXPECT_EQ(verdict({0.13, 0.329, 0.53}).standing, Standing::undecided);
  EXPECT_EQ(verdict({0.13, 0.329, 0.53}).text, "undecided: runs spread by 67 %, A.1.5 allows 17 %");
  EXPECT_EQ(verdict({0.30, 0.33, 0.36}).standing, Standing::agrees);
  EXPECT_EQ(verdict({0.33, 0.37, 0.41}).standing, Standing::agrees);  // half a digit and the spread, .05 + .04
  EXPECT_EQ(verdict({0.36, 0.40, 0.44}).standing, Standing::differs);
  EXPECT_EQ(verdict({0.1, 0.7, 1.3}).standing, Standing::undecided);
  EXPECT_EQ(compare_with(measured({0.9, 1.0, 1.1}), {1, "exact", 0.05}, true, false).standing, Standing::undecided);
  EXPECT_EQ(compare_with(measured({1.1, 1.2, 1.3}), {1, "exact", 0.15}, true, false).standing, Standing::differs);
}

TEST(Judging, MayBeInTheQuantitysOwnUnit) {
  const Printed zero{0, "exact", 0.015};
  EXPECT_EQ(compare_with(measured({0.01}), zero, true, false).text, "agrees with exact within 0.015");
  EXPECT_EQ(compare_with(measured({-0.02}), zero, true, false).text, "differs from exact by 0.02 (0.015 allowed)");
}

TEST(Reporting, TellsHowFarItIsOffAndNeverFails) {
  const Printed table = printed("2.0 (Table 1)");
  EXPECT_EQ(compare_with(measured({1.5}), table, false, true).text, "-25 % off Table 1");
  EXPECT_EQ(compare_with(measured({2.04}), table, false, true).text, "as Table 1");
  EXPECT_EQ(compare_with(measured({1.5}), table, false, true).standing, Standing::reported);
}

class Judgements : public test::TemporaryFolder {
 protected:
  Judgement judged(PublishedQuantity quantity, double value) {
    quantity.reading = readout("q");
    return judge(quantity, shows(value, folder), {});
  }
};

TEST_F(Judgements, NameWhichOfSeveralPrintedValuesItIs) {
  PublishedQuantity quantity = of({printed("19.8 (Table 1)"), printed("18.44 (Box 7)")});
  quantity.by_published = Judged::thesis;
  EXPECT_EQ(judged(quantity, 18.437).text(), "thesis: agrees with Box 7 within 0.027 %");
  EXPECT_EQ(judged(quantity, 19.79).standing(), Standing::agrees);
  EXPECT_EQ(judged(quantity, 19.2).standing(), Standing::differs);
}

/// A printed value, an exact one and the theory each say something else; the worst counts.
TEST_F(Judgements, CompareWithAllThatThereIs) {
  const PublishedQuantity quantity{.published = {printed("0.022 (Table 3)")},
                                   .by_published = Judged::thesis,
                                   .theory = printed("0.02234 (Table 3)"),
                                   .exact = readout("0.022342"),
                                   .thesis = within_part(0.005)};
  EXPECT_EQ(
      judged(quantity, 0.0223).text(),
      "thesis: agrees with Table 3 within 2.3 %, agrees with exact within 0.5 %; theory: agrees with exact within "
      "0.022 %");
  PublishedQuantity stiffer =
      quantity;  // a tenth more of E: the run has its own exact value, and neither is the thesis'
  stiffer.exact = readout("0.022342/sqrt(1.1)");
  const Judgement judgement = judged(stiffer, 0.0223 / std::sqrt(1.1));
  EXPECT_EQ(judgement.thesis.standing, Standing::differs);
  EXPECT_EQ(judgement.theory.standing, Standing::differs);
  EXPECT_EQ(judgement.standing(), Standing::differs);
}

TEST_F(Judgements, CompareRunsWithATheoryThatLeavesOutWhatTheDeckHas) {
  PublishedQuantity quantity{
      .theory = printed("0.019859 +- 0.1 % (5.11)"), .theory_for = TheoryFor::runs, .exact = readout("0.02019")};
  quantity.thesis_by_theory = within_part(0.01);
  EXPECT_EQ(judged(quantity, 0.01986).text(), "thesis: agrees with theory within 1 %, -1.6 % off exact");
  EXPECT_EQ(judged(quantity, 0.0189).standing(), Standing::differs);
  quantity.theory_for = TheoryFor::nothing;
  EXPECT_EQ(judged(quantity, 0.0189).standing(), Standing::reported);
}

TEST_F(Judgements, OfABoundAreOneSided) {
  PublishedQuantity quantity{.upper_bound = 0.005};
  EXPECT_EQ(judged(quantity, 0.4).text(), "thesis: not below 0.005");
  EXPECT_EQ(judged(quantity, 0.4).standing(), Standing::reported);
  quantity.by_published = Judged::both;
  EXPECT_EQ(judged(quantity, 0.004).text(), "thesis: agrees, below 0.005");
  EXPECT_EQ(judged(quantity, 0.005).standing(), Standing::differs);
}

TEST_F(Judgements, WithoutAValueDifferWhereTheyAreJudged) {
  PublishedQuantity quantity{.reading = readout("q"), .published = {printed("1 (Table 5)")}};
  const MethodResult lost{{}, 10, "it diverged", {}};
  EXPECT_EQ(judge(quantity, lost, {}).text(), "thesis: no value: it diverged");
  EXPECT_EQ(judge(quantity, lost, {}).standing(), Standing::reported);
  quantity.by_published = Judged::thesis;
  EXPECT_EQ(judge(quantity, lost, {}).standing(), Standing::differs);
  quantity.by_published = Judged::robust;
  EXPECT_EQ(judge(quantity, lost, {}).standing(), Standing::reported);
}

using Measuring = test::TemporaryFolder;

TEST_F(Measuring, TakesAFileThatIsNotThereForAMissingValue) {
  const PublishedQuantity quantity{.reading = [](const RunFiles& run) { return run.summary("steps"); }};
  const RunFiles whole = MadeUpRun{.summary = {{"steps", "7"}}}.write(folder / "whole");
  const Measured seen = measure(quantity, {{whole, RunFiles(folder / "none")}, 3, "", {}});
  EXPECT_EQ(seen.values, Numbers{7});
  EXPECT_EQ(seen.runs, 3u);
  EXPECT_NE(seen.failure.find("none/summary.txt"), std::string::npos) << seen.failure;
}

TEST_F(Measuring, TellsOfAReadingThatFindsNothing) {
  const PublishedQuantity quantity{.reading = [](const RunFiles&) { return std::nan(""); }};
  const Measured seen = measure(quantity, {{RunFiles(folder)}, 1, "", {}});
  EXPECT_TRUE(seen.values.empty());
  EXPECT_EQ(seen.failure, "the run does not show it");
}

TEST(ReportRow, HasTheTheoryInAColumnOfItsOwn) {
  const PublishedQuantity quantity{.name = "q",
                                   .reading = {},
                                   .published = {printed("1 (Table 5)")},
                                   .by_published = Judged::thesis,
                                   .theory = printed("1.02 (5.11)")};
  const ReportRow row = report_row({.name = "p"}, quantity, {{}, 10, "it diverged", {}}, {});
  EXPECT_EQ(row.thesis, "-");
  EXPECT_EQ(row.published, "1 (Table 5)");
  EXPECT_EQ(row.theory, "1.02 (5.11)");
  EXPECT_EQ(row.exact, "-");
  EXPECT_EQ(row.verdict, "thesis: no value: it diverged");
  EXPECT_EQ(row.standing, Standing::differs);
}

TEST(TerminalText, CountsHowRowsStand) {
  std::vector<ReportRow> rows(4);
  rows[0].standing = rows[1].standing = Standing::agrees, rows[2].standing = Standing::undecided;
  EXPECT_NE(terminal_text(rows).find("4 rows: 2 agree, 0 differ, 1 are undecided, 1 are reported\n"),
            std::string::npos);
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
  EXPECT_EQ(published_text(of({printed("0.05 (Box 2)"), printed("0.025 (4.2)")})), "0.05 (Box 2) or 0.025 (4.2)");
  EXPECT_EQ(published_text({.upper_bound = 0.005}), "< 0.005");
}

TEST(MarkdownText, NamesDeckAndOverrides) {
  const Problem problem{
      .name = "p", .source = "thesis", .place = "6.2", .deck = "decks/d.in", .thesis = {{"in.tmax=1"}, true}};
  const std::string text =
      markdown_text({{"p", "q | r", "1", "2", "3", "4", "5", "both: reported"}}, {problem}, "tether");
  EXPECT_NE(text.find("| p | q \\| r | 1 | 2 | 3 | 4 | 5 | both: reported |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| p | thesis 6.2 | d.in | in.tmax=1, the step varied by up to 0.5 % in 10 runs | as it is |\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace tether::published
