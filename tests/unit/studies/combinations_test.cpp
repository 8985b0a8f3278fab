// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/combinations.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Texts = std::vector<std::string>;

/// An axis of n values named letter1, letter2 ...
StudyAxis axis(const std::string& letter, std::size_t n, std::size_t leader) {
  StudyAxis result{letter, {}, {}, leader};
  for (std::size_t k = 1; k <= n; ++k) {
    result.overrides.push_back(letter + std::to_string(k));
    result.cells.emplace_back(static_cast<double>(k));
  }
  return result;
}

/// Each combination as its deck and its overrides in one word.
Texts words(const Study& study) {
  Texts all;
  for (const auto& combination : combinations(study)) {
    all.push_back(study.decks[combination.deck].file);
    for (const auto& word : overrides_of(study, combination, {})) all.back() += word;
  }
  return all;
}

TEST(Combinations, TheFirstAxisIsFastestTheDecksSlowest) {
  Study study;
  study.decks = {{1, "D", ""}, {2, "E", ""}};
  study.axes = {axis("a", 2, 0), axis("b", 3, 1)};
  EXPECT_EQ(words(study), (Texts{"Da1b1", "Da2b1", "Da1b2", "Da2b2", "Da1b3", "Da2b3", "Ea1b1", "Ea2b1", "Ea1b2",
                                 "Ea2b2", "Ea1b3", "Ea2b3"}));
  EXPECT_EQ(count_combinations(study), 12);
}

TEST(Combinations, LinkedAxesMoveTogether) {
  Study study;
  study.decks = {{1, "D", ""}};
  study.axes = {axis("a", 3, 0), axis("b", 2, 1), axis("c", 3, 0), axis("d", 2, 1)};
  EXPECT_EQ(words(study), (Texts{"Da1b1c1d1", "Da2b1c2d1", "Da3b1c3d1", "Da1b2c1d2", "Da2b2c2d2", "Da3b2c3d2"}));
  EXPECT_EQ(count_combinations(study), 6);
}

TEST(Combinations, WithoutAxesADeckIsOneRun) {
  Study study;
  study.decks = {{1, "D", ""}, {2, "E", ""}};
  EXPECT_EQ(words(study), (Texts{"D", "E"}));
}

TEST(Overrides, SharedOnesFirstTheVariedValueLast) {
  Study study;
  study.decks = {{1, "D", ""}};
  study.axes = {axis("a", 1, 0)};
  study.sets = {"in.wl=1", "in.wr=1"};
  study.vary.variable = "in.gravc";
  const double third = 1.0 / 3;
  const auto overrides = overrides_of(study, combinations(study)[0], third);
  EXPECT_EQ(overrides, (Texts{"in.wl=1", "in.wr=1", "a1", "in.gravc=0.3333333333333333"}));
}

TEST(EnsembleFactors, EvenlyWithBothEnds) {
  EXPECT_EQ(ensemble_factors(0.5, 5), (std::vector<double>{0.5, 0.75, 1, 1.25, 1.5}));
  EXPECT_EQ(ensemble_factors(0.25, 2), (std::vector<double>{0.75, 1.25}));
}

/// The run as it ended, with a key of its summary.
FinishedRun ended(const Variant& variant, double value) {
  return {variant, {"", {exit_done, ""}, 0, 0}, false, {{"growth", value}}};
}

TEST(Sequences, AGridWantsAllAtOnceAndNothingLater) {
  Study study;
  study.decks = {{1, "D", ""}};
  study.axes = {axis("a", 3, 0)};
  Sequences sequences(study);
  const auto wanted = sequences.first();
  ASSERT_EQ(wanted.size(), 3u);
  EXPECT_EQ(wanted[2].combination, 2u);
  EXPECT_FALSE(wanted[2].varied);
  EXPECT_TRUE(sequences.after(ended(wanted[0], 1)).empty());
}

TEST(Sequences, AnEnsembleVariesEachCombinationsOwnValue) {
  Study study;
  study.mode = Mode::ensemble;
  study.decks = {{1, "D", ""}, {2, "E", ""}};
  study.fraction = 0.5;
  study.runs = 3;
  study.own_values = {10, -4};
  const auto wanted = Sequences(study).first();
  ASSERT_EQ(wanted.size(), 6u);
  std::vector<double> values;
  for (const auto& variant : wanted) values.push_back(*variant.varied);
  EXPECT_EQ(values, (std::vector<double>{5, 10, 15, -2, -4, -6}));
  EXPECT_EQ(wanted[4].combination, 1u);
  EXPECT_EQ(wanted[4].number, 1u);
}

TEST(Sequences, BisectionsOfTwoCombinationsDoNotMix) {
  Study study;
  study.mode = Mode::bisect;
  study.decks = {{1, "D", ""}, {2, "E", ""}};
  study.interval = {0, 4, 0.25};
  study.criterion = {"growth", -1, 100};
  Sequences sequences(study);
  const auto ends = sequences.first();
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_TRUE(sequences.after(ended(ends[0], 1)).empty());
  EXPECT_TRUE(sequences.after(ended(ends[3], 1e9)).empty());
  const auto middle = sequences.after(ended(ends[1], 1e9));
  ASSERT_EQ(middle.size(), 1u);
  EXPECT_EQ(middle[0].combination, 0u);
  EXPECT_EQ(middle[0].number, 2u);
  EXPECT_EQ(*middle[0].varied, 2);
  EXPECT_EQ(*sequences.after(ended(middle[0], 1)).at(0).varied, 3);
}

TEST(Sequences, ARunWithoutTheKeyDoesNotHold) {
  Study study;
  study.mode = Mode::bisect;
  study.decks = {{1, "D", ""}};
  study.interval = {0, 4, 0.25};
  study.criterion = {"growth", -1, 100};
  Sequences sequences(study);
  const auto ends = sequences.first();
  sequences.after(ended(ends[0], 1));
  const FinishedRun lost{ends[1], {"", {exit_run, "lost"}, 0, 0}, false, {}};
  EXPECT_EQ(*sequences.after(lost).at(0).varied, 2);
  EXPECT_EQ(lost.value(exit_code_key), 3);
}

}  // namespace
}  // namespace tether
