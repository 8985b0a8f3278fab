// SPDX-License-Identifier: GPL-3.0-or-later
// The first error stands where the mistake is, and reading goes on so that no other follows from it.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

TEST(Places, WhatIsMissingIsToldLast) {
  EXPECT_EQ(read("$in\nnx=11 particles=../a.par ny=21\n$\n").errors(),
            (Texts{"2:17: particles must be a text in quotes, not '..'",
                   "1:1: $in lacks ny, xleft, xright, ybot, ytop, tmax, tstep, which have no default"}));
  EXPECT_EQ(read("$inn\nnx=11\n$\n").errors(), (Texts{"1:1: there is no group '$inn'", "0:0: there is no group $in"}));
}

TEST(Places, TheItemThatLeavesARequiredVariableEmpty) {
  EXPECT_EQ(read(with_in("nx=,\n$\n")).errors(), Texts{});
  EXPECT_EQ(read("$in ny=21,xleft=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1\nnx=,\nnx=1*\n$\n").errors(),
            (Texts{"2:1: nx has no default: it needs a value"}));
}

TEST(Places, TheBoundOutOfRange) {
  EXPECT_EQ(read_reg("nreg=1 xvi(1:21,2)=0.").errors(), (Texts{"5:14: subscript 21 of xvi is out of range"}));
  EXPECT_EQ(read_reg("nreg=1 xvi(1,0:2)=0.").errors(), (Texts{"5:14: subscript 0 of xvi is out of range"}));
  EXPECT_EQ(read_reg("nreg=1 nvi(1:\n 99)=0").errors(), (Texts{"6:2: subscript 99 of nvi is out of range"}));
}

TEST(Places, TheVariableThatLacksItsEqualSign) {
  EXPECT_EQ(read_in("iout(13)\n1").errors(), (Texts{"3:1: '=' is missing after 'iout'"}));
}

TEST(Places, BlanksBeforeEndCloseTheGroup) {
  const auto reading = read(with_in("wl=4 $ end\n$reg nreg=2\n& END ! done\n$mpm cfl=1. /\n"));
  EXPECT_EQ(reading.errors(), (Texts{"3:6: blanks before 'end'", "5:1: blanks before 'end'"}));
  EXPECT_EQ(reading.diagnostics.errors()[0].hint, "Write '$end'.");
  EXPECT_EQ(reading.diagnostics.errors()[1].hint, "Write '&end'.");
  EXPECT_EQ(reading.deck.integer("reg.nreg"), 2);
  EXPECT_TRUE(reading.deck.has_group("mpm"));
}

TEST(Places, AQuoteInsideAText) {
  const auto reading = read_in("particles='it's' wl=4");
  EXPECT_EQ(reading.errors(),
            (Texts{"3:11: 's' right after the quote that closes this text",
                   "3:15: particles takes one value, this is one too many", "3:16: this quote is never closed"}));
  EXPECT_EQ(reading.diagnostics.errors()[0].hint,
            "Is it closed where it should be? A quote inside a text is written twice: 'it''s'.");
  EXPECT_EQ(read_in("units=\"si\"'cgs' wl=4").errors().front(), "3:7: ''' right after the quote that closes this text");
}

TEST(Places, AnUnclosedTextEndsWithItsFirstWord) {
  const auto reading = read(with_in("units='si wl=4,\nwr=4 ! it's\n$\n"));
  EXPECT_EQ(reading.errors(), (Texts{"3:7: 's' right after the quote that closes this text"}));
  EXPECT_EQ(reading.deck.text("in.units"), "si");
  EXPECT_EQ(reading.deck.integer("in.wl"), 4);
  EXPECT_EQ(reading.deck.integer("in.wr"), 4);
  EXPECT_EQ(read(with_in("units='cgs,wl=7/\n")).errors(),
            (Texts{"3:7: this quote is never closed", "3:15: wl = 7 is out of range"}));
}

TEST(Places, ATextMayStandBeforeAnyMark) {
  for (const char* items : {"units='si',wl=4", "units='si'/", "units='si'$", "units='si'$end", "units='si'!note",
                            "units='si'\twl=4", "particles='a\nb' wl=4", "units=1*'si' wl=4"}) {
    EXPECT_EQ(read_in(items).errors(), Texts{}) << items;
  }
}

/// Byte by byte: quotes written twice, ends of lines that a text goes on over, the closing quote.
TEST(Places, WithinAText) {
  const auto reading = read_in("particles='it''s\n.par',wl=4,\nunits='si'");
  EXPECT_EQ(reading.deck.text("in.particles"), "it's.par");
  const auto at = [&](std::size_t offset) {
    const Place place = reading.deck.place_within("in.particles", {1, 1}, offset);
    return std::pair(place.line, place.column);
  };
  EXPECT_EQ(at(0), std::pair(3, 12));
  EXPECT_EQ(at(2), std::pair(3, 14));
  EXPECT_EQ(at(3), std::pair(3, 16));
  EXPECT_EQ(at(4), std::pair(4, 1));
  EXPECT_EQ(at(8), std::pair(4, 5));
  const Diagnostic remark = reading.deck.remark_within(Severity::error, "in.particles", {1, 1}, 4, "here");
  EXPECT_EQ(to_text(remark), "a.in:4:1: error: here\n  .par',wl=4,\n  ^\n");
  const auto set = read(with_in("$\n"), {"in.units='si'"});
  const Place place = set.deck.place_within("in.units", {1, 1}, 1);
  EXPECT_EQ((std::pair{place.line, place.column}), std::pair(1, 12));
}

}  // namespace
}  // namespace tether::test
