// SPDX-License-Identifier: GPL-3.0-or-later
// What a deck may say, feature by feature. Expected values are those of gfortran 12's namelist reader.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

Reading good(Reading reading) {
  EXPECT_EQ(reading.errors(), Texts{});
  return reading;
}

std::vector<int> iout(const Deck& deck, int first, int last) {
  std::vector<int> values;
  for (int i = first; i <= last; ++i) values.push_back(deck.given("in.iout", i) ? deck.integer("in.iout", i) : -1);
  return values;
}

std::vector<int> ipath(const Deck& deck, int region) {
  std::vector<int> values;
  for (int i = 1; i <= 4; ++i)
    values.push_back(deck.given("reg.ipath", i, region) ? deck.integer("reg.ipath", i, region) : -1);
  return values;
}

using Integers = std::vector<int>;

TEST(Grammar, HeaderLinesAreKeptVerbatim) {
  const auto reading = good(read("'\"ary\"'\n\"sods problem\" ' \n$ 5 nx=3\n" + with_in("$\n")));
  EXPECT_EQ(reading.deck.header(), (Texts{"'\"ary\"'", "\"sods problem\" ' ", "$ 5 nx=3"}));
}

TEST(Grammar, NamesAreOfAnyCase) {
  const auto reading = good(read("$IN Nx=11,NY=21,xLEFT=0.,xright=1.,ybot=0.,ytop=2.,tmax=1.,tstep=.1 $END\n"));
  EXPECT_EQ(reading.deck.integer("in.nx"), 11);
  EXPECT_EQ(reading.deck.place("in.ny").column, 14);
}

TEST(Grammar, AGroupClosesInManyWays) {
  for (const char* end : {"/", "$", "&", " $ ", "\t&\t! done", "$end", "&END rest", "/ rest = 1", "cyl=1 $",
                          "cyl=1 $End", "cyl=1/", "cyl=1$end", "cyl=1&", "cyl=$"}) {
    const auto reading = good(read(with_in(std::string(end) + "\n$reg nreg=1 /\n")));
    EXPECT_EQ(reading.deck.integer("reg.nreg"), 1) << end;
    EXPECT_EQ(reading.warnings(), Texts{}) << end;
  }
}

TEST(Grammar, AGroupOpensWithDollarOrAmpersandBehindBlanks) {
  const auto reading = good(read(with_in("/\n \t&fluid mu=2. /\n  $reg,nreg=3/\n")));
  EXPECT_EQ(reading.deck.real("fluid.mu"), 2.0);
  EXPECT_EQ(reading.deck.integer("reg.nreg"), 3);
  EXPECT_TRUE(reading.deck.has_group("fluid"));
  EXPECT_FALSE(reading.deck.has_group("mpm"));
}

TEST(Grammar, GroupsComeInAnyOrder) {
  const auto reading = good(read("$reg nreg=2 /\n" + with_in("$\n")));
  EXPECT_EQ(reading.deck.integer("reg.nreg"), 2);
  EXPECT_EQ(reading.deck.place("reg.nreg").line, 1);
}

TEST(Grammar, BlanksAndNewLinesAroundTheEqualSign) {
  const auto reading = good(read_in("gravc\n =\n\t-9.81 cyl =\n1"));
  EXPECT_EQ(reading.deck.real("in.gravc"), -9.81);
  EXPECT_EQ(reading.deck.place("in.gravc").line, 5);
  EXPECT_EQ(reading.deck.place("in.gravc").column, 2);
  EXPECT_EQ(reading.deck.real("in.cyl"), 1.0);
}

TEST(Grammar, BlanksInSubscripts) {
  const auto reading = good(read_in("iout (\n 13 )=1 iout( +14)=1, iout(15:\n16)=1 1"));
  EXPECT_EQ(iout(reading.deck, 13, 16), (Integers{1, 1, 1, 1}));
}

TEST(Grammar, AnUnsubscriptedArrayFillsFromItsFirstElement) {
  const auto reading = good(read_reg("nreg=2, xcenter=0.25e0, nprg=9 4"));
  EXPECT_EQ(reading.deck.given_elements("reg.xcenter"), (std::vector<Subscript>{{1, 1}}));
  EXPECT_EQ(reading.deck.integer("reg.nprg", 2), 4);
}

TEST(Grammar, ASubscriptFillsOnwardInColumnMajorOrder) {
  const auto reading = good(read_reg("nreg=2, ipath(1,1)=4*3,7,,8"));
  EXPECT_EQ(ipath(reading.deck, 1), (Integers{3, 3, 3, 3}));
  EXPECT_EQ(ipath(reading.deck, 2), (Integers{7, -1, 8, -1}));
  EXPECT_EQ(reading.warnings(), Texts{});
}

TEST(Grammar, RunningOnFromInsideAColumnIsTold) {
  const auto reading = good(read_reg("nreg=2, ipath(3,1)=1,2,3,4"));
  EXPECT_EQ(ipath(reading.deck, 1), (Integers{-1, -1, 1, 2}));
  EXPECT_EQ(ipath(reading.deck, 2), (Integers{3, 4, -1, -1}));
  EXPECT_EQ(reading.warnings(), (Texts{"5:9: the values from ipath(3,1) on fill its column and go on at ipath(1,2)"}));
}

