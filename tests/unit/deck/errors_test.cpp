// SPDX-License-Identifier: GPL-3.0-or-later
// Every mistake in a deck: its place and its message.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

struct Mistake {
  const char* items;  ///< in $in from line 3 on
  Texts errors;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.items; }

class InMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(InMistakes, AreToldWithTheirPlace) { EXPECT_EQ(read_in(GetParam().items).errors(), GetParam().errors); }

INSTANTIATE_TEST_SUITE_P(
    Names, InMistakes,
    testing::Values(Mistake{"wt=4 tmx=0.5", {"3:6: $in has no variable 'tmx'"}},
                    Mistake{"gm1=0.4", {"3:1: $in has no variable 'gm1'"}},
                    Mistake{"5=3", {"3:1: $in has no variable '5'"}},
                    Mistake{"methd=0 foo bar", {"3:9: methd takes one value, this is one too many"}},
                    Mistake{"wl 4", {"3:1: '=' is missing after 'wl'"}},
                    Mistake{"wl=4 wr 5", {"3:6: '=' is missing after 'wr'"}},
                    Mistake{"iout(13) 1\nwt=7", {"3:1: '=' is missing after 'iout'", "4:4: wt = 7 is out of range"}},
                    Mistake{"wl==4", {"3:4: '=' among the values of 'wl'"}},
                    Mistake{"wl=4)", {"3:5: ')' among the values of 'wl'"}},
                    Mistake{"wl=4 :", {"3:6: ':' among the values of 'wl'"}},
                    Mistake{"wl=1(2)", {"3:5: '(' among the values of 'wl'"}}));

INSTANTIATE_TEST_SUITE_P(
    Values, InMistakes,
    testing::Values(
        Mistake{"wl=abc", {"3:4: wl must be an integer, not 'abc'"}},
        Mistake{"wl=3.5", {"3:4: wl must be an integer, not '3.5'"}},
        Mistake{"wl=- 5", {"3:4: wl must be an integer, not '-'", "3:6: wl takes one value, this is one too many"}},
        Mistake{"wl='4'", {"3:4: wl must be an integer, not '4'"}},
        Mistake{"wl=5$in", {"3:5: '$' inside a line of a group"}},
        Mistake{"miter=2147483648", {"3:7: miter overflows: '2147483648'"}},
        Mistake{"miter=-99999999999999999999", {"3:7: miter overflows: '-99999999999999999999'"}},
        Mistake{"miter=1e10", {"3:7: miter must be an integer, not '1e10'"}},
        Mistake{"miter=1e400", {"3:7: miter must be an integer, not '1e400'"}},
        Mistake{"gravc=1e400", {"3:7: gravc must be a finite number, not '1e400'"}},
        Mistake{"gravc=-inf", {"3:7: gravc must be a finite number, not '-inf'"}},
        Mistake{"tiout=1,2*nan", {"3:11: tiout(2) must be a finite number, not 'nan'"}},
        Mistake{"gravc=1.0e 5",
                {"3:7: gravc must be a number, not '1.0e'", "3:12: gravc takes one value, this is one too many"}},
        Mistake{"gravc=1e5.", {"3:7: gravc must be a number, not '1e5.'"}},
        Mistake{"gravc=1.x.", {"3:7: gravc must be a number, not '1.x.'"}},
        Mistake{"gravc=wl", {"3:7: '=' is missing after 'wl'"}},
        Mistake{"large=1", {"3:7: large must be .true. or .false., not '1'"}},
        Mistake{"large=yes", {"3:7: large must be .true. or .false., not 'yes'"}},
        Mistake{"large=.", {"3:7: large must be .true. or .false., not '.'"}},
        Mistake{"large=t1", {"3:7: large must be .true. or .false., not 't1'"}},
        Mistake{"units=si", {"3:7: units must be a text in quotes, not 'si'"}},
        Mistake{"units='sy'", {"3:7: units = 'sy' is none of its choices"}},
        Mistake{"units=''", {"3:7: units = '' is none of its choices"}}));

INSTANTIATE_TEST_SUITE_P(Ranges, InMistakes,
                         testing::Values(Mistake{"nx=1", {"3:4: nx = 1 is out of range"}},
                                         Mistake{"igen=2", {"3:6: igen = 2 is out of range"}},
                                         Mistake{"tmax=-1", {"3:6: tmax = -1 is out of range"}},
                                         Mistake{"tmax=0", {"3:6: tmax = 0 is out of range"}},
                                         Mistake{"cyl=0.5", {"3:5: cyl = 0.5 is out of range"}},
                                         Mistake{"cntr=1.5", {"3:6: cntr = 1.5 is out of range"}},
                                         Mistake{"wl=2.0", {"3:4: wl = 2 is out of range"}},
                                         Mistake{"iout(13)=2,tiout(13)=0.",
                                                 {"3:10: iout(13) = 2 is out of range",
                                                  "3:22: tiout(13) = 0 is out of range"}}));

