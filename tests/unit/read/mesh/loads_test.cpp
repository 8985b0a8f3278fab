// SPDX-License-Identifier: GPL-3.0-or-later
// Factors of loads and supports over time: tables and expressions, and what is wrong with them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/diagnostics.hpp"
#include "model/solids.hpp"
#include "unit/read/scene_support.hpp"

namespace tether::test {
namespace {

/// A square of one element; `fem` is line 10.
Built square(const std::string& fem) {
  return build_on_mesh(
      on_unit_square("$\n$reg nreg=1,nvi=4\nxvi(1,1)=.25,.75,.75,.25\nyvi(1,1)=.25,.25,.75,.75\n"
                     "densir=3.,matr(1,1)=10.,.25 $\n$mesh $\n$fem\n" +
                     fem + "\n$\n"));
}

const Amplitude& first_load(const Built& built) { return built.scene.solids()->loads.at(0).amplitude; }

TEST(Loads, FollowAnExpression) {
  const Built built = square("load_on(1)='1.top',load(1,1)=1.,load_expression(1)='sin(2*pi*t)'");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_DOUBLE_EQ(first_load(built).at(0.1), std::sin(0.2 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(first_load(built).at(0), 0);
}

TEST(Loads, FollowATable) {
  const Built built = square("load_on(1)='1.top',load(1,1)=1.,load_time(1,1)=1.,3.,load_factor(1,1)=10.,20.");
  ASSERT_EQ(built.errors(), Texts{});
  for (const auto& [t, factor] : {std::pair{0.0, 10.0}, {1.0, 10.0}, {2.5, 17.5}, {3.0, 20.0}, {9.0, 20.0}})
    EXPECT_DOUBLE_EQ(first_load(built).at(t), factor);
  const Built with_gap = square(
      "load_on(1)='1.top',load(1,1)=1.,load_time(1,1)=0.,load_time(4,1)=2.,"
      "load_factor(1,1)=1.,load_factor(4,1)=3.");
  ASSERT_EQ(with_gap.errors(), Texts{});
  EXPECT_DOUBLE_EQ(first_load(with_gap).at(1), 2);
}

TEST(Loads, GrowInProportionToTimeWhereNothingIsGiven) {
  const std::string held = "fix_on(1)='1.left',fix(1,1)=0.,0.,static=.true.,load_on(1)='1.top',load(1,1)=1.";
  EXPECT_DOUBLE_EQ(first_load(square(held)).at(0.5), 0.25);  // tmax is 2
  EXPECT_DOUBLE_EQ(first_load(square(held + ",load_expression(1)='3'")).at(0.5), 3);
  EXPECT_DOUBLE_EQ(first_load(square("load_on(1)='1.top',load(1,1)=1.")).at(0.5), 1);
}

TEST(Loads, MayBePressures) {
  const Built built = square("load_on(1)='1.top',pressure(1)=2.,load_on(2)='1.left',load(1,2)=1.,pressure(2)=-3.");
  ASSERT_EQ(built.errors(), Texts{});
  const auto& loads = built.scene.solids()->loads;
  EXPECT_EQ(loads.at(0).pressure, 2);
  EXPECT_FALSE(loads.at(0).is_dead());
  EXPECT_EQ(loads.at(1).pressure, -3);
  EXPECT_TRUE(loads.at(1).is_dead());
}

/// What only motions have is reported where there are none.
TEST(Loads, EquilibriaHaveNoMotion) {
  const auto told = [](const std::string& fem) {
    Texts texts;
    for (const auto& d : square("fix_on(1)='1.left',fix(1,1)=0.,0.," + fem).diagnostics.warnings())
      texts.push_back(d.message.substr(0, d.message.find(':')));
    return texts;
  };
  EXPECT_EQ(told("static=.true.,alpha=1.,spin(3,1)=2."),
            (Texts{"spin of $fem has no effect", "alpha of $fem has no effect"}));
  EXPECT_EQ(told("static=.true.,alpha=0."), Texts{});
  EXPECT_EQ(told("alpha=1."), Texts{});
}

TEST(Loads, SupportsFollowExpressionsToo) {
  const Built built = square("fix_on(2)='1.left',fix(1,2)=.5,fix_expression(2)='t^2'");
  ASSERT_EQ(built.errors(), Texts{});
  EXPECT_DOUBLE_EQ(built.scene.solids()->supports.at(0).amplitude.at(3), 9);
}

TEST(Loads, StopTheRunWhereAnExpressionHasNoValue) {
  const Built built = square("load_on(7)='1.top',load(1,7)=1.,load_expression(7)='1/(t-1)'");
  EXPECT_DOUBLE_EQ(first_load(built).at(3), 0.5);
  try {
    first_load(built).at(1);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()).find("t = 1: the expression of load 7, '1/(t-1)', gives inf"), 0U)
        << error.what();
  }
}

TEST(Loads, TellOfAMistakeInAnExpressionUnderItsByte) {
  const Built built = square(
      "load_on(1)='1.top',load(1,1)=1.,\nload_expression(1)='sin(2*pi*tt)',\n"
      "fix_on(1)='1.left',fix(1,1)=0.,fix_expression(1)='2*'");
  EXPECT_EQ(built.errors(), (Texts{"11:30: the expression has an unknown word 'tt'",
                                   "12:53: the expression is wrong: unexpected end of expression"}));
}

TEST(Loads, HaveATableOrAnExpression) {
  const Built built = square(
      "load_on(1)='1.top',load(1,1)=1.,load_expression(1)='t',\nload_time(1,1)=0.,1.,"
      "load_factor(1,1)=0.,1.");
  EXPECT_EQ(built.errors(), Texts{"10:52: load 1 has a table and an expression"});
}

TEST(Loads, TellOfTablesThatAreNone) {
  const auto errors = [](const std::string& table) {
    return square("load_on(1)='1.top',load(1,1)=1.,\n" + table).errors();
  };
  EXPECT_EQ(errors("load_time(1,1)=0.,1.,load_factor(1,1)=1."), Texts{"11:19: load_factor(2,1) is not given"});
  EXPECT_EQ(errors("load_time(1,1)=0.,load_factor(1,1)=1.,2."), Texts{"11:39: load_time(2,1) is not given"});
  EXPECT_EQ(errors("load_factor(1,1)=1."), Texts{"11:18: load_time(1,1) is not given"});
  EXPECT_EQ(errors("load_time(1,1)=1.,.5,load_factor(1,1)=1.,2."),
            Texts{"11:19: the times of a table ascend: 0.5 is not after 1"});
}

TEST(Loads, TellOfNumbersWithoutASide) {
  const Built built = square("load(1,3)=1.,2.,fix_expression(4)='t',fix(1,4)=0.");
  EXPECT_EQ(built.errors(), (Texts{"10:11: load 3 acts on nothing: load_on(3) is not given",
                                   "10:48: support 4 acts on nothing: fix_on(4) is not given"}));
}

TEST(Loads, SuggestTheSideThatIsMeant) {
  const Built built = square("load_on(1)='1.tap',load(1,1)=1.");
  ASSERT_EQ(built.errors(), Texts{"10:12: no side is called '1.tap'"});
  EXPECT_EQ(built.diagnostics.errors()[0].hint.find("Did you mean '1.top'? The sides of this mesh: 1.bottom, "), 0U);
}

}  // namespace
}  // namespace tether::test