TEST(Grammar, GivenElementsComeInColumnMajorOrder) {
  const auto reading = good(read_reg("nreg=2, xvi(1,2)=5.,6. xvi(1,1)=1.,2."));
  EXPECT_EQ(reading.deck.given_elements("reg.xvi"), (std::vector<Subscript>{{1, 1}, {2, 1}, {1, 2}, {2, 2}}));
}

TEST(Grammar, Sections) {
  EXPECT_EQ(iout(good(read_in("iout(1:5:2)=1,0,1")).deck, 1, 6), (Integers{1, -1, 0, -1, 1, -1}));
  EXPECT_EQ(iout(good(read_in("iout(4:2:-1)=1,0,0")).deck, 1, 5), (Integers{-1, 0, 0, 1, -1}));
  EXPECT_EQ(iout(good(read_in("iout(58:)=1,0,1")).deck, 57, 60), (Integers{-1, 1, 0, 1}));
  EXPECT_EQ(iout(good(read_in("iout(:3)=1,0,1")).deck, 1, 4), (Integers{1, 0, 1, -1}));
  EXPECT_EQ(iout(good(read_in("iout(::20)=1,0,1")).deck, 41, 41), (Integers{1}));
  EXPECT_EQ(iout(good(read_in("iout(:)=1,0")).deck, 1, 3), (Integers{1, 0, -1}));
  EXPECT_EQ(iout(good(read_in("iout(7:7)=1")).deck, 7, 8), (Integers{1, -1}));
}

TEST(Grammar, SectionsOfTwoDirections) {
  const auto rows = good(read_reg("nreg=3, ipath(4,:)=7,8,9")).deck;
  EXPECT_EQ(ipath(rows, 1), (Integers{-1, -1, -1, 7}));
  EXPECT_EQ(ipath(rows, 3), (Integers{-1, -1, -1, 9}));
  const auto column = good(read_reg("nreg=3, ipath(:,2)=1,2,3,4")).deck;
  EXPECT_EQ(ipath(column, 2), (Integers{1, 2, 3, 4}));
  EXPECT_EQ(ipath(column, 3), (Integers{-1, -1, -1, -1}));
  const auto block = good(read_reg("nreg=3, ipath(3:2:-1,1:3:2)=1,2,3,4")).deck;
  EXPECT_EQ(ipath(block, 1), (Integers{-1, 2, 1, -1}));
  EXPECT_EQ(ipath(block, 3), (Integers{-1, 4, 3, -1}));
}

TEST(Grammar, RepeatCountsAndNulls) {
  EXPECT_EQ(iout(good(read_in("iout=2*1,2*0,3*,1")).deck, 1, 9), (Integers{1, 1, 0, 0, -1, -1, -1, 1, -1}));
  EXPECT_EQ(iout(good(read_in("iout=,,1")).deck, 1, 3), (Integers{-1, -1, 1}));
  EXPECT_EQ(iout(good(read_in("iout=1 , , 0")).deck, 1, 3), (Integers{1, -1, 0}));
  EXPECT_EQ(iout(good(read_in("iout=2* 1")).deck, 1, 3), (Integers{-1, -1, 1}));
  EXPECT_EQ(iout(good(read_in("iout=60*1")).deck, 1, 60), Integers(60, 1));
  EXPECT_EQ(good(read_in("iout=60*")).deck.given_elements("in.iout").size(), 0U);
  EXPECT_EQ(good(read_in("cyl=1*1 gravc=1*")).deck.real("in.cyl"), 1.0);
}

TEST(Grammar, NullValuesKeepTheDefault) {
  const auto reading = good(read_in("wl=,wr= wt=,,,wb=0,,"));
  EXPECT_FALSE(reading.deck.given("in.wl"));
  EXPECT_FALSE(reading.deck.given("in.wr"));
  EXPECT_FALSE(reading.deck.given("in.wt"));
  EXPECT_EQ(reading.deck.integer("in.wl"), 6);
  EXPECT_EQ(reading.deck.integer("in.wb"), 0);
}

TEST(Grammar, NullsMayRunPastAnArraysEnd) {
  EXPECT_EQ(iout(good(read_in("iout(60)=1,,,")).deck, 60, 60), (Integers{1}));
}

TEST(Grammar, ANewLineSeparatesLikeABlank) {
  const auto reading = good(read_in("wt=1\niout(13)=1\n0\n,1,\n\n,0"));
  EXPECT_EQ(iout(reading.deck, 13, 17), (Integers{1, 0, 1, -1, 0}));
}

TEST(Grammar, SemicolonsAreCommasWithAWarning) {
  const auto reading = good(read_in("wl=1;wr=4"));
  EXPECT_EQ(reading.deck.integer("in.wr"), 4);
  EXPECT_EQ(reading.warnings(), (Texts{"3:5: ';' is taken for a comma"}));
}

