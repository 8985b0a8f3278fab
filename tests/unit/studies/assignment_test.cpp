// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/assignment.hpp"

#include <gtest/gtest.h>

namespace tether {
namespace {

using Texts = std::vector<std::string>;
using Names = std::set<std::string>;

/// "column: message" of each mistake.
Texts mistakes(const std::string& text, Taken taken = Taken::one_by_one) {
  Texts told;
  for (const auto& mistake : read_assignment(text, taken).mistakes)
    told.push_back(std::to_string(mistake.column) + ": " + mistake.message);
  return told;
}

TEST(Assignment, ValuesOneByOne) {
  const auto axis = read_assignment("in.nx=51,101, 201", Taken::one_by_one);
  EXPECT_TRUE(axis.mistakes.empty());
  EXPECT_EQ(axis.variable, "in.nx");
  EXPECT_EQ(axis.values, (Texts{"51", "101", "201"}));
  EXPECT_EQ(axis.one_value, Names{"in.nx"});
  EXPECT_EQ(axis.override_text(1), "in.nx=101");
  EXPECT_EQ(std::get<double>(axis.cell(2)), 201);
}

TEST(Assignment, Texts) {
  const auto axis = read_assignment("mpm.order='musl',\"usl\"", Taken::one_by_one);
  EXPECT_EQ(axis.values, (Texts{"'musl'", "'usl'"}));
  EXPECT_EQ(std::get<std::string>(axis.cell(1)), "usl");
  const auto path = read_assignment("in.particles='it''s.par','a,b'", Taken::one_by_one);
  EXPECT_EQ(path.values, (Texts{"'it''s.par'", "'a,b'"}));
  EXPECT_EQ(std::get<std::string>(path.cell(0)), "it's.par");
}

TEST(Assignment, NumbersAndLogicalsAsFortranWritesThem) {
  const auto axis = read_assignment("in.tstep=1.d-4,.5", Taken::one_by_one);
  EXPECT_EQ(std::get<double>(axis.cell(0)), 1e-4);
  EXPECT_EQ(std::get<double>(axis.cell(1)), 0.5);
  EXPECT_EQ(std::get<std::string>(read_assignment("membrane.wrinkle=f", Taken::one_by_one).cell(0)), ".false.");
}

TEST(Assignment, NamesInAnySpelling) {
  EXPECT_EQ(read_assignment(" IN.NX = 51", Taken::one_by_one).variable, "in.nx");
  EXPECT_EQ(read_assignment("reg.yvi( 3 : 4, 1)=0.1", Taken::one_by_one).variable, "reg.yvi(3:4,1)");
}

TEST(Assignment, ARepeatedValueSetsSeveralElements) {
  const auto axis = read_assignment("reg.yvi(3:4,1:2)=4*0.1,2*0.2", Taken::one_by_one);
  EXPECT_TRUE(axis.mistakes.empty());
  EXPECT_EQ(axis.values, (Texts{"4*0.1", "2*0.2"}));
  EXPECT_EQ(axis.first, (Subscript{3, 1}));
  EXPECT_EQ(axis.one_value, (Names{"reg.yvi(3,1)", "reg.yvi(3,2)", "reg.yvi(4,1)", "reg.yvi(4,2)"}));
  EXPECT_EQ(std::get<double>(axis.cell(1)), 0.2);
}

TEST(Assignment, TogetherTheValuesFillOnward) {
  const auto set = read_assignment("in.tiout(33)=1.e-4,2*1.e-5", Taken::together);
  EXPECT_TRUE(set.mistakes.empty());
  EXPECT_EQ(set.all, (Names{"in.tiout(33)", "in.tiout(34)", "in.tiout(35)"}));
}

TEST(Assignment, MistakesWithTheirColumns) {
  EXPECT_EQ(mistakes("in.nx=51,x,1"), (Texts{"10: nx must be an integer, not 'x'", "12: nx = 1 is out of range"}));
  EXPECT_EQ(mistakes("in.nxx=51,101"), (Texts{"4: $in has no variable 'nxx'"}));
  EXPECT_EQ(mistakes("inn.nx=51"), (Texts{"1: 'inn.nx' names no group"}));
  EXPECT_EQ(mistakes("in.iout(61)=1"), (Texts{"9: subscript 61 of iout is out of range"}));
  EXPECT_EQ(mistakes("mpm.order='musl','fast'"), (Texts{"18: order = 'fast' is none of its choices"}));
  EXPECT_EQ(mistakes("in.nx=51,,101"), (Texts{"1: a value is missing"}));
  EXPECT_EQ(mistakes("in.nx="), (Texts{"1: no value is given"}));
  EXPECT_EQ(mistakes("in.nx"), (Texts{"1: this is no override"}));
  EXPECT_EQ(mistakes(""), (Texts{"1: this is no override"}));
  EXPECT_EQ(mistakes("in.nx=5 in.ny=6").size(), 1u);
  EXPECT_EQ(mistakes("in.nx=2*51,51").size(), 1u);
}

TEST(Assignment, ANameAloneIsCheckedWithoutItsValue) {
  EXPECT_EQ(mistakes("in.tmax=0.0", Taken::name_alone), Texts{});
  EXPECT_EQ(mistakes("in.tmax=0.0"), (Texts{"9: tmax = 0 is out of range"}));
  EXPECT_EQ(mistakes("in.tmx=0.0", Taken::name_alone), (Texts{"4: $in has no variable 'tmx'"}));
  EXPECT_EQ(mistakes("reg.densir(99)=0.0", Taken::name_alone).size(), 1u);
}

}  // namespace
}  // namespace tether
