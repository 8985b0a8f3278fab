// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/signal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace tether {
namespace {

using Values = std::vector<double>;

Values sampled(const Values& time, const std::function<double(double)>& f) {
  Values values;
  for (const double t : time) values.push_back(f(t));
  return values;
}

Values times(double first, double step, int count) {
  Values all;
  for (int k = 0; k < count; ++k) all.push_back(first + k * step);
  return all;
}

TEST(Middle, OfTheSmallestAndTheLargest) {
  EXPECT_EQ(middle({3, -1, 2, 7, 0}), 3);
  EXPECT_EQ(middle({-4}), -4);
}

TEST(Passages, OfStraightPiecesAreExact) {
  EXPECT_EQ(passages({0, 1, 3, 4}, {-1, 1, -3, -3}, 0), (Values{0.5, 1.5}));
  EXPECT_EQ(passages({0, 1, 3, 4}, {-1, 1, -3, -3}, -2), (Values{2.5}));
  EXPECT_EQ(passages({10, 14}, {0, 8}, 6), (Values{13}));
}

TEST(Passages, NoneWhereTheLevelIsNotReached) {
  EXPECT_EQ(passages({0, 1, 2}, {1, 2, 1}, 0), Values{});
  EXPECT_EQ(passages({0}, {0}, 0), Values{});
  EXPECT_EQ(passages({}, {}, 0), Values{});
}

TEST(Passages, AtASampleOnTheLevel) { EXPECT_EQ(passages({0, 1, 2}, {-1, 0, 1}, 0), Values{1}); }

/// Samples of a sine of period 1, T/(2 n + 1) apart, the first passage a quarter of a step behind a sample, the second
/// three quarters. Linear interpolation between -theta h and (1 - theta) h shifts a root of the sine by
/// omega^2 h^3 theta (1 - theta)(1 - 2 theta)/6: the period between the two is wrong by -omega^2 h^3 / 16.
double period_error(int n) {
  const double h = 1.0 / (2 * n + 1), omega = 2 * std::numbers::pi;
  const Values time = times(-h / 4, h, n + 2);
  return period_about(time, sampled(time, [omega](double t) { return std::sin(omega * t); }), 0) - 1;
}

TEST(Period, OfASampledSineIsOfOrderThree) {
  const double omega = 2 * std::numbers::pi, h = 1.0 / 81;
  EXPECT_NEAR(period_error(40) / (-omega * omega * h * h * h / 16), 1, 0.01);
  EXPECT_NEAR(std::log(period_error(20) / period_error(40)) / std::log(81.0 / 41), 3, 0.01);
}

TEST(Period, IsTheMeanOverAllPassages) {
  EXPECT_EQ(period_about({0, 1, 2, 3, 4, 5, 6, 7}, {-1, 1, 1, -1, -1, -1, -1, 1}, 0), 6);  // passages at .5, 2.5, 6.5
}

/// A sine of period .7 passes 1/2 at 1/12, 5/12 and 13/12 of its period: unlike parts of one full swing.
TEST(Period, OfAFullSwingAboutAnyLevel) {
  const Values time = times(0, 1e-4, 8400);
  const auto swing = [](double t) { return std::sin(2 * std::numbers::pi * t / 0.7); };
  EXPECT_EQ(passages(time, sampled(time, swing), 0.5).size(), 3u);
  EXPECT_NEAR(period_about(time, sampled(time, swing), 0.5), 0.7, 1e-7);
}

TEST(Period, NotANumberWhereTheSamplesDoNotShowIt) {
  EXPECT_TRUE(std::isnan(period_about({0, 1, 2}, {-1, 1, 2}, 0)));
  EXPECT_TRUE(std::isnan(period_about({0, 1, 2}, {1, 1, 2}, 0)));
  EXPECT_TRUE(std::isnan(period_about({}, {}, 0)));
}

/// A parabola with its vertex between samples is read exactly, evenly sampled or not.
TEST(FirstMinimum, OfAParabolaIsExact) {
  const auto fall = [](double t) { return 3 * (t - 1.3) * (t - 1.3) - 2; };
  for (const Values& time : {times(0, 0.25, 12), Values{0, 0.5, 0.9, 1.2, 1.7, 1.9, 2.6, 3.1}}) {
    const auto lowest = first_minimum(time, sampled(time, fall));
    EXPECT_NEAR(lowest.time, 1.3, 1e-14);
    EXPECT_NEAR(lowest.value, -2, 1e-14);
  }
}

TEST(FirstMinimum, IsTheFirstOfTwo) {
  const auto lowest = first_minimum({0, 1, 2, 3, 4, 5, 6}, {0, -4, 0, -4, -8, -4, 0});
  EXPECT_EQ(lowest.time, 1);
  EXPECT_EQ(lowest.value, -4);
}

TEST(FirstMinimum, ASmallWaveOnTheWayDownIsNone) {
  const auto lowest = first_minimum({0, 1, 2, 3, 4, 5}, {0, -4, -3, -6, -6, 0});
  EXPECT_EQ(lowest.time, 3.5);
  EXPECT_EQ(lowest.value, -6.375);  // of the parabola through -3, -6, -6
}

TEST(FirstMinimum, NotANumberWhereTheSamplesOnlyFall) {
  EXPECT_TRUE(std::isnan(first_minimum({0, 1, 2}, {0, -1, -2}).time));
  EXPECT_TRUE(std::isnan(first_minimum({0, 1, 2}, {0, -1, -2}).value));
  EXPECT_TRUE(std::isnan(first_minimum({0, 1, 2, 3}, {0, -1, -2, -1.5}).value));  // not yet half of the way back
  EXPECT_TRUE(std::isnan(first_minimum({}, {}).time));
}

TEST(FirstMaximum, OfAParabolaIsExact) {
  const auto rise = [](double t) { return 5 - 3 * (t - 1.3) * (t - 1.3); };
  for (const Values& time : {times(0, 0.25, 12), Values{0, 0.5, 0.9, 1.2, 1.7, 1.9, 2.6, 3.1}}) {
    const auto highest = first_maximum_after(time, sampled(time, rise), 0.3);
    EXPECT_NEAR(highest.time, 1.3, 1e-14);
    EXPECT_NEAR(highest.value, 5, 1e-14);
  }
}

TEST(FirstMaximum, CountsFromTheTimeGiven) {
  const Values time{0, 1, 2, 3, 4, 5, 6}, values{0, 4, 0, -1, 3, -1, -2};
  EXPECT_EQ(first_maximum_after(time, values, 0).time, 1);
  EXPECT_EQ(first_maximum_after(time, values, 2.5).time, 4);
  EXPECT_EQ(first_maximum_after(time, values, 3).value, 3);
}

TEST(FirstMaximum, NotANumberWhereTheSamplesDoNotFallAgain) {
  EXPECT_TRUE(std::isnan(first_maximum_after({0, 1, 2}, {0, 1, 2}, 0).time));
  EXPECT_TRUE(std::isnan(first_maximum_after({0, 1, 2, 3}, {0, 2, 4, 3}, 0).value));
  EXPECT_TRUE(std::isnan(first_maximum_after({0, 1, 2}, {0, 1, 0}, 5).time));
  EXPECT_TRUE(std::isnan(first_maximum_after({0, 1, 2}, {0, -1, -2}, 0).time));
  EXPECT_TRUE(std::isnan(first_maximum_after({0, 1, 2}, {0, 1, 0}, std::nan("")).time));
  EXPECT_TRUE(std::isnan(first_maximum_after({}, {}, 0).time));
}

}  // namespace
}  // namespace tether
