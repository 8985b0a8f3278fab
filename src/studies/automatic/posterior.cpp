// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/automatic/posterior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>

namespace tether::automatic {
namespace {

constexpr std::array possible_orders{0.35, 0.5, 0.7, 0.85, 1., 1.2, 1.5, 1.75, 2., 2.5, 3., 4.};
constexpr std::array noise_orders{0., 1., 2.};
/// Sizes of the noise of the coarsest run, over the value: from what rounding leaves to what says nothing.
constexpr int noise_sizes = 12;
constexpr double least_noise = 3e-5, most_noise = 0.56;
/// What no regression resolves, over the value.
constexpr double rounding = 1e-6;

/// Levels that a law holds for at the least; and how far the value of one that it does not hold for is from others,
/// over the value: the width of Cauchy's distribution, which gives large distances their chance.
constexpr std::size_t levels_that_stay = 3;
constexpr double lawless_width = 0.2;
/// What such a run is expected to be off by, squared: its value.
constexpr double lawless_variance = 1;

/// How far orders stray from theory's: down where something is not smooth, up by superconvergence. The distribution is
/// Cauchy's, which gives far ones their chance.
constexpr double stray_down = 0.3, stray_up = 0.5;

// What is taken for likely before the first run: the limit is anywhere, and the coarsest run is off by about its value.
constexpr double limit_variance = 100, space_variance = 1, time_variance = 0.5;

/// The chance that a number is not smooth, as where waves have kinks: then its order is about 1 at the most, whatever
/// that of the cells.
constexpr double not_smooth = 0.2;

/// Hypotheses that weigh less, over the heaviest, are left out.
constexpr double least_weight = 1e-6;

double nearness(double order, double expected) {
  const double off = (order - expected) / (order > expected ? stray_up : stray_down);
  return 1 / (1 + off * off);
}

double log_nearness(double order, double theory) {
  return std::log((1 - not_smooth) * nearness(order, theory) + not_smooth * nearness(order, std::min(theory, 1.)));
}

double log_cauchy(double off, double width) {
  return -std::log(std::numbers::pi * width * (1 + off * off / (width * width)));
}

/// The chance that a Gaussian is within -width and width.
double gaussian_within(double mean, double deviation, double width) {
  const double unit = deviation * std::sqrt(2.);
  return 0.5 * (std::erf((width - mean) / unit) + std::erf((width + mean) / unit));
}

bool differ(std::span<const Sample> samples, double Resolution::*part) {
  return std::ranges::any_of(samples,
                             [&](const Sample& sample) { return sample.at.*part != samples.front().at.*part; });
}

/// Returns whether steps are in proportion to cells, since a limit cuts them: then errors of both are one.
bool follow_cells(std::span<const Sample> samples) {
  constexpr double slack = 1.02;
  const auto ratio = [](const Sample& sample) { return sample.at.time / sample.at.space; };
  const auto [least, most] = std::ranges::minmax(samples, {}, ratio);
  return ratio(most) < slack * ratio(least);
}

}  // namespace

Posterior::Posterior(std::span<const Sample> samples, const Orders& theory, double scatter) : scatter_(scatter) {
  if (samples.empty()) throw std::invalid_argument("a limit of no values");
  has_space_ = theory.space.has_value(), has_time_ = theory.time.has_value();
  in_space_ = has_space_ && differ(samples, &Resolution::space);
  in_time_ = has_time_ && differ(samples, &Resolution::time) && !(in_space_ && follow_cells(samples));
  scale_ = samples.back().value == 0 ? 1 : std::abs(samples.back().value);
  origin_ = samples.back().value / scale_;
  for (const double first_level : possible_first_levels(samples)) add_hypotheses(samples, theory, first_level);
  normalise();
}

/// The coarsest level, and those that have enough finer ones.
std::vector<double> Posterior::possible_first_levels(std::span<const Sample> samples) const {
  std::set<double> levels;
  for (const Sample& sample : samples) levels.insert(level_of(sample.at));
  std::vector<double> all(levels.begin(), levels.end());
  all.resize(all.size() > levels_that_stay ? all.size() - levels_that_stay + 1 : 1);
  return all;
}

/// The least of cells and steps, each, of the samples that follow the law.
Resolution Posterior::coarsest_lawful(std::span<const Sample> samples, double first_level) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Resolution coarsest{infinity, infinity};
  for (const Sample& sample : samples) {
    if (level_of(sample.at) < first_level) continue;
    coarsest.space = std::min(coarsest.space, sample.at.space);
    coarsest.time = std::min(coarsest.time, sample.at.time);
  }
  return coarsest;
}

