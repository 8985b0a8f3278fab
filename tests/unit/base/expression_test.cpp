// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cmath>
#include <locale>
#include <numbers>

namespace tether {
namespace {

double at(const std::string& text, double t) { return Expression(text, {"t"})(std::array{t}); }

TEST(Expressions, AreComputedAsWritten) {
  EXPECT_DOUBLE_EQ(at("sin(2*pi*t)", 0.1), std::sin(2 * std::numbers::pi * 0.1));
  EXPECT_DOUBLE_EQ(at("1.5e-3*t + .5", 2), 0.503);
  EXPECT_DOUBLE_EQ(at("-t^2", 3), -9);
  EXPECT_DOUBLE_EQ(at("2^3^2", 0), 512);
  EXPECT_DOUBLE_EQ(at("8/4/2 - 1 - 1", 0), -1);
  EXPECT_DOUBLE_EQ(at("t < 1 ? t : 1", 0.25), 0.25);
  EXPECT_DOUBLE_EQ(at("t < 1 ? t : 1", 4), 1);
  EXPECT_DOUBLE_EQ(at("(t>1 && t<=2) + (t==3 || t!=3)", 2), 2);
  EXPECT_DOUBLE_EQ(at("log(e) + log10(100) + exp(0)", 0), 4);
  EXPECT_DOUBLE_EQ(at("min(t, 2) + max(t, 2) + atan2(0, -1)", 5), 7 + std::numbers::pi);
  EXPECT_DOUBLE_EQ(at("sign(-t) + abs(-t) + floor(t)", 2.5), 3.5);
  EXPECT_EQ(at("sign(t)", 0), 0);
  EXPECT_DOUBLE_EQ(at("tanh(t)/cosh(t)*sinh(t) + sqrt(t) - cos(t) + tan(t)", 0.5),
                   std::tanh(.5) / std::cosh(.5) * std::sinh(.5) + std::sqrt(.5) - std::cos(.5) + std::tan(.5));
}

TEST(Expressions, HaveAnyNumberOfVariables) {
  const Expression inflow("4*y*(1 - y)*(1 + x)*t", {"x", "y", "t"});
  EXPECT_DOUBLE_EQ(inflow(std::array{1.0, 0.5, 3.0}), 6);
  EXPECT_DOUBLE_EQ(inflow(std::array{0.0, 0.25, 1.0}), 0.75);
  EXPECT_THROW(inflow(std::array{1.0}), std::invalid_argument);
  EXPECT_DOUBLE_EQ(Expression("2*pi", {})({}), 2 * std::numbers::pi);
}

TEST(Expressions, KeepTheirValuesWhenMoved) {
  Expression one("t + 1", {"t"});
  const Expression other = std::move(one);
  EXPECT_DOUBLE_EQ(other(std::array{1.0}), 2);
}

TEST(Expressions, MayBeNoNumber) {
  EXPECT_TRUE(std::isinf(at("1/t", 0)));
  EXPECT_TRUE(std::isnan(at("sqrt(t)", -1)));
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Expressions, MeanTheSameUnderEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const double value = at("1.5*t", 2);
  std::locale::global(before);
  EXPECT_DOUBLE_EQ(value, 3);
}

struct Wrong {
  const char* text;
  std::size_t at;
  const char* message;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << testing::PrintToString(std::string(wrong.text)); }

class WrongExpressions : public testing::TestWithParam<Wrong> {};

TEST_P(WrongExpressions, AreRefusedAtTheirPlace) {
  try {
    Expression(GetParam().text, {"t"});
    FAIL() << GetParam().text;
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.at(), GetParam().at) << error.what();
    EXPECT_NE((std::string(error.what()) + " " + error.hint()).find(GetParam().message), std::string::npos)
        << error.what() << " " << error.hint();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, WrongExpressions,
    testing::Values(Wrong{"", 0, "empty"}, Wrong{"   ", 3, "empty"}, Wrong{"2*sn(t)", 2, "Did you mean 'sin'?"},
                    Wrong{"flaar(t)", 0, "Did you mean 'floor'?"}, Wrong{"1 + T", 4, "Did you mean 't'?"},
                    Wrong{"x*2", 0, "unknown word 'x'"}, Wrong{"2*(t", 4, "missing parenthesis"},
                    Wrong{"t+", 2, "end of expression"}, Wrong{"2 t", 2, "unexpected variable"},
                    Wrong{"*t", 0, "unexpected operator"}, Wrong{"t=3", 1, "nothing is assigned"},
                    Wrong{"!t", 0, "no operator"}, Wrong{"t + \"a\"", 4, "no meaning"},
                    Wrong{"1,5*t", 1, "decimal point"}, Wrong{"sin(t,2)", 7, "too many parameters"},
                    Wrong{"max(t)", 5, "too few parameters"}, Wrong{"t>0?1", 5, "else"},
                    Wrong{"1d3", 1, "unknown word 'd3'"}, Wrong{"0x10", 1, "unknown word"},
                    Wrong{"t;t", 1, "no meaning"}, Wrong{"t \xc3\xa9", 2, "no meaning"},
                    Wrong{"rnd", 0, "unknown word"}, Wrong{"1:2", 1, "colon"}, Wrong{"t(2)", 1, "parenthesis"}),
    [](const auto& test) { return "Number" + std::to_string(test.index); });

TEST(Expressions, OfAnyBytesAreRefusedOrComputed) {
  const std::string seeds[] = {"sin(2*pi*t)", "t < 1 ? t^2 : max(t, 1e-3)", "(t>1 && t<=2)*exp(-t/0.5)"};
  int refused = 0, taken = 0;
  for (const auto& seed : seeds) {
    for (std::size_t k = 0; k < seed.size(); ++k) {
      for (int byte = 0; byte < 256; ++byte) {
        std::string text = seed;
        text[k] = static_cast<char>(byte);
        try {
          Expression expression(text, {"t"});
          expression(std::array{1.0});
          ++taken;
        } catch (const ExpressionError& error) {
          EXPECT_LE(error.at(), text.size());
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(taken, 100);
  EXPECT_THROW(Expression(std::string(5000, '('), {"t"}), ExpressionError);
}

}  // namespace
}  // namespace tether
