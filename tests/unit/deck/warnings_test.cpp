// SPDX-License-Identifier: GPL-3.0-or-later
// What reads well but can hardly be meant. The slips of the printed decks stand in boxes_test.cpp.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

TEST(Warnings, ASoundDeckHasNone) {
  const auto reading =
      read(with_in("iout(13)=1,tiout(13)=.1\n$\n$regrig nregrig=0 /\n$reg nreg=1,nvi=3,xvi(1,1)=0.,1.,1.,"
                   "yvi(1,1)=0.,0.,2.,rex=1.,rey=1.,densir=1. /\nnotes\n"));
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(), Texts{});
}

TEST(Warnings, AssignedTwice) {
  const auto reading = read_in("wl=4\ncyl=1. wl=1\niout(13)=1 iout(12:14)=0,0,1");
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(), (Texts{"4:11: wl is set twice, first at 3:4; the later value holds",
                                       "5:26: iout(13) is set twice, first at 5:10; the later value holds"}));
  EXPECT_EQ(reading.deck.integer("in.wl"), 1);
  EXPECT_EQ(reading.deck.integer("in.iout", 13), 0);
}

TEST(Warnings, AssignedTwiceIsToldOnceAnItem) {
  EXPECT_EQ(read_in("iout=60*0 iout=60*1").warnings(),
            (Texts{"3:19: iout(1) is set twice, first at 3:9; the later value holds"}));
}

TEST(Warnings, AGroupTwice) {
  const auto reading = read(with_in("$\n$reg nreg=2 /\n$reg nprg(2)=9 /\n"));
  EXPECT_EQ(reading.warnings(), (Texts{"5:1: $reg is there twice, first at line 4; the later values hold"}));
  EXPECT_EQ(reading.deck.integer("reg.nreg"), 2);
  EXPECT_EQ(reading.deck.integer("reg.nprg", 2), 9);
}

TEST(Warnings, AnUnknownGroupClosesAnOpenOne) {
  const auto reading = read(with_in("$rge nreg=2 /\n"));
  EXPECT_EQ(reading.errors(), (Texts{"3:1: there is no group '$rge'"}));
  EXPECT_EQ(reading.warnings(), (Texts{"3:1: $rge opens while $in is still open; $in ends here"}));
}

TEST(Warnings, TextBetweenGroups) {
  EXPECT_EQ(read(with_in("/\n\n! note\nwl=4\nwr=4\n$reg /\n")).warnings(),
            (Texts{"6:1: text between two groups is ignored"}));
  EXPECT_EQ(read(with_in("/\n\n! note\n$reg /\n")).warnings(), Texts{});
}

TEST(Warnings, OpenersInsideLines) {
  const auto reading = read("of $in\n" + with_in("/ x &reg nreg=1 /\nsee $fluid,mu=2.\n"));
  EXPECT_EQ(reading.errors(), Texts{});
  EXPECT_EQ(reading.warnings(),
            (Texts{"1:4: '$in' inside a line opens no group", "4:5: '$reg' inside a line opens no group",
                   "5:5: '$fluid' inside a line opens no group"}));
  EXPECT_FALSE(reading.deck.has_group("reg"));
  EXPECT_EQ(read("! $in\n5 $ in, $inner $end $nothing\n" + with_in("/ ! $reg\n")).warnings(), Texts{});
}

TEST(Warnings, ASlashInsideAValue) {
  for (const char* items : {"gravc=1/2", "wl=4 // left", "wl=4/,"}) {
    const auto reading = read(with_in(std::string(items) + "\n"));
    EXPECT_EQ(reading.errors(), Texts{}) << items;
    ASSERT_EQ(reading.warnings().size(), 1U) << items;
    EXPECT_NE(reading.warnings()[0].find("'/' ends the group; what stands after it is not read"), std::string::npos);
  }
  EXPECT_EQ(read(with_in("wl=4/ note\n")).warnings(), Texts{});
  EXPECT_EQ(read(with_in("wl=4/!note\n")).warnings(), Texts{});
}

TEST(Warnings, RegionsBeyondNreg) {
  EXPECT_EQ(read_reg("nvi=4 xvi(1,1)=1. densir=1.,2.,3. nprg(3)=4 nreg=2").warnings(),
            (Texts{"5:32: densir(3) is set but nreg = 2", "5:43: nprg(3) is set but nreg = 2"}));
  EXPECT_EQ(read_reg("xvi(2,1)=0.1").warnings(), (Texts{"5:10: xvi(2,1) is set but nreg = 0"}));
}

TEST(Warnings, OuterEllipsesWithoutTheirInner) {
  EXPECT_EQ(read_reg("nreg=3 rix(1)=0. rex(2)=1. rex(3)=1.").warnings(),
            (Texts{"5:25: rex(2) is set but rix(2) never is", "5:35: rex(3) is set but rix(3) never is"}));
  EXPECT_EQ(read_reg("nreg=3 rex(1)=1. rey(1)=1.").warnings(), Texts{});
}

TEST(Warnings, VerticesOutsideTheGridOncePerRegion) {
  const auto reading = read_reg(
      "nreg=2 nvi=3,3 xvi(1,1)=0.,1.,1.5 yvi(1,1)=0.,2.,-1.\n"
      "xvi(1,2)=0.,1.,1. yvi(1,2)=0.,2.01,3.");
  EXPECT_EQ(reading.warnings(), (Texts{"5:31: vertex 3 of region 1 is outside the grid",
                                       "6:31: vertex 2 of region 2 is outside the grid"}));
}

TEST(Warnings, VerticesBeyondNviDoNotCount) {
  EXPECT_EQ(read_reg("nreg=1 nvi=2 xvi(1,1)=0.,1.,9. yvi(1,1)=0.,1.,1.").warnings(), Texts{});
}

TEST(Warnings, IntervalsOfOutputsThatAreOff) {
  EXPECT_EQ(read_in("iout(13)=1 tiout(13)=1. tiout(30)=2. iout(31)=0 tiout(31)=.1").warnings(),
            (Texts{"3:35: tiout is set for outputs that are off (iout = 0): 30, 31"}));
}

TEST(Warnings, DoNotKeepADeckFromBeingRead) {
  EXPECT_NO_THROW(read_in("wl=4;wl=4.0").diagnostics.throw_if_errors());
  EXPECT_THROW(read_in("wl=7").diagnostics.throw_if_errors(), InputError);
}

}  // namespace
}  // namespace tether::test