void Posterior::add_hypotheses(std::span<const Sample> samples, const Orders& theory, double first_level) {
  const Resolution coarsest = coarsest_lawful(samples, first_level);
  const std::size_t ps = in_space_ ? possible_orders.size() : 1, qs = in_time_ ? possible_orders.size() : 1;
  for (std::size_t i = 0; i < ps; ++i) {
    for (std::size_t j = 0; j < qs; ++j) {
      for (const double noise_order : noise_orders) {
        for (int k = 0; k < noise_sizes; ++k) {
          const double part = static_cast<double>(k) / (noise_sizes - 1);
          Hypothesis h{.p = possible_orders[i],
                       .q = possible_orders[j],
                       .noise = least_noise * std::pow(most_noise / least_noise, part),
                       .noise_order = noise_order,
                       .first_level = first_level,
                       .coarsest = coarsest};
          regress(h, samples, theory);
          hypotheses_.push_back(std::move(h));
        }
      }
    }
  }
}

Posterior::Terms Posterior::basis(const Hypothesis& h, const Resolution& at) const {
  Terms x(1 + (in_space_ ? 1 : 0) + (in_time_ ? 1 : 0));
  int k = 0;
  x[k++] = 1;
  if (in_space_) x[k++] = std::exp(-h.p * std::log(at.space / h.coarsest.space));
  if (in_time_) x[k++] = std::exp(-h.q * std::log(at.time / h.coarsest.time));
  return x;
}

bool Posterior::is_lawless(const Hypothesis& h, const Resolution& at) const { return level_of(at) < h.first_level; }

double Posterior::noise_variance(const Hypothesis& h, const Resolution& at) const {
  if (is_lawless(h, at)) return lawless_variance;
  const double space = at.space / h.coarsest.space, time = at.time / h.coarsest.time;
  const double finer = has_space_ && has_time_ ? std::sqrt(space * time) : has_space_ ? space : time;
  const double noise = h.noise * std::pow(finer, -h.noise_order);
  return noise * noise + scatter_ * scatter_ + rounding * rounding;
}

Posterior::Terms Posterior::prior_variances() const {
  Terms variances(1 + (in_space_ ? 1 : 0) + (in_time_ ? 1 : 0));
  int k = 0;
  variances[k++] = limit_variance;
  if (in_space_) variances[k++] = space_variance;
  if (in_time_) variances[k++] = time_variance;
  return variances;
}

/// The likelihood is that of the values with Q, a and b integrated out: with A = X^T W X + P^-1 and b = X^T W y it is
/// exp(-(y^T W y - b^T A^-1 b)/2) / sqrt(|W^-1| |P| |A|).
void Posterior::regress(Hypothesis& h, std::span<const Sample> samples, const Orders& theory) const {
  const Terms prior = prior_variances();
  Square A = prior.cwiseInverse().asDiagonal();
  Terms b = Terms::Zero(prior.size());
  double square = 0, log_weight = -0.5 * prior.array().log().sum();
  for (const Sample& sample : samples) {
    const double y = sample.value / scale_ - origin_;
    if (is_lawless(h, sample.at)) {
      log_weight += log_cauchy(y, lawless_width);
      continue;
    }
    const Terms x = basis(h, sample.at);
    const double variance = noise_variance(h, sample.at);
    A += x * x.transpose() / variance;
    b += x * (y / variance);
    square += y * y / variance;
    log_weight -= 0.5 * std::log(2 * std::numbers::pi * variance);
  }
  h.covariance = A.inverse();
  h.mean = h.covariance * b;
  log_weight -= 0.5 * (square - b.dot(h.mean)) + 0.5 * std::log(A.determinant());
  if (in_space_) log_weight += log_nearness(h.p, *theory.space);
  if (in_time_) log_weight += log_nearness(h.q, *theory.time);
  h.weight = log_weight;
}