TEST(Grammar, Comments) {
  const auto reading = good(read_in("wl=1!wr=4\n! $in, it's\nwt=4 ! /"));
  EXPECT_EQ(reading.deck.integer("in.wl"), 1);
  EXPECT_EQ(reading.deck.integer("in.wt"), 4);
  EXPECT_FALSE(reading.deck.given("in.wr"));
}

TEST(Grammar, Reals) {
  const auto reading = good(read_in("tiout=1.d-4,1.5+3,.5,2.,3,+4.e0,1.q2"));
  const std::vector<double> expected{1e-4, 1500, 0.5, 2, 3, 4, 100};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(reading.deck.real("in.tiout", static_cast<int>(k) + 1), expected[k]);
  }
}

TEST(Grammar, ATrailingDotIsDroppedWithAWarning) {
  const auto reading = good(read_in("iout(32)=1,tiout(32)=2.00.,"));
  EXPECT_EQ(reading.deck.real("in.tiout", 32), 2.0);
  EXPECT_EQ(reading.warnings(), (Texts{"3:22: the last '.' of '2.00.' is dropped: tiout(32) = 2.00"}));
}

TEST(Grammar, WholeRealsForIntegersWithAWarning) {
  const auto reading = good(read_in("wl=4.0 miter=3e1 wr=1."));
  EXPECT_EQ(reading.deck.integer("in.wl"), 4);
  EXPECT_EQ(reading.deck.integer("in.miter"), 30);
  EXPECT_EQ(reading.warnings().size(), 3U);
  EXPECT_EQ(reading.warnings().front(), "3:4: wl is an integer; '4.0' is taken for 4");
}

TEST(Grammar, IntegersOfFullSize) {
  EXPECT_EQ(good(read_in("miter=-2147483648")).deck.integer("in.miter"), -2147483647 - 1);
  EXPECT_EQ(good(read_in("miter=+2147483647")).deck.integer("in.miter"), 2147483647);
}

TEST(Grammar, Logicals) {
  for (const char* text : {"t", "T", ".t.", ".TRUE.", "true", ".true", "tea"}) {
    EXPECT_TRUE(good(read_in(std::string("large=") + text)).deck.logical("in.large")) << text;
  }
  for (const char* text : {"f", ".F.", ".false.", "FALSE"}) {
    EXPECT_FALSE(good(read_in(std::string("large=") + text)).deck.logical("in.large")) << text;
  }
}

TEST(Grammar, TextsInEitherQuote) {
  EXPECT_EQ(good(read_in("particles='a/b!$&\"c'")).deck.text("in.particles"), "a/b!$&\"c");
  EXPECT_EQ(good(read_in("particles=\"it's\"")).deck.text("in.particles"), "it's");
  EXPECT_EQ(good(read_in("particles='it''s'")).deck.text("in.particles"), "it's");
  EXPECT_EQ(good(read_in("particles=1*'x'")).deck.text("in.particles"), "x");
  EXPECT_EQ(good(read_in("particles=''")).deck.text("in.particles"), "");
  EXPECT_EQ(good(read_in("particles='gr\xc3\xbc\xc3\x9f'")).deck.text("in.particles"), "gr\xc3\xbc\xc3\x9f");
}

TEST(Grammar, ATextGoesOnOverLinesEvenOverSuchAsOpenGroups) {
  const auto reading = good(read_in("particles='a\n$reg\nb' wl=4"));
  EXPECT_EQ(reading.deck.text("in.particles"), "a$regb");
  EXPECT_EQ(reading.deck.integer("in.wl"), 4);
  EXPECT_FALSE(reading.deck.has_group("reg"));
}

TEST(Grammar, ChoicesAreOfAnyCaseAndComeInLowerCase) {
  EXPECT_EQ(good(read(with_in("$\n$mpm order='USL' /\n"))).deck.text("mpm.order"), "usl");
}

TEST(Grammar, LineEndsAndByteOrderMark) {
  std::string text = with_in("iout(13)=1\n$\n$reg nreg=2\n$");
  for (const char* end : {"\r\n", "\r"}) {
    std::string other = "\xef\xbb\xbf";
    for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
    const auto reading = good(read(other));
    EXPECT_EQ(reading.deck.integer("reg.nreg"), 2);
    EXPECT_EQ(reading.deck.place("in.iout", 13).line, 3);
    EXPECT_EQ(reading.deck.text(), other);
  }
}

TEST(Grammar, TheTextBehindTheLastGroupIsKept) {
  const auto reading = good(read(with_in("$ ! rest\n$reg\n/\n0.5 !density\nnx = 'it\n")));
  EXPECT_EQ(reading.deck.trailer().first_line, 6);
  EXPECT_EQ(reading.deck.trailer().text, "0.5 !density\nnx = 'it\n");
  EXPECT_EQ(good(read(with_in("$"))).deck.trailer().text, "");
}

}  // namespace
}  // namespace tether::test
