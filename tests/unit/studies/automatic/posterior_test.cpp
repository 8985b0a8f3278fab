// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/posterior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/full_length.hpp"

namespace tether::automatic {
namespace {

const Orders second{2., 2.};

/// Runs of which each one is twice as fine as the one before in cells, steps, or both.
std::vector<Resolution> levels() { return {{1, 1}, {1, 2}, {2, 2}, {4, 4}, {4, 8}, {8, 8}}; }

template <class Value>
std::vector<Sample> sampled(const std::vector<Resolution>& at, const Value& value) {
  std::vector<Sample> samples;
  for (const Resolution& each : at) samples.push_back({each, value(each)});
  return samples;
}

TEST(AutomaticPosterior, FindsLimitAndOrdersOfPowers) {
  const auto value = [](const Resolution& at) {
    return 3 + 0.6 * std::pow(at.space, -2) - 0.2 * std::pow(at.time, -1);
  };
  const Posterior posterior(sampled(levels(), value), {2., 1.}, 0);
  EXPECT_NEAR(posterior.limit(), 3, 0.003);
  EXPECT_NEAR(*posterior.orders().space, 2, 0.1);
  EXPECT_NEAR(*posterior.orders().time, 1, 0.15);
}

TEST(AutomaticPosterior, KnowsAnOrderBelowTheory) {
  const auto value = [](const Resolution& at) { return 3 + 0.6 * std::pow(at.space, -0.7); };
  const Posterior posterior(sampled({{1, 1}, {2, 1}, {4, 1}, {8, 1}, {16, 1}}, value), {2., std::nullopt}, 0);
  EXPECT_NEAR(*posterior.orders().space, 0.7, 0.1);
  EXPECT_FALSE(posterior.orders().time.has_value());
  EXPECT_NEAR(posterior.limit(), 3, 0.02);
}

TEST(AutomaticPosterior, BoundIsTheToleranceOfItsChance) {
  const auto value = [](const Resolution& at) { return 3 + 0.6 / at.space - 0.2 / at.time; };
  const Posterior posterior(sampled(levels(), value), {1., 1.}, 0);
  const double bound = posterior.bound(3.1, 0.95);
  EXPECT_GE(posterior.chance_of(3.1, bound), 0.95);
  EXPECT_LT(posterior.chance_of(3.1, 0.98 * bound), 0.95);
  EXPECT_GT(bound, 0.1 / 3);
}

/// Errors of cells and steps that cancel along the diagonal make all its levels equal.
TEST(AutomaticPosterior, IsNotFooledByErrorsThatCancel) {
  const auto value = [](const Resolution& at) { return 3 + 0.6 / at.space - 0.6 / at.time; };
  const Posterior posterior(sampled({{1, 1}, {1, 2}, {2, 2}, {4, 4}}, value), {1., 1.}, 0);
  EXPECT_NEAR(posterior.limit(), 3, 0.01);
  EXPECT_FALSE(posterior.meets({1, 8}, 0.05, 0.1));  // there the cells' error stands alone
}

TEST(AutomaticPosterior, ScatterStaysInTheBound) {
  const auto value = [](const Resolution& at) { return 3 + 0.6 / at.space - 0.2 / at.time; };
  const auto samples = sampled(levels(), value);
  const Posterior sharp(samples, {1., 1.}, 0), scattered(samples, {1., 1.}, 0.05);
  EXPECT_GT(scattered.bound(3, 0.95), 3 * sharp.bound(3, 0.95));
  EXPECT_FALSE(scattered.meets({1e3, 1e3}, 0.01, 0.5));
}

/// The promise is kept: of random powers with random noise that falls with the cells, the finest value is within the
/// bound as often as is promised, and the bound is of the error's size.
TEST(AutomaticPosterior, KeepsItsPromise) {
  std::mt19937 random(7);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.);
  };
  int kept = 0, sharp = 0;
  const int cases = test::at_full_length() ? 400 : 100;
  for (int k = 0; k < cases; ++k) {
    const double p = uniform(1, 2.2), q = uniform(0.8, 2.2), a = uniform(-0.5, 0.5), b = uniform(-0.3, 0.3);
    const double noise = 0.1 * std::abs(a) * uniform(0, 1);
    const auto value = [&](const Resolution& at) {
      return 1 + a * std::pow(at.space, -p) + b * std::pow(at.time, -q) + noise * uniform(-1, 1) / at.space;
    };
    const auto samples = sampled(levels(), value);
    const double bound = Posterior(samples, second, 0).bound(samples.back().value, 0.95);
    const double error = std::abs(samples.back().value - 1);
    kept += error <= bound ? 1 : 0;
    sharp += bound < 0.1 ? 1 : 0;
  }
  EXPECT_GE(kept, cases * 93 / 100);  // 95 % less twice the deviation of 400 draws, or once that of 100
  EXPECT_GE(sharp, cases * 90 / 100);
}

/// Levels too coarse to follow any law do not spoil what finer ones say.
TEST(AutomaticPosterior, LetsCoarseLevelsBeWrong) {
  const auto value = [](const Resolution& at) {
    return at.space < 4 ? 1.7 : 3 + 0.6 * std::pow(at.space, -2) - 0.3 * std::pow(at.time, -2);
  };
  const std::vector<Resolution> at{{1, 1}, {1, 2}, {2, 2}, {4, 4}, {8, 8}, {8, 16}, {16, 16}, {32, 32}};
  const Posterior posterior(sampled(at, value), second, 0);
  EXPECT_NEAR(posterior.limit(), 3, 0.001);
  EXPECT_LT(posterior.bound(value({32, 32}), 0.97), 0.003);
  EXPECT_FALSE(posterior.meets({2, 32}, 0.1, 0.5));
}

TEST(AutomaticPosterior, ARunThatIsFinerSaysMore) {
  const auto value = [](const Resolution& at) { return 3 + 0.6 / at.space - 0.2 / at.time; };
  const Posterior posterior(sampled({{1, 1}, {1, 2}, {2, 2}}, value), {1., 1.}, 0);
  EXPECT_GT(posterior.informs({4, 4}), posterior.informs({1, 1}));
  EXPECT_LE(posterior.informs({4, 4}), 1);
  EXPECT_THROW(Posterior({}, second, 0), std::invalid_argument);
}

}  // namespace
}  // namespace tether::automatic
