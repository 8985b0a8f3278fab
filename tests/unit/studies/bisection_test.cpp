// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tether {
namespace {

using Values = std::vector<double>;

/// Runs a bisection of what holds; the values that were looked at.
Values look(Bisection& bisection, const std::function<bool(double)>& holds) {
  Values looked;
  for (auto next = bisection.next(); !next.empty(); next = bisection.next()) {
    for (const double value : next) {
      looked.push_back(value);
      bisection.take(value, holds(value));
    }
  }
  return looked;
}

TEST(Bisection, BothEndsThenTheMiddles) {
  Bisection bisection({0, 8, 0.125});
  EXPECT_EQ(look(bisection, [](double x) { return x <= 5.5; }), (Values{0, 8, 4, 6, 5}));
  EXPECT_TRUE(bisection.found());
  EXPECT_EQ(bisection.holds(), 5);
  EXPECT_EQ(bisection.fails(), 6);
}

TEST(Bisection, GoesOnUntilTheIntervalIsShortEnough) {
  Bisection bisection({1, 4, 1e-6});
  look(bisection, [](double x) { return x * x <= 2; });
  EXPECT_LE(bisection.holds(), std::sqrt(2));
  EXPECT_GT(bisection.fails(), std::sqrt(2));
  EXPECT_LE(bisection.fails() - bisection.holds(), 4e-6);
  EXPECT_GT(bisection.fails() - bisection.holds(), 2e-6);
}

TEST(Bisection, EndsAboutZeroAndBelowIt) {
  Bisection about({-1, 1, 1e-3});
  EXPECT_EQ(look(about, [](double x) { return x <= 0; }).size(), 13u);  // both ends, and 2 / 2^11 < 1e-3
  EXPECT_EQ(about.holds(), 0);
  Bisection below({-300, -100, 1e-3});
  look(below, [](double x) { return x < -200; });
  EXPECT_TRUE(below.found());
  EXPECT_LT(below.holds(), -200);
}

TEST(Bisection, TheOrderOfTheEndsIsFree) {
  Bisection bisection({1, 2, 0.25});
  bisection.take(2, false);
  EXPECT_TRUE(bisection.next().empty());  // the other end is still under way
  EXPECT_EQ(bisection.verdict(), "not yet");
  bisection.take(1, true);
  EXPECT_EQ(bisection.next(), Values{1.5});
}

TEST(Bisection, EndsThatAgreeAreAVerdict) {
  Bisection hold({1, 2, 0.1}), fail({1, 2, 0.1}), turned({1, 2, 0.1});
  EXPECT_EQ(look(hold, [](double) { return true; }).size(), 2u);
  EXPECT_EQ(look(fail, [](double) { return false; }).size(), 2u);
  EXPECT_EQ(look(turned, [](double x) { return x > 1.5; }).size(), 2u);
  EXPECT_EQ(hold.verdict(), "both ends hold");
  EXPECT_EQ(hold.holds(), 2);
  EXPECT_TRUE(std::isnan(hold.fails()));
  EXPECT_EQ(fail.verdict(), "both ends fail");
  EXPECT_TRUE(std::isnan(fail.holds()));
  EXPECT_EQ(turned.verdict(), "fails at the lower end alone");
  EXPECT_FALSE(hold.found() || fail.found() || turned.found());
}

TEST(Criterion, BothBoundsBelongToIt) {
  const Criterion criterion{"steps", 1, 3};
  EXPECT_TRUE(criterion.holds(1) && criterion.holds(3));
  EXPECT_FALSE(criterion.holds(0.999) || criterion.holds(3.001));
  EXPECT_FALSE(criterion.holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE((Criterion{"steps"}.holds(-1e300)));
}

}  // namespace
}  // namespace tether
