// SPDX-License-Identifier: GPL-3.0-or-later
// Decks that tell of many runs.
#include <gtest/gtest.h>

#include "deck/document.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

const std::string study_text = "$study decks='../sod.in' axis(1)='in.nx=11,21' quantities='error_rho','steps' $\n";

TEST(StudyDeck, NeedsNothingOfARun) {
  const auto reading = read(study_text);
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(), Texts{});
  EXPECT_TRUE(reading.deck.is_study());
  EXPECT_FALSE(reading.deck.complete());
  EXPECT_EQ(reading.deck.text("study.mode"), "grid");
  EXPECT_EQ(reading.deck.text("study.quantities", 2), "steps");
}

TEST(StudyDeck, HasNoOtherGroup) {
  EXPECT_EQ(read(study_text + "$mpm /\n").errors(), (Texts{"1:1: $study stands beside $mpm"}));
  EXPECT_EQ(read(study_text + "$in nx=3 /\n$mpm /\n").errors(), (Texts{"1:1: $study stands beside $in"}));
  EXPECT_EQ(read(study_text, {"fluid.mu=1."}).errors(), (Texts{"1:1: $study stands beside $fluid"}));
  EXPECT_FALSE(read(with_in("$\n")).deck.is_study());
}

TEST(StudyDeck, IsListedAndWrittenWithItsOwnGroupOnly) {
  const auto deck = read(study_text).deck;
  EXPECT_EQ(deck.possible_groups(), Texts{"study"});
  EXPECT_TRUE(check_listing(deck).starts_with("$study\n"));
  const auto effective = effective_deck(deck);
  EXPECT_TRUE(effective.starts_with("$study\nmode = 'grid'\ndecks(1) = '../sod.in'\n")) << effective;
  EXPECT_EQ(effective_deck(read(effective).deck), effective);
}

TEST(StudyDeck, IsNoGroupOfARun) {
  const auto deck = read(with_in("$\n")).deck;
  EXPECT_EQ(check_listing(deck, {.all = true}).find("$study"), std::string::npos);
  EXPECT_EQ(effective_deck(deck).find("$study"), std::string::npos);
}

}  // namespace
}  // namespace tether::test
