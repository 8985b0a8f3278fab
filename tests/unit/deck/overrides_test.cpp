// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

const std::string deck_text = with_in("iout(13)=1,tiout(13)=.1\n$\n$reg nreg=2,nprg=4,4 /\n");

TEST(Overrides, ReplaceSilently) {
  const auto reading = read(deck_text, {"in.tmax=0.5d0", "IN.Wl = 4", "reg.nprg(2)=9", "reg.ipath(1,2)=3,3,3,7"});
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(), Texts{});
  EXPECT_EQ(reading.deck.real("in.tmax"), 0.5);
  EXPECT_EQ(reading.deck.integer("in.wl"), 4);
  EXPECT_EQ(reading.deck.integer("reg.nprg", 1), 4);
  EXPECT_EQ(reading.deck.integer("reg.nprg", 2), 9);
  EXPECT_EQ(reading.deck.integer("reg.ipath", 4, 2), 7);
}

/// Once the last of them held without a word, where a deck that sets a value twice is warned of.
TEST(Overrides, OfOneValueTwiceAreWarnedOf) {
  const auto reading = read(deck_text, {"in.tmax=.5", "in.wl=4", "in.tmax=.25", "reg.nprg=9", "reg.nprg(2)=9"});
  EXPECT_EQ(reading.warnings(), (Texts{"3:9: tmax is set twice by --set; the later value holds"}));
  EXPECT_EQ(reading.deck.real("in.tmax"), 0.25);
}

/// A shell takes quotes away; a deck needs them.
TEST(Overrides, OfTextsNeedNoQuotes) {
  const auto deck = read(deck_text, {"mpm.order=usl", "in.particles=a.par", "mesh.element(1)=Q2"}).deck;
  EXPECT_EQ(deck.text("mpm.order"), "usl");
  EXPECT_EQ(deck.text("in.particles"), "a.par");
  EXPECT_EQ(read(deck_text, {"in.tmax=soon"}).errors(), (Texts{"1:9: tmax must be a number, not 'soon'"}));
  const auto wrong = read(deck_text, {"flow.element=q1"}).diagnostics.errors().front();
  EXPECT_NE(wrong.hint.find("q1q1 or q2q1"), std::string::npos) << wrong.hint;
}

TEST(Overrides, HavePlacesOfTheirOwn) {
  const auto reading = read(deck_text, {"in.wl=4", "in.tmax=0.5"});
  const auto place = reading.deck.place("in.tmax");
  EXPECT_EQ(place.file, "--set");
  EXPECT_EQ(place.line, 2);
  EXPECT_EQ(place.column, 9);
  EXPECT_EQ(reading.deck.line_text(place), "in.tmax=0.5");
  EXPECT_EQ(to_text(reading.deck.remark(Severity::error, "in.tmax", {1, 1}, "too short")),
            "--set:2:9: error: too short\n  in.tmax=0.5\n          ^\n");
}

TEST(Overrides, OpenGroupsThatTheDeckLacks) {
  const auto deck = read(deck_text, {"mpm.order='usl'"}).deck;
  EXPECT_TRUE(deck.has_group("mpm"));
  EXPECT_EQ(deck.text("mpm.order"), "usl");
}

TEST(Overrides, TextsMayHoldWhatClosesGroups) {
  EXPECT_EQ(read(deck_text, {"in.particles='../particles/a.par'"}).deck.text("in.particles"), "../particles/a.par");
}

TEST(Overrides, CanGiveWhatIsRequired) {
  EXPECT_EQ(read("$in nx=3 ny=3 xleft=0. xright=1. ybot=0. ytop=1. tmax=1. /", {"in.tstep=.1"}).errors(), Texts{});
}

struct WrongOverride {
  const char* text;
  Texts errors;
};

void PrintTo(const WrongOverride& wrong, std::ostream* out) { *out << wrong.text; }

class WrongOverrides : public testing::TestWithParam<WrongOverride> {};

TEST_P(WrongOverrides, AreToldWithTheirPlace) {
  const auto reading = read(deck_text, {"in.wl=4", GetParam().text});
  EXPECT_EQ(reading.errors(), GetParam().errors);
  for (const auto& error : reading.diagnostics.errors()) {
    EXPECT_EQ(error.place.file, "--set");
    EXPECT_EQ(error.line_text, GetParam().text);
  }
}

INSTANTIATE_TEST_SUITE_P(Overrides, WrongOverrides,
                         testing::Values(WrongOverride{"", {"2:1: this is no override"}},
                                         WrongOverride{"in.wl", {"2:1: this is no override"}},
                                         WrongOverride{"tmax=0.5", {"2:1: 'tmax' names no group"}},
                                         WrongOverride{"inn.tmax=0.5", {"2:1: 'inn.tmax' names no group"}},
                                         WrongOverride{".tmax=0.5", {"2:1: '.tmax' names no group"}},
                                         WrongOverride{"in.tmx=0.5", {"2:4: $in has no variable 'tmx'"}},
                                         WrongOverride{"in.nx=1", {"2:7: nx = 1 is out of range"}},
                                         WrongOverride{"in.iout(61)=1", {"2:9: subscript 61 of iout is out of range"}},
                                         WrongOverride{"in.wr==1", {"2:7: '=' among the values of 'in.wr'"}},
                                         WrongOverride{"in.wr=1 wb=1", {"2:9: one override sets one variable"}},
                                         WrongOverride{"in.wr=1/2", {"2:1: a group ends in this override"}},
                                         WrongOverride{"in.wr=1 $", {"2:1: a group ends in this override"}},
                                         WrongOverride{"in.particles='x", {"2:14: this quote is never closed"}}));

TEST(Overrides, SayWhatWouldBeRight) {
  const auto hint = [](const char* text) { return read(deck_text, {text}).diagnostics.errors().front().hint; };
  EXPECT_EQ(hint("tmax=0.5"), "An override is group.name=value. 'tmax' belongs to group $in.");
  EXPECT_EQ(hint("flid.mu=0.5"), "An override is group.name=value. Did you mean '$fluid'?");
  EXPECT_EQ(hint("in.tmx=1."), "Did you mean 'tmax' (group $in)?");
}

TEST(Overrides, DoNotMakeUpForAMissingIn) {
  EXPECT_EQ(read("a title\n", {"reg.nreg=1"}).errors(), (Texts{"0:0: there is no group $in"}));
}

}  // namespace
}  // namespace tether::test