INSTANTIATE_TEST_SUITE_P(
    Counts, InMistakes,
    testing::Values(
        Mistake{"wl=0*4", {"3:4: '0*4' is no repeated value"}},
        Mistake{"wl=2*4", {"3:4: wl takes one value, this is one too many"}},
        Mistake{"wl=2*", {"3:4: wl takes one value, this is one too many"}},
        Mistake{"iout=2*3*1", {"3:6: '2*3*1' is no repeated value"}},
        Mistake{"iout=*1", {"3:6: '*1' is no repeated value"}},
        Mistake{"iout=-2*1", {"3:6: '-2*1' is no repeated value"}},
        Mistake{"iout=3 *1", {"3:6: iout(1) = 3 is out of range", "3:8: '*1' is no repeated value"}},
        Mistake{"iout=61*1", {"3:6: the values run past the end of iout: there are 60 elements from iout(1) on"}},
        Mistake{"iout=0,1000000000*0",
                {"3:8: the values run past the end of iout: there are 60 elements from iout(1) on"}},
        Mistake{"iout=99999999999999999999*",
                {"3:6: the values run past the end of iout: there are 60 elements from iout(1) on"}},
        Mistake{"iout(59)=1,1,1,wl",
                {"3:14: the values run past the end of iout: there are 2 elements from iout(59) on"}},
        Mistake{"iout(60)=1,,1", {"3:13: the values run past the end of iout: there are 1 elements from iout(60) on"}},
        Mistake{"iout(1:5:2)=1,1,1,1",
                {"3:19: the values run past the end of iout: there are 3 elements from iout(1) on"}}));

INSTANTIATE_TEST_SUITE_P(Subscripts, InMistakes,
                         testing::Values(Mistake{"iout(61)=1", {"3:6: subscript 61 of iout is out of range"}},
                                         Mistake{"iout( 0)=1", {"3:7: subscript 0 of iout is out of range"}},
                                         Mistake{"iout(-1)=1", {"3:6: subscript -1 of iout is out of range"}},
                                         Mistake{"iout(99999999999999999999)=1",
                                                 {"3:6: subscript 9223372036854775807 of iout is out of range"}},
                                         Mistake{"iout(1:61)=1", {"3:8: subscript 61 of iout is out of range"}},
                                         Mistake{"iout(5:2)=1", {"3:6: the section 5:2:1 of iout has no elements"}},
                                         Mistake{"iout(1:5:0)=1", {"3:6: the section 1:5:0 of iout has no elements"}},
                                         Mistake{"iout(1:5:-9223372036854775807)=1",
                                                 {"3:6: the section 1:5:-9223372036854775807 of iout has no elements"}},
                                         Mistake{"iout(1,2)=1", {"3:6: iout takes 1 subscript, not 2"}},
                                         Mistake{"wl(1)=4", {"3:4: wl is no array and takes no subscript"}},
                                         Mistake{"iout()=1", {"3:6: ')' in the subscript of 'iout'"}},
                                         Mistake{"iout(1,)=1", {"3:8: ')' in the subscript of 'iout'"}},
                                         Mistake{"iout(1.5)=1", {"3:6: '1.5' in the subscript of 'iout'"}},
                                         Mistake{"iout(1:2:)=1", {"3:10: ')' in the subscript of 'iout'"}},
                                         Mistake{"iout(1:x)=1", {"3:8: 'x' in the subscript of 'iout'"}},
                                         Mistake{"iout(1:2:3:4)=1", {"3:11: ':' in the subscript of 'iout'"}},
                                         Mistake{"iout(1 2)=1", {"3:8: '2' in the subscript of 'iout'"}},
                                         Mistake{"iout(1=1", {"3:7: '=' in the subscript of 'iout'"}},
                                         Mistake{"iout('1')=1", {"3:6: a text in quotes in the subscript of 'iout'"}},
                                         Mistake{"iout(1", {"4:1: the group's end in the subscript of 'iout'"}},
                                         Mistake{"iout(1)(2)=1", {"3:1: '=' is missing after 'iout'"}}));

