// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace tether::automatic {
namespace {

using Value = std::function<std::optional<double>(const Resolution&)>;

/// Seconds of a run in the plane.
double seconds(const Resolution& at) { return 0.01 + 0.1 * at.space * at.space * at.time; }

double spent_in(const Search& search) {
  double sum = 0;
  for (const Trial& trial : search.trials()) sum += trial.seconds;
  return sum;
}

Search searched(const Aim& aim, const Value& value) {
  Search search(aim);
  for (auto wanted = search.next(0); !wanted.empty(); wanted = search.next(spent_in(search))) {
    for (const Resolution& at : wanted)
      search.take({.at = at, .wanted = at, .value = value(at), .seconds = seconds(at), .why = NoValue::run, .run = 0});
  }
  return search;
}

Aim aim_of(double tolerance) {
  return {.tolerance = tolerance, .theory = {2., 2.}, .coarsest = {0.25, 0.25}, .powers = {2, 1}};
}

/// The cheapest of a full search over powers of 2^(1/4) whose error is within the tolerance there and at all finer
/// ones.
double least_seconds(const Value& value, double limit, double tolerance) {
  double least = 1e300;
  for (int i = 0; i < 28; ++i) {
    for (int j = 0; j < 28; ++j) {
      const Resolution at{0.25 * std::exp2(i / 4.), 0.25 * std::exp2(j / 4.)};
      if (std::abs(*value(at) - limit) <= tolerance * limit) least = std::min(least, seconds(at));
    }
  }
  return least;
}

TEST(AutomaticSearch, FindsTheCheapestSettingThatKeepsThePromise) {
  const Value value = [](const Resolution& at) {
    return 3 + 0.2 * std::pow(at.space, -2) + 0.1 * std::pow(at.time, -2);
  };
  for (const double tolerance : {0.03, 0.01, 0.003}) {
    const Search search = searched(aim_of(tolerance), value);
    ASSERT_TRUE(search.found()) << search.why_not();
    const Trial& chosen = search.found()->trial;
    EXPECT_LE(std::abs(*chosen.value - 3), 3 * tolerance);
    EXPECT_LE(search.found()->bound, tolerance * 1.01);
    EXPECT_LE(chosen.seconds, 2 * least_seconds(value, 3, tolerance)) << tolerance;
  }
}

TEST(AutomaticSearch, PromisesNothingOfRunsThatAreAllCoarserThanTheDecks) {
  // What only the deck's own cells resolve: all coarser levels agree.
  const Value value = [](const Resolution& at) { return at.space < 1 ? 3. : 4. + 0.01 / at.space; };
  const Search search = searched(aim_of(0.01), value);
  if (!search.found()) return;  // it says that it cannot promise
  EXPECT_NEAR(*search.found()->trial.value, 4, 0.04);
}

TEST(AutomaticSearch, CannotPromiseWhereNothingConverges) {
  const Value value = [](const Resolution& at) { return std::sin(37 * at.space) + std::cos(91 * at.time); };
  const Search search = searched(aim_of(0.01), value);
  EXPECT_FALSE(search.found());
  EXPECT_NE(search.why_not().find("know the limit to"), std::string::npos) << search.why_not();
}

TEST(AutomaticSearch, EndsWithItsBudgetAndSaysWhatItWouldTake) {
  Aim aim = aim_of(1e-5);
  aim.budget = 5;
  const Search search = searched(aim, [](const Resolution& at) { return 3 + 1 / at.space + 1 / at.time; });
  EXPECT_FALSE(search.found());
  EXPECT_LE(spent_in(search), 1.5 * 5);  // the last run may cost more than expected
  EXPECT_NE(search.why_not().find("of the budget"), std::string::npos) << search.why_not();
}

TEST(AutomaticSearch, BeginsFinerWhereCoarseRunsFail) {
  const Value value = [](const Resolution& at) -> std::optional<double> {
    if (at.space < 0.6) return std::nullopt;
    return 3 + 0.2 * std::pow(at.space, -2) + 0.1 * std::pow(at.time, -2);
  };
  const Search search = searched(aim_of(0.01), value);
  ASSERT_TRUE(search.found()) << search.why_not();
  EXPECT_NEAR(*search.found()->trial.value, 3, 0.03);
}

double smooth(const Resolution& at) { return 3 + 0.2 * std::pow(at.space, -2) + 0.1 * std::pow(at.time, -2); }

TEST(AutomaticSearch, AFailureOfCoarseCellsDoesNotCondemnFinerOnes) {
  const Value value = [](const Resolution& at) -> std::optional<double> {
    if (at == Resolution{0.25, 0.5}) return std::nullopt;
    return smooth(at);
  };
  const Search search = searched(aim_of(0.01), value);
  ASSERT_TRUE(search.found()) << search.why_not();
  EXPECT_NEAR(*search.found()->trial.value, 3, 0.03);
}

TEST(AutomaticSearch, TakesFinerStepsWhereTheDecksOwnFail) {
  const Value value = [](const Resolution& at) -> std::optional<double> {
    if (at.space >= 1 && at.time < 2) return std::nullopt;
    return smooth(at);
  };
  const Search search = searched(aim_of(0.003), value);
  ASSERT_TRUE(search.found()) << search.why_not();
  const auto is_own = [](const Trial& trial) {
    return trial.value && trial.wanted.space >= 1 && trial.wanted.time >= 1;
  };
  EXPECT_TRUE(std::ranges::any_of(search.trials(), is_own));
}

TEST(AutomaticSearch, PromisesNothingWhereTheDecksOwnCellsFail) {
  const Value value = [](const Resolution& at) -> std::optional<double> {
    if (at.space >= 1) return std::nullopt;
    return smooth(at);
  };
  const Search search = searched(aim_of(0.3), value);
  EXPECT_FALSE(search.found());
  EXPECT_NE(search.why_not().find("the deck's own cells and steps fail"), std::string::npos) << search.why_not();
}

/// Steps that a limit cuts to 8 a cell whatever the deck says make no other run.
TEST(AutomaticSearch, ABudgetThatIsTooSmallIsNoFailureOfTheCells) {
  Aim aim = aim_of(0.01);
  aim.budget = 0.05;  // two coarse runs
  const Search poor = searched(aim, [](const Resolution& at) { return 1 + 0.1 / at.space; });
  EXPECT_FALSE(poor.has_own_size());
  EXPECT_FALSE(poor.own_size_fails());
  EXPECT_NE(poor.why_not().find("of the budget"), std::string::npos) << poor.why_not();
  const Search failing = searched(aim_of(0.01), [](const Resolution& at) {
    return at.space < 1 ? std::optional(1 + 0.1 / at.space) : std::nullopt;
  });
  EXPECT_TRUE(failing.own_size_fails()) << failing.why_not();
}

TEST(AutomaticSearch, MakesNoRunTwiceWhereALimitCutsTheSteps) {
  Search search(aim_of(0.001));
  for (auto wanted = search.next(0); !wanted.empty(); wanted = search.next(spent_in(search))) {
    for (const Resolution& at : wanted) {
      const Resolution as_run{at.space, std::max(at.time, 8 * at.space)};
      search.take({.at = as_run,
                   .wanted = at,
                   .value = smooth(as_run),
                   .seconds = seconds(as_run),
                   .why = NoValue::run,
                   .run = 0});
    }
  }
  ASSERT_TRUE(search.found()) << search.why_not();
  std::set<std::pair<double, double>> different;
  for (const Trial& trial : search.trials()) different.insert({trial.at.space, trial.at.time});
  EXPECT_LE(search.trials().size(), different.size() + 1);  // the first level is run with two steps
}

TEST(AutomaticSearch, LevelsThatAgreePromiseNothingWithoutARunBesideThem) {
  const Value value = [](const Resolution& at) -> std::optional<double> {
    if (at.space == 1.5) return std::nullopt;
    return 3 + 1e-6 / at.space;
  };
  const Search search = searched(aim_of(0.01), value);
  EXPECT_FALSE(search.found());
  EXPECT_NE(search.why_not().find("may be chance"), std::string::npos) << search.why_not();
}

TEST(AutomaticSearch, SaysWhereEveryRunFails) {
  const Search search = searched(aim_of(0.01), [](const Resolution&) { return std::nullopt; });
  EXPECT_FALSE(search.found());
  EXPECT_NE(search.why_not().find("the deck's own one"), std::string::npos) << search.why_not();
}

TEST(AutomaticSearch, RefinesTimeAloneWhereThereAreNoCells) {
  Aim aim{.tolerance = 0.003, .theory = {std::nullopt, 2.}, .coarsest = {1, 0.25}, .powers = {0, 1}};
  const Search search = searched(aim, [](const Resolution& at) { return 3 + 0.3 * std::pow(at.time, -2); });
  ASSERT_TRUE(search.found()) << search.why_not();
  for (const Trial& trial : search.trials()) EXPECT_EQ(trial.at.space, 1);
  EXPECT_NEAR(*search.found()->trial.value, 3, 0.009);
}

TEST(AutomaticCostLaw, FindsPowers) {
  std::vector<Expense> runs;
  for (const Resolution& at : {Resolution{1, 1}, {1, 2}, {2, 2}, {4, 4}, {4, 8}})
    runs.push_back({at, 0.3 * std::pow(at.space, 3) * std::pow(at.time, 0.5)});
  const CostLaw law(runs, {2, 1});
  EXPECT_NEAR(law.powers().space, 3, 0.3);
  EXPECT_NEAR(law.powers().time, 0.5, 0.3);
  EXPECT_NEAR(law.seconds({2, 4}), 0.3 * 8 * 2, 0.6);
}

}  // namespace
}  // namespace tether::automatic
