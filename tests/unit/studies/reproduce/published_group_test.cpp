// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/file.hpp"
#include "deck/reader.hpp"
#include "plan/load.hpp"
#include "studies/reproduce/problem_of_deck.hpp"
#include "studies/reproduce/reading_functions.hpp"
#include "studies/reproduce/runs.hpp"
#include "unit/studies/reproduce/support.hpp"

namespace tether::published {
namespace {

Mistake mistake_of(const std::string& text) {
  const auto mistakes = read_reading(text).mistakes;
  EXPECT_EQ(mistakes.size(), 1u) << text;
  return mistakes.empty() ? Mistake{} : mistakes.front();
}

TEST(PrintedText, HasValueBandAndPlace) {
  const auto read = read_printed("6.03 (Table 7) or 5.97 +- 3 % (Box 10) or 0 +- 0.5 or = -2 (4.1)");
  ASSERT_EQ(read.values.size(), 4u);
  EXPECT_EQ(read.values[0].place, "Table 7");
  EXPECT_DOUBLE_EQ(read.values[0].band, 0.005);
  EXPECT_DOUBLE_EQ(read.values[1].band, 0.03 * 5.97);
  EXPECT_EQ(read.values[1].place, "Box 10");
  EXPECT_DOUBLE_EQ(read.values[2].band, 0.5);
  EXPECT_DOUBLE_EQ(read.values[3].value, -2);
  EXPECT_DOUBLE_EQ(read.values[3].band, 2e-6);
  EXPECT_EQ(read_printed("< 0.005 (4.1)").upper_bound, 0.005);
}

TEST(PrintedText, ThatIsNoneIsAMistakeWhereItIs) {
  EXPECT_EQ(read_printed("").mistakes.size(), 1u);
  EXPECT_EQ(read_printed("about 3").mistakes.front().column, 1);
  EXPECT_EQ(read_printed("3 (4.1) or x").mistakes.front().column, 12);
  EXPECT_EQ(read_printed("3 +- 0").mistakes.size(), 1u);
  EXPECT_EQ(read_printed("3 +- -1 %").mistakes.size(), 1u);
  EXPECT_EQ(read_printed("1 or < 3").mistakes.front().message, "an upper bound stands alone");
  EXPECT_EQ(read_printed("1.2.3").mistakes.size(), 1u);
  EXPECT_EQ(read_printed("3 (4.1) 4").mistakes.size(), 1u);
}

TEST(ToleranceText, IsAPartOrASize) {
  EXPECT_TRUE(read_tolerance("2 %").tolerance.relative);
  EXPECT_DOUBLE_EQ(read_tolerance("2%").tolerance.size, 0.02);
  EXPECT_FALSE(read_tolerance("1.5e-2").tolerance.relative);
  for (const char* wrong : {"", "%", "-1", "0", "2 % 3", "nan"})
    EXPECT_EQ(read_tolerance(wrong).mistakes.size(), 1u) << wrong;
}

TEST(ReadingText, OfTheDeckAloneIsKnown) {
  EXPECT_TRUE(read_reading("deck(fluid.gm1)*scene(shock_speed) + modulus(1)").of_deck);
  EXPECT_FALSE(read_reading("modulus(1) + period").of_deck);
  EXPECT_FALSE(read_reading("reference(modulus(1))").of_deck);
  EXPECT_FALSE(read_reading("modulus(last(time))").of_deck);
}

TEST(ReadingText, MistakesHaveTheirColumns) {
  EXPECT_EQ(mistake_of("1 + lasst(time)").column, 5);
  EXPECT_EQ(mistake_of("1 + lasst(time)").hint, "Did you mean 'last'?");
  EXPECT_EQ(mistake_of("last(time) + settles(body_x_1)").column, 14);
  EXPECT_EQ(mistake_of("points_sum(x, y ==, last)").column, 19);
  EXPECT_EQ(mistake_of("points_sum(x, 1, then)").column, 18);
  EXPECT_EQ(mistake_of("last(time)*").column, 12);
  EXPECT_EQ(mistake_of("last(time").column, 5);
  EXPECT_EQ(mistake_of("first()").message, "an argument is missing");
  EXPECT_EQ(mistake_of("").column, 1);
}

TEST(ReadingText, MinAndMaxAreOfAColumnOrOfTwoNumbers) {
  EXPECT_TRUE(read_reading("max(min(time), 3)").mistakes.empty());
}

TEST(ReadingFunctions, StandInTheGuide) {
  const std::string guide = read_file(decks / "guide/published.md");
  for (const ReadingFunction& function : reading_functions()) {
    const auto is = function.meaning.find(" is ");
    const std::string row = "| `" + function.meaning.substr(0, is) + "` | " + function.meaning.substr(is + 4) + " |";
    EXPECT_NE(guide.find(row), std::string::npos) << row;
  }
}

class PublishedGroup : public test::TemporaryFolder {
 protected:
  Problem problem(const std::string& name, const std::string& group) {
    write_file(folder / name,
               "$in nx=5, ny=5, xleft=0.0, ybot=0.0, xright=1.0, ytop=1.0, tmax=1.0, tstep=1.0e-3 $\n$published\n" +
                   group + "\n$\n");
    Diagnostics of_the_deck;
    return problem_of(read_deck(read_file(folder / name), (folder / name).string(), {}, of_the_deck), diagnostics);
  }
  std::string errors() const {
    std::string text;
    for (const auto& error : diagnostics.errors())
      text += fmt::format("{}:{}: {}\n", error.place.line, error.place.column, error.message);
    return text;
  }
  Diagnostics diagnostics;
};

TEST_F(PublishedGroup, TakesFromAnotherWhatItLeavesOut) {
  problem(
      "a.in",
      "source='thesis', place='1', thesis_set(1)='in.tmax=2.0', quantity(1)='q', is(1)='period', printed(1)='1 (T)'\n"
      "quantity(2)='twice', is(2)='2*row(1)', exact(2)='3', thesis_within(2)='1 %'");
  const Problem b = problem("b.in", "like='a.in', printed(1)='2 (T)', judged(1)='both'");
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(b.name, "b");
  EXPECT_EQ(b.place, "1");
  EXPECT_EQ(b.thesis.overrides, std::vector<std::string>{"in.tmax=2.0"});
  ASSERT_EQ(b.quantities.size(), 2u);
  EXPECT_EQ(b.quantities[0].published.front().value, 2);
  EXPECT_EQ(b.quantities[0].by_published, Judged::both);
  const RunFiles run = MadeUpRun{.summary = {{"period", "1.5"}}}.write(folder / "run");
  EXPECT_EQ(b.quantities[1].reading(run), 3);
}

TEST_F(PublishedGroup, AllMistakesAreReportedAtTheirPlaces) {
  problem("a.in",
          "quantity(1)='q', is(1)='lasst(time)',\njudged(1)='both', exact(2)='1',\nis(3)='period', deck='none.in'");
  const std::string text = errors();
  EXPECT_NE(text.find("none.in"), std::string::npos) << text;
  diagnostics = {};
  problem("b.in",
          "quantity(1)='q', is(1)='lasst(time)',\njudged(1)='both',\nis(3)='period',\nquantity(4)='r', "
          "thesis_within(4)='1 %'");
  const std::string all = errors();
  EXPECT_NE(all.find("3:25: there is no function lasst"), std::string::npos) << all;
  EXPECT_NE(all.find("4:11: nothing is printed"), std::string::npos) << all;
  EXPECT_NE(all.find("this row has no name"), std::string::npos) << all;
  EXPECT_NE(all.find("this row reads nothing"), std::string::npos) << all;
  EXPECT_NE(all.find("there is no exact value to be near to"), std::string::npos) << all;
}

TEST_F(PublishedGroup, OfADeckWithAPathOfItsOwnHasOneMethod) {
  write_file(folder / "flow.in",
             "$in nx=5, ny=5, xleft=0.0, ybot=0.0, xright=1.0, ytop=1.0, tmax=1.0, tstep=1.0e-3 $\n$coupled $\n");
  const Problem flow = problem("p.in", "deck='flow.in', quantity(1)='q', is(1)='period'");
  EXPECT_EQ(errors(), "");
  EXPECT_FALSE(flow.by_points);
  EXPECT_FALSE(flow.robust);
  const auto runs = plan_runs({flow}, "out");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(runs[0].study.sets.empty());
}

TEST_F(PublishedGroup, OfAUsersOwnDeckIsNamedByItsPath) {
  problem("mine.in", "quantity(1)='q', is(1)='period'");
  const auto problems = problems_named({(folder / "mine.in").string()}, folder / "nowhere");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].name, "mine");
}

TEST(PublishedGroupOfADeck, SaysNothingToTheRun) {
  EXPECT_EQ(load((decks / "spring-mass.in").string(), {}).effective.find("$published"), std::string::npos);
}

}  // namespace
}  // namespace tether::published