INSTANTIATE_TEST_SUITE_P(
    Characters, InMistakes,
    testing::Values(Mistake{"wl=\xc2\xa0"
                            "4",
                            {"3:4: the bytes 0xC2 0xA0 are not plain text (a no-break space)"}},
                    Mistake{"wl\xe2\x80\x93=4", {"3:3: the bytes 0xE2 0x80 0x93 are not plain text"}},
                    Mistake{"wl=4 \x01", {"3:6: the bytes 0x01 are not plain text"}},
                    Mistake{"particles='a\x02 b'", {"3:13: the bytes 0x02 are not plain text"}},
                    Mistake{"particles='a\nwl=4", {"3:11: this quote is never closed"}},
                    Mistake{"particles='a\nunits=\"b\nwl=7",
                            {"3:11: this quote is never closed", "4:7: this quote is never closed",
                             "4:7: units = 'b' is none of its choices", "5:4: wl = 7 is out of range"}},
                    Mistake{"wl=4 $fluid mu=2.",
                            {"3:6: '$' inside a line of a group", "3:13: $in has no variable 'mu'"}},
                    Mistake{"wl=4 # left", {"3:6: '#' among the values of 'wl'"}},
                    Mistake{"# left wall\nwl=7", {"3:1: '#' begins no comment", "4:4: wl = 7 is out of range"}},
                    Mistake{"#wl=7\nwr=7", {"3:1: '#' begins no comment", "4:4: wr = 7 is out of range"}}));

std::string first_hint(const Reading& reading) {
  const auto errors = reading.diagnostics.errors();
  return errors.empty() ? "" : errors.front().hint;
}

TEST(Errors, SayWhatWouldBeRight) {
  EXPECT_EQ(first_hint(read_in("tmx=0.5")), "Did you mean 'tmax' (group $in)?");
  EXPECT_EQ(first_hint(read_in("gm1=0.4")), "'gm1' belongs to group $fluid.");
  EXPECT_EQ(first_hint(read_in("densr=0.4")), "Did you mean 'densir' (group $reg)?");
  EXPECT_EQ(first_hint(read_in("nothinglike=0.4")), "");
  EXPECT_EQ(first_hint(read_in("wl=4 wr 5")), "An item is: name = value.");
  EXPECT_EQ(first_hint(read_in("gravc=wl")), "An item is: name = value.");
  EXPECT_EQ(first_hint(read_in("units=si")), "Write 'si'.");
  EXPECT_EQ(first_hint(read_in("units='sy'")), "Allowed: none, si or cgs. Did you mean 'si'?");
  EXPECT_EQ(first_hint(read_in("units='metric'")), "Allowed: none, si or cgs.");
  EXPECT_EQ(first_hint(read_in("nx=1")), "Allowed: 2 to 1000000000.");
  EXPECT_EQ(first_hint(read_in("tmax=-1")), "Allowed: > 0.");
  EXPECT_EQ(first_hint(read_in("wl=2")), "Allowed: 0, 1, 4, 5 or 6.");
  EXPECT_EQ(first_hint(read_in("iout(61)=1")), "Subscript 1 of iout goes from 1 to 60.");
  EXPECT_EQ(first_hint(read_in("iout=61*1")), "Its shape is iout(60).");
  EXPECT_EQ(first_hint(read_in("# wall")), "A comment begins with '!'.");
  EXPECT_EQ(first_hint(read_reg("c wall")), "A comment begins with '!'.");
  EXPECT_EQ(first_hint(read_in("wl=4 # wall")), "A comment begins with '!'.");
  EXPECT_EQ(first_hint(read_in("wl=\xc2\xa0"
                               "4")),
            "Write a plain blank.");
}

TEST(Errors, StrayThingsAtTheStartOfAGroup) {
  EXPECT_EQ(read_reg("nreg 4").errors(), (Texts{"5:1: 'nreg' is neither a variable with its '=' nor a value"}));
  EXPECT_EQ(read_reg("= 4").errors(), (Texts{"5:1: '=' is neither a variable with its '=' nor a value"}));
  EXPECT_EQ(read_reg("'nreg'=4 nreg=-1").errors(),
            (Texts{"5:1: a text in quotes is neither a variable with its '=' nor a value",
                   "5:15: nreg = -1 is out of range"}));
  EXPECT_EQ(read_reg("# nreg=4\nnreg=-1").errors(),
            (Texts{"5:1: '#' begins no comment", "6:6: nreg = -1 is out of range"}));
}

TEST(Errors, CarryTheLine) {
  const auto errors = read_in("  wl=7 ! left").diagnostics.errors();
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].line_text, "  wl=7 ! left");
  EXPECT_EQ(to_text(errors[0]),
            "a.in:3:6: error: wl = 7 is out of range\n    wl=7 ! left\n       ^\n"
            "  Allowed: 0, 1, 4, 5 or 6.\n");
}

TEST(Errors, OfRegionArraysNameTheRank) {
  EXPECT_EQ(read_reg("nreg=1 xvi(1)=0.").errors(), (Texts{"5:12: xvi takes 2 subscripts, not 1"}));
  EXPECT_EQ(read_reg("nreg=1 ipath(1,21)=0").errors(), (Texts{"5:16: subscript 21 of ipath is out of range"}));
  EXPECT_EQ(read_reg("nreg=1 densir=-1.").errors(), (Texts{"5:15: densir(1) = -1 is out of range"}));
  EXPECT_EQ(read_reg("nreg=21").errors(), (Texts{"5:6: nreg = 21 is out of range"}));
}

