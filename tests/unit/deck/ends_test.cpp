// SPDX-License-Identifier: GPL-3.0-or-later
// Decks that end too soon: what is told stands within the text.
#include <gtest/gtest.h>

#include "deck_support.hpp"

namespace tether::test {
namespace {

struct CutOff {
  std::string text;
  Texts errors;
};

void PrintTo(const CutOff& cut, std::ostream* out) { *out << cut.text; }

class CutOffDecks : public testing::TestWithParam<CutOff> {};

TEST_P(CutOffDecks, AreToldBehindTheirLastLine) { EXPECT_EQ(read(GetParam().text).errors(), GetParam().errors); }

constexpr const char* open = "1:1: the group $in is never closed";

INSTANTIATE_TEST_SUITE_P(
    Deck, CutOffDecks,
    testing::Values(CutOff{with_in("iout(13"), {open, "3:8: the group's end in the subscript of 'iout'"}},
                    CutOff{with_in("iout(13\n\n"), {open, "4:1: the group's end in the subscript of 'iout'"}},
                    CutOff{with_in("iout(13,! out"), {open, "3:14: the group's end in the subscript of 'iout'"}},
                    CutOff{with_in("particles='a"), {open, "3:11: this quote is never closed"}},
                    CutOff{with_in("wl="), {open}}, CutOff{with_in(""), {open}}));

TEST(CutOffOverrides, AreToldBehindTheirEnd) {
  EXPECT_EQ(read(with_in("$\n"), {"in.wl=4", "in.iout(13"}).errors(),
            (Texts{"2:11: the group's end in the subscript of 'in.iout'"}));
}

TEST(CompleteDecks, HaveAllThatIsRequired) {
  EXPECT_TRUE(read(with_in("$\n")).deck.complete());
  EXPECT_FALSE(read("$in nx=3 /\n").deck.complete());
  EXPECT_FALSE(read("").deck.complete());
  const std::string without_tmax = "$in nx=3 ny=3 xleft=0. xright=1. ybot=0. ytop=1. tstep=.1 /\n";
  EXPECT_FALSE(read(without_tmax).deck.complete());
  EXPECT_TRUE(read(without_tmax, {"in.tmax=1."}).deck.complete());
}

}  // namespace
}  // namespace tether::test
