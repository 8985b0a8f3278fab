// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/chart/evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tether::chart {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Numbers = std::vector<double>;
using Places = std::vector<std::size_t>;

TEST(Front, HasTheRunsThatNoneBeats) {
  const std::vector<Point> runs{{8, .001}, {1, .1}, {2, .05}, {3, .2}, {4, .05}, {2, .06}, {nan, .0001}, {1, nan}};
  EXPECT_EQ(front(runs), (Places{1, 2, 0}));
  EXPECT_EQ(front(std::vector<Point>{}), Places{});
}

/// A path whose result is 5 % off leaves the front where others are nearer, whatever it costs.
TEST(Front, LosesAFamilyThatIsShifted) {
  std::vector<Point> runs;
  for (double h = 0.1; h > 0.01; h /= 2) runs.push_back({0.1 / h, h * h}), runs.push_back({1 / h, 0.05 + h * h});
  for (const std::size_t k : front(runs)) EXPECT_EQ(k % 2, 0U);
  for (std::size_t k = 1; k < runs.size(); k += 2) runs[k].error -= 0.05, runs[k].cost *= 0.01;
  for (const std::size_t k : front(runs)) EXPECT_EQ(k % 2, 1U);
}

TEST(LastingErrors, AreThoseThatFinerRunsKeep) {
  const Numbers kept = lasting(Numbers{.1, .001, nan, .02, .01});
  EXPECT_EQ(kept[0], .1);
  EXPECT_EQ(kept[1], .02);
  EXPECT_TRUE(std::isnan(kept[2]));
  EXPECT_EQ(kept[3], .02);
  EXPECT_EQ(kept[4], .01);
}

TEST(Cheapest, IsTheOneWithinTheTolerance) {
  const std::vector<Point> runs{{8, .001}, {1, .1}, {2, .05}, {2, .04}, {1, nan}};
  EXPECT_EQ(cheapest(runs, .1), 1U);
  EXPECT_EQ(cheapest(runs, .05), 2U);
  EXPECT_EQ(cheapest(runs, .03), 0U);
  EXPECT_EQ(cheapest(runs, .0001), std::nullopt);
}

TEST(OrderOfErrors, IsThatOfTheFinestRuns) {
  const Numbers size{.8, .4, .2, .1, .05};
  Numbers error;
  for (const double h : size) error.push_back(3 * h * h);
  Order order = order_of(size, error);
  EXPECT_NEAR(order.order, 2, 1e-12);
  EXPECT_EQ(order.first, 0U);
  EXPECT_TRUE(order.asymptotic);
  error[0] = .01;  // too coarse to count
  order = order_of(size, error);
  EXPECT_NEAR(order.order, 2, 1e-12);
  EXPECT_EQ(order.first, 1U);
}

TEST(OrderOfErrors, SaysWhereThereIsNoAsymptoticRange) {
  const Numbers size{.4, .2, .1, .05};
  EXPECT_FALSE(order_of(size, Numbers{.1, .02, .018, .0001}).asymptotic);
  EXPECT_FALSE(order_of(size, Numbers{.1, .05, .025, .03}).asymptotic);  // it ends with a floor
  EXPECT_FALSE(order_of(size, Numbers{.1, .05, .045, .042}).asymptotic);
  EXPECT_FALSE(order_of(size, Numbers{.1, .05, .025, nan}).asymptotic);
  EXPECT_FALSE(order_of(Numbers{.2, .1}, Numbers{.2, .1}).asymptotic);
  EXPECT_NEAR(order_of(Numbers{.2, .1}, Numbers{.2, .1}).order, 1, 1e-12);
  EXPECT_TRUE(std::isnan(order_of(Numbers{.2}, Numbers{.2}).order));
}

TEST(Limit, IsFoundByRichardson) {
  for (const double p : {1.0, 2.0, 3.5}) {
    for (const double ratio : {2.0, 1.5}) {
      Numbers size{.4}, value;
      while (size.size() < 4) size.push_back(size.back() / ratio);
      for (const double h : size) value.push_back(7 - 2 * std::pow(h, p));
      const Limit limit = limit_of(size, value);
      EXPECT_TRUE(limit.converges);
      EXPECT_NEAR(limit.value, 7, 1e-9);
      EXPECT_NEAR(limit.order, p, 1e-9);
      EXPECT_NEAR(limit.bound, 7 - value.back(), 1e-9);
    }
  }
}

TEST(Limit, IsNoneWhereValuesSwingOrPart) {
  EXPECT_FALSE(limit_of(Numbers{.4, .2, .1}, Numbers{1, 2, 1.5}).converges);
  const Limit parts = limit_of(Numbers{.4, .2, .1}, Numbers{1, 2, 4});
  EXPECT_FALSE(parts.converges);
  EXPECT_EQ(parts.bound, 2);
  EXPECT_EQ(limit_of(Numbers{.4, .2, .1}, Numbers{1, 2, 2}).value, 2);
  EXPECT_THROW(limit_of(Numbers{.4, .2}, Numbers{1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace tether::chart