TEST(Errors, AllAreToldAtOnce) {
  EXPECT_EQ(read(with_in("wl=abc, foo=1\ngravc=1e400 iout(0)=1\n$\n$fluid mu=-1. /\n$regg /\n")).errors(),
            (Texts{"3:4: wl must be an integer, not 'abc'", "3:9: $in has no variable 'foo'",
                   "4:7: gravc must be a finite number, not '1e400'", "4:18: subscript 0 of iout is out of range",
                   "6:11: mu = -1 is out of range", "7:1: there is no group '$regg'"}));
}

TEST(Errors, UnknownGroups) {
  const auto reading = read(with_in("$\n$flui\nmu=x # any (thing\n$\n$geometry\n"));
  EXPECT_EQ(reading.errors(), (Texts{"4:1: there is no group '$flui'", "7:1: there is no group '$geometry'"}));
  const auto errors = reading.diagnostics.errors();
  EXPECT_EQ(errors[0].hint, "Did you mean '$fluid'?");
  EXPECT_EQ(errors[1].hint,
            "The groups are $in, $fluid, $regrig, $reg, $membrane, $points, $mpm, $reference, $limits, $mesh, $fem, "
            "$contact, $rigid, $flow, $coupled, $study, $published, $auto.");
}

TEST(Errors, ABlankBeforeTheGroupsName) {
  const auto reading = read(with_in("$\n& fluid mu=2. /\n"));
  EXPECT_EQ(reading.errors(), (Texts{"4:1: blanks before the group's name 'fluid'"}));
  EXPECT_EQ(reading.deck.real("fluid.mu"), 2.0);
}

TEST(Errors, AnOpenGroupAtTheEnd) {
  EXPECT_EQ(read(with_in("$\n  $reg nreg=1\n")).errors(), (Texts{"4:3: the group $reg is never closed"}));
}

TEST(Errors, NoIn) {
  EXPECT_EQ(read("").errors(), (Texts{"0:0: the file is empty"}));
  EXPECT_EQ(read(" \n").errors(), (Texts{"0:0: the file holds nothing but blanks"}));
  EXPECT_EQ(read("nx = 5\n$reg nreg=1 /\n").errors(), (Texts{"0:0: there is no group $in"}));
}

TEST(Errors, RequiredVariables) {
  EXPECT_EQ(read("\n $in nx=3 xleft=0. xright=1. ybot=, /\n").errors(),
            (Texts{"2:30: ybot has no default: it needs a value",
                   "2:2: $in lacks ny, ytop, tmax, tstep, which have no default"}));
  EXPECT_EQ(read("$in nx=3 ny=3 xleft=0. xright=1. ybot=0. ytop=1. tstep=.1 /\n").errors(),
            (Texts{"1:1: $in lacks tmax, which has no default"}));
}

TEST(Errors, AVariableThatWasGivenWronglyIsNotMissing) {
  EXPECT_EQ(read("$in nx=a ny(1)=3 xleft 0. xright=1. ybot=0. ytop=1. tmax==1. tstep=.1 /\n").errors(),
            (Texts{"1:8: nx must be an integer, not 'a'", "1:13: ny is no array and takes no subscript",
                   "1:58: '=' among the values of 'tmax'", "1:1: $in lacks xleft, which has no default"}));
}

TEST(Errors, EndAtAHundred) {
  std::string items;
  for (int k = 0; k < 1000; ++k) items += "wl=7;\n";
  const auto reading = read_in(items);
  ASSERT_EQ(reading.errors().size(), 101U);
  EXPECT_EQ(reading.errors().back(), "0:0: more than 100 errors, no more are shown");
  EXPECT_EQ(reading.warnings().back(), "0:0: more than 100 warnings, no more are shown");
}

TEST(Errors, LongLinesAndNamesAreCutShort) {
  const auto errors = read_in(std::string(5000, 'x') + "=1").diagnostics.errors();
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].line_text, "");
  EXPECT_EQ(errors[0].message, "$in has no variable '" + std::string(29, 'x') + "..." + std::string(28, 'x') + "'");
}

TEST(Errors, MoreValuesThanAnyDeckNeeds) {
  std::string items = "$\n$points ";
  for (int k = 0; k < 6; ++k) items += "tracked=100000*t ";
  EXPECT_EQ(read(with_in(items + "$\n")).errors(),
            (Texts{"4:92: the deck sets more than 500000 values", "4:109: the deck sets more than 500000 values"}));
}

}  // namespace
}  // namespace tether::test
