// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/document.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "base/text.hpp"
#include "deck_support.hpp"

namespace tether::test {
namespace {

/// Bits of a value, for a comparison that tells -0.0 from 0.0.
std::string bits(const DeckValue& value) {
  if (const auto* real = std::get_if<double>(&value.data))
    return std::to_string(std::bit_cast<unsigned long long>(*real));
  if (const auto* integer = std::get_if<long long>(&value.data)) return std::to_string(*integer);
  if (const auto* logical = std::get_if<bool>(&value.data)) return *logical ? "t" : "f";
  return std::get<std::string>(value.data);
}

void expect_same_values(const Deck& a, const Deck& b) {
  for (const auto& variable : variables()) {
    if (variable.rank > 0 && variable.n1 > 100) continue;
    for (int j = 1; j <= variable.n2; ++j) {
      for (int i = 1; i <= variable.n1; ++i) {
        const bool known = a.given(AnyVariable(variable), i, j) || !variable.fallback.empty();
        const bool known_b = b.given(AnyVariable(variable), i, j) || !variable.fallback.empty();
        ASSERT_EQ(known, known_b) << variable.group << '.' << variable.name << ' ' << i << ' ' << j;
        if (!known) continue;
        EXPECT_EQ(bits(a.value(AnyVariable(variable), i, j)), bits(b.value(AnyVariable(variable), i, j)))
            << variable.group << '.' << variable.name << ' ' << i << ' ' << j;
      }
    }
  }
}

class EffectiveBoxes : public testing::TestWithParam<std::string> {};

TEST_P(EffectiveBoxes, ReadBackWithTheSameValues) {
  const auto first = read(box_text(GetParam()) + "1.0 ! particle data\n");
  const auto text = effective_deck(first.deck);
  const auto second = read(text);
  EXPECT_EQ(second.errors(), Texts{});
  expect_same_values(first.deck, second.deck);
  EXPECT_EQ(second.deck.header(), first.deck.header());
  EXPECT_EQ(second.deck.trailer().text, "1.0 ! particle data\n");
  EXPECT_EQ(effective_deck(second.deck), text);
}

INSTANTIATE_TEST_SUITE_P(Thesis, EffectiveBoxes, testing::ValuesIn(box_names()));

TEST(EffectiveDeck, KeepsEveryBit) {
  const auto first = read(with_in("tiout=.1,1e-310,4.9e-324,1.7976931348623157d308,123456789.,1e22,3.3333333333333333\n"
                                  "gravc=-0. particles='it''s \"here\"/!$' miter=-2147483648 large=t\n$\n"
                                  "$points tracked(99999)=t heavy(100000)=.3 tracked_at(1,100)=1.,2. /\n"),
                          {"in.cntr=.3"});
  ASSERT_EQ(first.errors(), Texts{});
  const auto second = read(effective_deck(first.deck));
  EXPECT_EQ(second.errors(), Texts{});
  expect_same_values(first.deck, second.deck);
  EXPECT_EQ(second.deck.real("points.heavy", 100000), 0.3);
  EXPECT_TRUE(second.deck.logical("points.tracked", 99999));
  EXPECT_EQ(second.deck.given_elements("points.tracked").size(), 1U);
}

TEST(EffectiveDeck, ShowsDefaultsThatAreUsed) {
  const auto text = effective_deck(read("a title\n" + with_in("$\n$reg nreg=2 densir(1)=1. nprg(2)=9 /\n")).deck);
  EXPECT_EQ(text.find("a title\n$in\nnx = 11\nny = 21\nigen = 1\ngravc = 0.0\nxleft = 0.0\n"), 0U);
  EXPECT_NE(text.find("units = 'none'\n"), std::string::npos);
  EXPECT_NE(text.find("$mpm\nmethod = 'thesis'\ncriterion = 1\njaumann = .false.\nreduce = .false.\n$\n"),
            std::string::npos);
  EXPECT_NE(text.find("nprg(1) = 4\nnprg(2) = 9\ndensir(1) = 1.0\nvrx(1) = 0.0\nvrx(2) = 0.0\n"), std::string::npos);
  for (const char* absent : {"rex", "dtmax", "iout", "$points", "density", "densir(2)", "nprg(3)"}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
  }
}

/// The line of a listing that begins with a name, its runs of blanks made one.
std::string listed(const std::string& listing, const std::string& name) {
  for (const auto& line : split_lines(listing)) {
    if (trim(line).substr(0, name.size() + 1) != name + " ") continue;
    std::string text;
    for (const char c : trim(line)) {
      if (c != ' ' || text.back() != ' ') text += c;
    }
    return text;
  }
  return "";
}

TEST(CheckListing, OneLineAVariableAndGivenElement) {
  const auto deck = read(with_in("iout(13)=1,tiout(13)=5.d-2,methd=0\n$\n$reg xvi(1,1)=.5,.7 /\n"), {"in.wl=4"}).deck;
  const auto text = check_listing(deck, {.all = true});
  EXPECT_EQ(listed(text, "nx"), "nx 11 given 2:4");
  EXPECT_EQ(listed(text, "tmax"), "tmax 1.0 given time 2:53");
  EXPECT_EQ(listed(text, "gravc"), "gravc 0.0 default length/time2");
  EXPECT_EQ(listed(text, "dtmax"), "dtmax - not given time");
  EXPECT_EQ(listed(text, "methd"), "methd 0 given 3:34 read, no effect");
  EXPECT_EQ(listed(text, "cntr"), "cntr 1.0 default read, no effect");
  EXPECT_EQ(listed(text, "tiout(13)"), "tiout(13) 0.05 given time 3:22");
  EXPECT_EQ(listed(text, "iout(60)"), "");
  EXPECT_EQ(listed(text, "xvi(2,1)"), "xvi(2,1) 0.7 given length 5:18");
  EXPECT_EQ(listed(text, "wl"), "wl 4 given --set 1:7");
  EXPECT_EQ(listed(text, "tracked(100000)"), "tracked(100000) .false. default");
  EXPECT_EQ(listed(text, "$mpm"), "$mpm (not in the deck)");
  EXPECT_EQ(split_lines(text).front(), "$in");
}

TEST(VariablesListing, OfOneGroupOfAllAndOfNone) {
  const auto fluid = variables_listing("fluid");
  EXPECT_EQ(split_lines(fluid).size(), 8U);
  EXPECT_EQ(listed(fluid, "gm1"),
            "gm1 real - > 0 default 0.4 gamma - 1 of the gas, gamma the ratio of its specific heats.");
  EXPECT_EQ(listed(fluid, "siep(20)"),
            "siep(20) real energy/mass >= 0 default 0.0 Specific internal energy of the gas of region i at the start.");
  EXPECT_EQ(variables_listing("nosuch"), "");
  std::string all;
  for (const auto& group : group_names()) all += variables_listing(group);
  EXPECT_EQ(variables_listing(""), all);
}

TEST(VariablesMarkdown, ASectionAGroupAndARowAVariable) {
  const auto text = variables_markdown();
  EXPECT_EQ(text.find("## `$in`\n\n| name | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n"
                      "| `nx` | integer | - | 2 to 1000000000 | required | Nodes of the background grid in x. |\n"),
            0U);
  EXPECT_NE(text.find("\n| `order` | text | - | musl, usf or usl | - | "), std::string::npos);
  EXPECT_NE(text.find("\n| `tol` | real | - | - | - | Tolerance of the old code's iteration. (Read, no effect.) |\n"),
            std::string::npos);
  EXPECT_NE(text.find("\n| `rex(20)` | real | length | >= 0 | 1e30 | "), std::string::npos);
  EXPECT_NE(text.find("they are tether's own"), std::string::npos);
  std::size_t rows = 0;
  for (const auto& line : split_lines(text)) rows += line.starts_with("| `") ? 1 : 0;
  EXPECT_EQ(rows, variables().size());
}

}  // namespace
}  // namespace tether::test