void Posterior::normalise() {
  double most = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const Hypothesis& h : hypotheses_) most = std::max(most, h.weight);
  for (Hypothesis& h : hypotheses_) h.weight = std::exp(h.weight - most);
  std::erase_if(hypotheses_, [](const Hypothesis& h) { return !(h.weight > least_weight); });
  std::ranges::stable_sort(hypotheses_, std::ranges::greater(), &Hypothesis::weight);
  for (const Hypothesis& h : hypotheses_) sum += h.weight;
  double p = 0, q = 0;
  for (Hypothesis& h : hypotheses_) {
    h.weight /= sum;
    limit_ += h.weight * (h.mean[0] + origin_) * scale_;
    p += h.weight * h.p, q += h.weight * h.q;
  }
  if (in_space_) orders_.space = p;
  if (in_time_) orders_.time = q;
}

double Posterior::chance_at(const Hypothesis& h, const Resolution& at, double tolerance) const {
  Terms x = basis(h, at);
  x[0] = 0;  // the error alone: what it has on top of the limit
  const double variance = x.dot(h.covariance * x) + noise_variance(h, at);
  return gaussian_within(x.dot(h.mean), std::sqrt(variance), tolerance * std::abs(h.mean[0] + origin_));
}

bool Posterior::meets(const Resolution& at, double tolerance, double promised) const {
  double chance = 0, left = 1;
  for (const Hypothesis& h : hypotheses_) {
    left -= h.weight;
    chance += h.weight * chance_at(h, at, tolerance);
    if (chance >= promised) return true;
    if (chance + left < promised) return false;
  }
  return false;
}

double Posterior::chance_of(double value, double tolerance) const {
  double chance = 0;
  for (const Hypothesis& h : hypotheses_) {
    const double off = value / scale_ - origin_ - h.mean[0], variance = h.covariance(0, 0) + rounding * rounding;
    chance += h.weight * gaussian_within(off, std::sqrt(variance), tolerance * std::abs(h.mean[0] + origin_));
  }
  return chance;
}

double Posterior::bound(double value, double chance) const {
  double low = rounding, high = 1e6;
  if (chance_of(value, high) < chance) return std::numeric_limits<double>::infinity();
  while (high > 1.001 * low) {
    const double middle = std::sqrt(low * high);
    (chance_of(value, middle) < chance ? low : high) = middle;
  }
  return high;
}

double Posterior::informs(const Resolution& at) const {
  double mean_q = 0, mean_y = 0, qq = 0, qy = 0, yy = 0;
  for (const Hypothesis& h : hypotheses_) {
    const Terms x = basis(h, at), covariances = h.covariance * x;
    const double y = x.dot(h.mean), q = h.mean[0];
    mean_q += h.weight * q, mean_y += h.weight * y;
    qq += h.weight * (h.covariance(0, 0) + q * q);
    qy += h.weight * (covariances[0] + q * y);
    yy += h.weight * (x.dot(covariances) + noise_variance(h, at) + y * y);
  }
  const double var_q = qq - mean_q * mean_q, var_y = yy - mean_y * mean_y, cov = qy - mean_q * mean_y;
  return var_q > 0 && var_y > 0 ? std::min(1., cov * cov / (var_q * var_y)) : 0;
}

}  // namespace tether::automatic
