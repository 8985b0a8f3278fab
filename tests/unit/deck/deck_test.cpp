// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "deck_support.hpp"

namespace tether::test {
namespace {

TEST(Deck, GivesDefaultsOfTheTable) {
  const auto deck = read_in("").deck;
  EXPECT_EQ(deck.integer("in.igen"), 1);
  EXPECT_EQ(deck.integer("in.iout", 13), 0);
  EXPECT_EQ(deck.real("reg.rex", 20), 1e30);
  EXPECT_EQ(deck.real("fluid.gm1"), 0.4);
  EXPECT_EQ(deck.text("in.units"), "none");
  EXPECT_TRUE(deck.logical("membrane.wrinkle"));
  EXPECT_EQ(deck.text("reference.solution"), "");
  EXPECT_FALSE(deck.given("in.igen"));
  EXPECT_TRUE(deck.given_elements("in.iout").empty());
}

TEST(Deck, PlacesOfValuesGroupsAndTheFile) {
  const auto deck = read_in("  igen=3").deck;
  EXPECT_EQ(deck.place("in.igen").line, 3);
  EXPECT_EQ(deck.place("in.igen").column, 8);
  EXPECT_EQ(deck.place("in.cyl").line, 1);
  EXPECT_EQ(deck.place("fluid.mu").line, 0);
  EXPECT_EQ(deck.place("fluid.mu").file, "a.in");
  EXPECT_EQ(deck.line_text(deck.place("in.igen")), "  igen=3");
  EXPECT_EQ(deck.line_text(deck.place("fluid.mu")), "");
  EXPECT_EQ(deck.line_text({"a.in", 99, 1}), "");
}

TEST(Deck, RemarksStandAtTheValue) {
  const auto deck = read_reg("nreg=1, densir=2.5").deck;
  EXPECT_EQ(to_text(deck.remark(Severity::warning, "reg.densir", {1, 1}, "heavy", "Write less.")),
            "a.in:5:16: warning: heavy\n  nreg=1, densir=2.5\n                 ^\n  Write less.\n");
}

TEST(Deck, ProgrammersMistakes) {
  const auto deck = read_in("").deck;
  EXPECT_THROW(deck.real("in.dtmax"), std::logic_error);  // neither given nor with a default
  EXPECT_THROW(AnyVariable("in", "nosuch"), std::logic_error);
  EXPECT_THROW(RealVariable("in", "nx"), std::logic_error);
  EXPECT_THROW(LogicalVariable("in", "tmax"), std::logic_error);
  EXPECT_THROW(TextVariable("in", "wl"), std::logic_error);
  EXPECT_THROW(IntegerVariable("in", "tmax"), std::logic_error);
}

TEST(Variables, AreHandlesOfTheirRows) {
  constexpr RealVariable tmax = "in.tmax";
  static_assert(tmax.group() == "in" && tmax.name() == "tmax");
  EXPECT_EQ(AnyVariable("in", "tmax"), tmax);
  EXPECT_EQ(AnyVariable("fem.load").with("_on"), AnyVariable("fem.load_on"));
  EXPECT_THROW(AnyVariable("fem.load").with("_off"), std::logic_error);
  EXPECT_EQ(fmt::format("{}", tmax), "tmax");
}

TEST(Variables, TheTableIsConsistent) {
  std::string group;
  for (const auto& variable : variables()) {
    const auto name = std::string(variable.group) + "." + std::string(variable.name);
    EXPECT_EQ(find_variable(variable.group, variable.name), &variable) << name << " stands there twice";
    EXPECT_TRUE(is_group(variable.group));
    EXPECT_LE(variable.low, variable.high) << name;
    EXPECT_TRUE(variable.meaning.ends_with('.')) << name;
    EXPECT_GE(variable.n1, 1) << name;
    EXPECT_EQ(variable.rank == 2, variable.n2 > 1) << name;
    EXPECT_EQ(variable.rank >= 1, variable.n1 > 1) << name;
    EXPECT_FALSE(variable.required && !variable.fallback.empty()) << name;
  }
  EXPECT_EQ(find_variable("in", "mu"), nullptr);
}

TEST(Variables, DefaultsAreWithinTheirRange) {
  for (const auto& variable : variables()) {
    if (variable.fallback.empty()) continue;
    const std::string name(variable.name), subscript = variable.rank == 0 ? "" : variable.rank == 1 ? "(1)" : "(1,1)";
    const auto reading =
        read(variable.group == study_group ? "$study\n$\n" : with_in("$\n"),
             {std::string(variable.group) + "." + name + subscript + "=" + std::string(variable.fallback)});
    EXPECT_EQ(reading.errors(), Texts{}) << name;
  }
}

TEST(Variables, GroupsInTheirOrder) {
  EXPECT_EQ(group_names(), (Texts{"in", "fluid", "regrig", "reg", "membrane", "points", "mpm", "reference", "limits",
                                  "mesh", "fem", "contact", "rigid", "flow", "coupled", "study", "published", "auto"}));
}

}  // namespace
}  // namespace tether::test
