// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace tether {
namespace {

TEST(Numbers, IntegersAreDigitsWithASign) {
  EXPECT_EQ(parse_integer("0"), 0);
  EXPECT_EQ(parse_integer("+5"), 5);
  EXPECT_EQ(parse_integer("-007"), -7);
  EXPECT_EQ(parse_integer("2147483648"), 2147483648LL);
}

TEST(Numbers, HugeIntegersSaturate) {
  EXPECT_EQ(parse_integer("99999999999999999999"), std::numeric_limits<long long>::max());
  EXPECT_EQ(parse_integer("-99999999999999999999"), std::numeric_limits<long long>::min());
}

TEST(Numbers, WhatIsNoInteger) {
  for (const char* text : {"", "+", "-", "+-5", "-+5", "5.", "5e0", " 5", "5 ", "0x5", "5a", "--5"}) {
    EXPECT_FALSE(parse_integer(text)) << text;
  }
}

TEST(Numbers, FortranReals) {
  EXPECT_EQ(parse_real("1.d-4"), 1e-4);
  EXPECT_EQ(parse_real("10.d25"), 1e26);
  EXPECT_EQ(parse_real("1.5+3"), 1500.0);
  EXPECT_EQ(parse_real("1-3"), 0.001);
  EXPECT_EQ(parse_real("+.5"), 0.5);
  EXPECT_EQ(parse_real("-.5D+01"), -5.0);
  EXPECT_EQ(parse_real("2."), 2.0);
  EXPECT_EQ(parse_real("2.q5"), 2e5);
  EXPECT_EQ(parse_real("7Q-1"), 0.7);
  EXPECT_EQ(parse_real("1e007"), 1e7);
  EXPECT_EQ(parse_real("0.1"), 0.1);
  EXPECT_EQ(parse_real("0e999999999999"), 0.0);
}

TEST(Numbers, ZeroKeepsItsSign) {
  EXPECT_TRUE(std::signbit(parse_real("-0.000e0").value()));
  EXPECT_FALSE(std::signbit(parse_real("+0.").value()));
}

TEST(Numbers, OverflowIsInfiniteAndUnderflowIsNearest) {
  EXPECT_EQ(parse_real("1e400"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_real("-1d400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_real("1e-400"), 0.0);
  EXPECT_EQ(parse_real("2.5e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(Numbers, NamedNumbers) {
  EXPECT_EQ(parse_real("Inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_real("-INFINITY"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_real("+nan").value()));
}

TEST(Numbers, WhatIsNoReal) {
  for (const char* text :
       {"",    ".",   "+",    "-.",  "1e",    "1.e+", "1d",     "1.5x3", "1.0e5.", "2.00.", "1..2", "e5",
        ".e5", "--1", "1+-3", "1e+", "0x1p3", "infx", "nan(3)", "1_8",   "1,5",    " 1",    "1 ",   "1e5d3"}) {
    EXPECT_FALSE(parse_real(text)) << text;
  }
}

TEST(Numbers, ALongNumberIsReadWhole) { EXPECT_EQ(parse_real(std::string(5000, '0') + "12.5"), 12.5); }

}  // namespace
}  // namespace tether
